// Keeps the daemon's state in its file: brought back at the start, saved when it has
// changed, and at the end. Changes are looked for once in a period; a flag or another DTC
// and a parameter (wire::urgent_bytes) are saved as soon as the budget has a write, the
// rest when it has more than enough (write_budget.hpp).
//
// The samples in the windows are kept beside it, at the end; while the daemon runs only
// those of loops so slow that a window which was written a minute or two ago can still go
// on (kSlow_s), less often where that would be more than kMostDaily bytes a day: faster
// loops would find a gap anyway.
//
// A file that is missing, damaged or of another version is told, set aside, and the
// daemon starts afresh; one that cannot be written is told once, counted, and tried
// again, after a period, then after twice as long each time, up to a minute. One thread
// beside its own (state_file.hpp); no heap after restore().
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "config/gateway.hpp"
#include "firmware/daemon.hpp"
#include "firmware/log.hpp"
#include "firmware/state_file.hpp"
#include "firmware/write_budget.hpp"

namespace firmware {

class StateKeeper {
 public:
  /// `log` outlives this object.
  StateKeeper(const config::Gateway& gateway, Log& log);

  /// False: another process has the file.
  [[nodiscard]] bool lock() { return file_.lock(); }
  /// Before the first step of `daemon`.
  void restore(Daemon& daemon, const Now& now);
  /// At every turn.
  void keep(Daemon& daemon, const Now& now, WriteBudget& budget);
  /// Waits until nothing is being written any more.
  void settle() { file_.settle(); }
  /// At the end: waits until the files are written.
  void finish(Daemon& daemon, const Now& now);

  /// Times that the state or the windows were written, or could not be.
  [[nodiscard]] std::uint32_t writes() const { return file_.writes(); }
  [[nodiscard]] std::uint32_t failures() const { return file_.failures(); }

 private:
  static constexpr std::int64_t kMinute_us = 60'000'000;
  static constexpr double kSlow_s = 20;
  static constexpr double kMostDaily = 64.0 * 1024 * 1024;

  /// Checksums of an image: of what is urgent, and of all.
  struct Checksums {
    std::uint32_t urgent = 0;
    std::uint32_t all = 0;
  };
  [[nodiscard]] static Checksums checksums(std::span<const std::uint8_t> image,
                                           std::size_t loops);
  /// How urgently the state of `daemon`, in image_ then, is to be saved.
  [[nodiscard]] Haste haste_of(const Daemon& daemon);
  /// Hands it over; false: the one before is still being written.
  bool save(const Daemon& daemon);

  void restore_state(Daemon& daemon, const Now& now);
  void restore_windows(Daemon& daemon, const Now& now);
  void tell_failure(std::int64_t now_us, const char* consequence);
  /// Tells of what could not be written since.
  void take_failures(std::int64_t now_us, WriteBudget& budget);
  void keep_state(const Daemon& daemon, std::int64_t now_us, WriteBudget& budget);
  void keep_windows(Daemon& daemon, const Now& now, WriteBudget& budget);
  /// Those of loops with that sample period or more; what was handed over, bytes.
  std::size_t save_windows(Daemon& daemon, const Now& now, double least_period_s);

  StateFile file_;
  Log& log_;
  std::string sysfs_root_;
  std::int64_t period_us_;
  bool slow_;  // there are loops of kSlow_s
  std::int64_t next_us_ = 0;
  std::int64_t pause_us_;  // until then
  Haste haste_ = Haste::kNone;
  std::uint32_t writes_ = 0;    // that are known
  std::uint32_t failures_ = 0;  // of them
  bool failing_ = false;
  std::array<std::uint8_t, wire::kMostStateBytes> image_;
  std::size_t size_ = 0;
  Checksums saved_;              // of the image saved last
  std::int64_t samples_us_ = 0;  // when those of slow loops are due
};

}  // namespace firmware
