// Keeps the daemon's state in its file: brought back at the start, saved when it has
// changed, at most once in a period, and at the end. When only the windows have moved on
// (wire::urgent_bytes), it is saved once a minute at most.
//
// A file that is missing, damaged or of another version is told, set aside, and the
// daemon starts afresh; one that cannot be written is told once, counted, and tried
// again. One thread beside its own (state_file.hpp); no heap after restore().
#pragma once

#include <array>
#include <cstdint>

#include "config/gateway.hpp"
#include "firmware/daemon.hpp"
#include "firmware/log.hpp"
#include "firmware/state_file.hpp"

namespace firmware {

class StateKeeper {
 public:
  /// `log` outlives this object.
  StateKeeper(const config::State& settings, Log& log);

  /// False: another process has the file.
  [[nodiscard]] bool lock() { return file_.lock(); }
  /// Before the first step of `daemon`.
  void restore(Daemon& daemon, const Now& now);
  /// At every turn.
  void keep(const Daemon& daemon, std::int64_t now_us);
  /// At the end: waits until the file is written.
  void finish(const Daemon& daemon);

  [[nodiscard]] std::uint32_t failures() const { return file_.failures(); }

 private:
  static constexpr std::int64_t kWindows_us = 60'000'000;

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

  StateFile file_;
  Log& log_;
  std::int64_t period_us_;
  std::int64_t next_us_ = 0;
  std::uint32_t failures_ = 0;  // that were told
  bool failing_ = false;
  std::array<std::uint8_t, wire::kMostStateBytes> image_;
  Checksums saved_;              // of the image saved last
  std::int64_t windows_us_ = 0;  // when those alone are saved next
};

}  // namespace firmware
