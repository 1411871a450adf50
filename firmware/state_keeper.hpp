// Keeps the daemon's state in its file: brought back at the start, saved when it has
// changed, at most once in a period, and at the end. When only the windows have moved on
// (wire::urgent_bytes), it is saved once a minute at most.
//
// The samples in the windows are kept beside it, at the end; while the daemon runs only
// those of loops so slow that a window which was written a minute ago can still go on
// (kSlow_s), once a minute at most, and less often where that would be more than
// kMostDaily bytes a day: faster loops would find a gap anyway.
//
// A file that is missing, damaged or of another version is told, set aside, and the
// daemon starts afresh; one that cannot be written is told once, counted, and tried
// again. One thread beside its own (state_file.hpp); no heap after restore().
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "config/gateway.hpp"
#include "firmware/daemon.hpp"
#include "firmware/log.hpp"
#include "firmware/state_file.hpp"

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
  void keep(Daemon& daemon, const Now& now);
  /// At the end: waits until the files are written.
  void finish(Daemon& daemon, const Now& now);

  [[nodiscard]] std::uint32_t failures() const { return file_.failures(); }

 private:
  static constexpr std::int64_t kWindows_us = 60'000'000;
  static constexpr double kSlow_s = 20;
  static constexpr double kMostDaily = 64.0 * 1024 * 1024;

  /// Checksums of an image: of what is urgent, and of all.
  struct Checksums {
    std::uint32_t urgent = 0;
    std::uint32_t all = 0;
  };
  [[nodiscard]] static Checksums checksums(std::span<const std::uint8_t> image,
                                           std::size_t loops);
  /// The state of `daemon` if it is not what was saved last; else empty. `all`: windows
  /// count, too.
  [[nodiscard]] std::span<const std::uint8_t> news(const Daemon& daemon, bool all);

  void restore_state(Daemon& daemon, const Now& now);
  void restore_windows(Daemon& daemon, const Now& now);
  void keep_state(const Daemon& daemon, std::int64_t now_us);
  /// Those of loops with that sample period or more; what was handed over, bytes.
  std::size_t save_windows(Daemon& daemon, const Now& now, double least_period_s);

  StateFile file_;
  Log& log_;
  std::string sysfs_root_;
  std::int64_t period_us_;
  std::int64_t next_us_ = 0;
  std::uint32_t failures_ = 0;  // that were told
  bool failing_ = false;
  std::array<std::uint8_t, wire::kMostStateBytes> image_;
  Checksums saved_;              // of the image saved last
  std::int64_t windows_us_ = 0;  // when those alone are saved next
  std::int64_t samples_us_ = 0;  // when those of slow loops are
};

}  // namespace firmware
