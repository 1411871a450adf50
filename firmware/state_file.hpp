// The files that keep what the gateway knows over a restart: its state, and beside it, as
// path.windows, the samples that its windows hold.
//
// save() only hands over a copy: a thread writes it, waits for the disk, renames it. The
// caller, who also has frames to read, never waits. Windows are laid out where the thread
// takes them from; it adds their CRC-32. Life: new (a thread is started, which takes no
// signals if the caller has blocked them) → read, once → save … → finish. No heap after
// construction but by read. Memory: an image of the state, one of the windows, the stack
// of the thread.
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
#include "wire/state_image.hpp"

namespace firmware {

class StateFile {
 public:
  /// `windows`: most bytes of their image.
  explicit StateFile(std::string path, std::size_t windows = 0);

  /// Takes the file for this process, by a lock on path.lock, until the object is gone,
  /// and removes what a crash left of a write. False: another one has it.
  [[nodiscard]] bool lock();
  /// The file as it is; `exists` tells one that is empty from none. False when it cannot
  /// be read (errno says why). What is longer than a state is cut off after one byte
  /// more.
  [[nodiscard]] bool read(std::vector<std::uint8_t>& out, bool& exists) const;
  /// The same for the windows.
  [[nodiscard]] bool read_windows(std::vector<std::uint8_t>& out, bool& exists) const;
  /// Renames a file that is no state to path.bad, so that the next one does not replace
  /// it.
  void set_aside() const;
  void set_windows_aside() const;
  /// Begins to write `image`; false while the one before is still being written.
  [[nodiscard]] bool save(std::span<const std::uint8_t> image);
  /// Where the next image of the windows is laid out; empty while one is being written.
  [[nodiscard]] std::span<std::uint8_t> room_for_windows();
  /// Begins to write `size` bytes of it and their CRC-32, for which there is room.
  void save_windows(std::size_t size);
  /// A state is being written.
  [[nodiscard]] bool saving() const;
  /// Waits until nothing is being written any more.
  void settle();

  /// Times that a file was written, or could not be.
  [[nodiscard]] std::uint32_t writes() const;
  /// Times that writing failed.
  [[nodiscard]] std::uint32_t failures() const;
  /// errno of the newest failure; 0 before any.
  [[nodiscard]] int error() const;
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const std::string& windows_path() const { return windows_path_; }

 private:
  void work(const std::stop_token& stop);
  /// Of windows, before they are written; the bytes of the file.
  [[nodiscard]] std::size_t add_checksum(std::size_t size);

  std::string path_;
  std::string windows_path_;
  hal::Descriptor lock_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::array<char, wire::kMostStateBytes> image_;
  std::size_t size_ = 0;  // > 0: to be written, or being written
  std::vector<std::uint8_t> windows_;
  std::size_t windows_size_ = 0;  // the same of them, without their CRC-32
  std::uint32_t writes_ = 0;
  std::uint32_t failures_ = 0;
  int error_ = 0;
  std::jthread thread_;  // last: it uses the others
};

}  // namespace firmware
