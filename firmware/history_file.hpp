// The file that keeps what windows said, for years, in a size that is fixed: for each
// loop four rings of rows (wire/history_row.hpp), the newer the denser.
//
//   ring 0  every window                  1,024 rows
//   ring 1  an hour apart, or more        1,440        60 days
//   ring 2  six hours apart, or more      1,600       400 days
//   ring 3  a day apart, or more          1,840         5 years
//
// 184.5 KiB a loop, in any year. A header of 4 KiB: "SBHF", version u8 = 1, three zeros,
// for each loop 1 … 31 its tag (32 bytes, zero-padded) and the CRC-32 of its
// configuration, then the CRC-32 of all that. Rows are written over the oldest ones in
// place; a power cut damages at most those that were being written, which their CRC
// tells, so that nothing has to be repaired. A loop with another tag begins anew; with
// the same tag and another configuration it gets a mark (verdict 0).
//
// Life: open → rows → add … write … → finish. add() only queues: a thread writes when
// write() says so, and waits for the disk. No heap after open(). Memory: two queues of
// kQueue rows, 40 KB.
#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <span>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "hal/descriptor.hpp"
#include "wire/history_row.hpp"

namespace firmware {

/// A loop as the history knows it.
struct HistoryLoop {
  int id = 0;  ///< 1 … 31
  std::string tag;
  std::uint32_t configuration = 0;  ///< CRC-32
};

struct HistoryRing {
  std::size_t rows;
  std::uint32_t apart_s;  ///< at least
};
inline constexpr std::array<HistoryRing, 4> kHistoryRings = {
    {{1024, 0}, {1440, 3'600}, {1600, 21'600}, {1840, 86'400}}};
inline constexpr std::size_t kHistoryRows = 1024 + 1440 + 1600 + 1840;
inline constexpr std::size_t kHistoryHeader = 4096;
inline constexpr std::size_t kHistoryLoopBytes = kHistoryRows * wire::kHistoryRowBytes;
static_assert(kHistoryLoopBytes <= std::size_t{256} * 1024);

class HistoryFile {
 public:
  static constexpr std::size_t kQueue = 512;

  enum class Opened : std::uint8_t {
    kGood,
    kNew,      ///< there was none
    kDamaged,  ///< the header was; kept as path.bad, begun anew
    kTaken,    ///< another process has it
    kFailed,   ///< errno says why
  };

  explicit HistoryFile(std::string path);

  /// Before all else; once. Takes the file for this process.
  [[nodiscard]] Opened open(std::span<const HistoryLoop> loops);
  /// The same for reading alone: nobody is kept from it. False: errno says why, or 0 when
  /// it is no history.
  [[nodiscard]] bool open_to_read();
  /// The loops of the header that have a tag.
  [[nodiscard]] std::vector<HistoryLoop> loops() const;
  /// The rows of a loop that are in the file, by time, each window once.
  [[nodiscard]] std::vector<wire::HistoryRow> rows(int loop) const;
  /// Queues a row. A full queue loses it (counted).
  void add(int loop, wire::HistoryRow row);
  /// Rows that are queued.
  [[nodiscard]] std::size_t queued() const { return queue_.size; }
  /// Begins to write them all, as one write; false: those before are still being written.
  bool write();
  /// Waits until nothing is being written any more.
  void settle();
  /// Writes what is queued and waits for it.
  void finish();

  /// Bytes `offset` … of the rings of a loop, as they lie in the file; zeros where that
  /// cannot be read.
  void read(int loop, std::size_t offset, std::span<std::uint8_t> out) const;
  /// Times that rows were written, and waited for; with those that failed.
  [[nodiscard]] std::uint32_t writes() const;
  /// Times that writing failed, and rows that were lost.
  [[nodiscard]] std::uint32_t failures() const;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  struct Ring {
    std::size_t next = 0;  // row to be written
    std::uint16_t sequence = 0;
    std::uint32_t newest_s = 0;
    bool empty = true;
  };
  struct Pending {
    std::int64_t offset = 0;
    std::array<std::uint8_t, wire::kHistoryRowBytes> bytes{};
  };
  struct Queue {
    std::array<Pending, kQueue> rows;
    std::size_t size = 0;
  };

  [[nodiscard]] bool read_header();
  /// Unless it is there already.
  [[nodiscard]] bool write_header();
  [[nodiscard]] bool clear(int loop) const;
  /// Has the disk set that many bytes aside.
  void reserve(std::int64_t size) const;
  void find_ends(int loop);
  void hand_over();
  void work(const std::stop_token& stop);
  [[nodiscard]] bool write_rows(const Queue& queue) const;

  std::string path_;
  hal::Descriptor file_;
  std::array<HistoryLoop, wire::kMostLoops> known_;
  std::array<std::array<Ring, kHistoryRings.size()>, wire::kMostLoops> rings_{};
  Queue queue_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  Queue writing_;  // of the thread while busy_
  bool busy_ = false;
  std::uint32_t writes_ = 0;
  std::uint32_t failures_ = 0;
  std::uint32_t lost_ = 0;
  std::jthread thread_;  // last: it uses the others
};

}  // namespace firmware
