// Keeps the daemon's state in its file: brought back at the start, saved when it has
// changed, at most once in a period, and at the end.
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
  void restore(Daemon& daemon, std::int64_t now_us);
  /// At every turn.
  void keep(const Daemon& daemon, std::int64_t now_us);
  /// At the end: waits until the file is written.
  void finish(const Daemon& daemon);

  [[nodiscard]] std::uint32_t failures() const { return file_.failures(); }

 private:
  /// The state of `daemon` if it is not what was saved last; else empty.
  [[nodiscard]] std::span<const std::uint8_t> news(const Daemon& daemon);
  void remember(std::span<const std::uint8_t> image);

  StateFile file_;
  Log& log_;
  std::int64_t period_us_;
  std::int64_t next_us_ = 0;
  std::uint32_t failures_ = 0;  // that were told
  bool failing_ = false;
  std::array<std::uint8_t, wire::kMostStateBytes> image_;
  std::array<std::uint8_t, 4> saved_{};  // checksum at the end of the image saved last
};

}  // namespace firmware
