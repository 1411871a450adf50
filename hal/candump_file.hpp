// A recorded CAN log (`candump -l` or `-L`, or its screen with times) as a bus.
#pragma once

#include <string>
#include <vector>

#include "hal/can_bus.hpp"
#include "hal/clock.hpp"
#include "hal/message.hpp"
#include "wire/candump_reader.hpp"

namespace hal {

enum class ReplayPace : unsigned char {
  kRealTime,  ///< a frame comes as long after the first as in the log, stamped so
  kFast,      ///< frames come as fast as they are read, stamped as in the log
};

/// Reads the whole log at open(); frames sent are discarded. Lines of CAN XL are passed
/// over and counted as drops; a last line that was cut is left out.
class CandumpFile final : public CanBus {
 public:
  static constexpr std::size_t kMaxBytes = std::size_t{512} << 20;

  /// `interface`: only its lines; empty: all.
  CandumpFile(std::string path, std::string interface, ReplayPace pace,
              const Clock& clock);

  /// False also for a line that is not one of candump: error() names line and column.
  [[nodiscard]] bool open() override;
  /// kEnded after the last frame, and at a line that is none.
  [[nodiscard]] CanStatus read(std::span<ReceivedFrame> out, std::size_t& count) override;
  [[nodiscard]] CanStatus write(const wire::CanFrame& frame) override;
  [[nodiscard]] int descriptor() const override { return -1; }
  [[nodiscard]] std::uint64_t drops() const override { return drops_; }
  [[nodiscard]] const char* error() const override { return error_.c_str(); }
  /// The interfaces of the whole log, in the order of their first lines. Reads all of it.
  [[nodiscard]] std::vector<std::string> interfaces() const;
  /// Whether reading ended at a line that is none, which error() tells.
  [[nodiscard]] bool failed() const { return failed_; }
  /// Number of the last line where it was cut and left out; 0: it was not, so far.
  [[nodiscard]] std::size_t cut_line() const { return log_.cut_line(); }

 private:
  bool next(ReceivedFrame& out);

  std::string path_;
  std::string interface_;
  ReplayPace pace_;
  const Clock& clock_;
  std::string text_;
  wire::CandumpReader log_;  // of the text
  bool failed_ = false;
  bool pending_ = false;
  ReceivedFrame next_;
  std::int64_t log_start_us_ = -1;
  std::int64_t real_start_us_ = 0;
  std::uint64_t drops_ = 0;
  Message error_;
};

}  // namespace hal
