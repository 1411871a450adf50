// The inputs of one loop: from frames and readings to samples that can be believed.
//
// A value is used if it is finite, inside its range and, for a 4–20 mA signal, not in a
// failure state (hal/ne43.hpp); u, y and sp also within 10⁹ times their span, whatever
// their range. What is refused is counted and makes the input uncertain for a while, and
// so does a second sender of a signal whose sender the configuration leaves open: of
// these the one that was heard first is used (a device with a new address is heard only
// once the old one is silent). A u or y that stays far outside its span is out of range
// (span_reach.hpp). While the loop is not in automatic mode, while u or y has no usable
// value for stale_after_s, or while the alive counter stands still that long, there are
// no samples.
//
// Life: new → take_*, in order of time; before each, next until it is false. One thread;
// no heap after construction, no clock. Cost: constant.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "config/gateway.hpp"
#include "firmware/resampler.hpp"
#include "firmware/span_reach.hpp"
#include "hal/ne43.hpp"
#include "ident/signal/sample_window.hpp"
#include "wire/diagnostics.hpp"

namespace firmware {

/// What a source is to its loop.
enum class Role : std::uint8_t { kU, kY, kSp, kMode, kAlive };
inline constexpr std::size_t kRoles = 5;

/// Its key in the configuration.
[[nodiscard]] const char* name_of(Role role);

/// u or y that is out of the reach of its span.
struct FarSignal {
  Role role = Role::kU;
  double value = wire::kNotAvailable;  ///< newest one that was far
};

/// u or y whose values come more seldom than samples are taken.
struct SlowSignal {
  Role role = Role::kU;
  double interval_s = 0;
};

/// A signal that two devices send, where the configuration does not name its sender.
struct TwoSenders {
  Role role = Role::kU;
  std::uint8_t used = 0;   ///< source address
  std::uint8_t other = 0;  ///< newest one that was not used
};

/// The sources of a loop by role; nullptr: not configured.
[[nodiscard]] std::array<const config::Source*, kRoles> sources_of(
    const config::Loop& loop);
/// The one of a role.
[[nodiscard]] const config::Source* source_of(const config::Loop& loop, Role role);

class LoopInput {
 public:
  /// `loop` outlives this object.
  explicit LoopInput(const config::Loop& loop);

  /// Takes a frame that carries the signal of `role`; others are ignored.
  void take_frame(Role role, std::int64_t t_us, const wire::CanFrame& frame);
  /// Takes a reading in mV or mA; with `ok` false the device did not answer.
  void take_reading(Role role, std::int64_t t_us, bool ok, double reading);
  /// Frames for this loop were lost before they were read.
  void take_drops(std::int64_t t_us, std::uint32_t count);

  /// Before the first value: a sample of `newest_us` was the newest, shortly before.
  void resume(std::int64_t newest_us) { resampler_.resume(newest_us); }
  /// The next sample that is due at or before `until_us` and can be used.
  [[nodiscard]] bool next(std::int64_t until_us, ident::Sample<float>& out);

  /// Without what only the monitor sees (frozen, clipped).
  [[nodiscard]] wire::InputStatus status(std::int64_t now_us);
  [[nodiscard]] wire::LoopMode mode() const { return mode_; }
  /// Newest usable value; NaN before the first.
  [[nodiscard]] double live(Role role) const;
  /// The one that status() calls out of range for its span; of two, u.
  [[nodiscard]] std::optional<FarSignal> far_signal() const;
  /// The slower one of those, as soon as it is known.
  [[nodiscard]] std::optional<SlowSignal> slow_signal() const;
  /// The first of the roles, as soon as it is known.
  [[nodiscard]] std::optional<TwoSenders> two_senders() const;
  [[nodiscard]] const wire::InputCounters& counters() const { return counters_; }

 private:
  struct Signal {
    const config::Source* source = nullptr;
    std::optional<hal::Ne43> current;
    std::optional<SpanReach> reach;
    hal::CurrentState state = hal::CurrentState::kGood;
    double value = wire::kNotAvailable;
    std::int64_t usable_us = 0;  // of value, or of the first call
    std::int64_t alive_us = 0;   // last change of an alive counter
    bool out_of_range = false;   // the newest one was
    bool any = false;
    std::optional<std::uint8_t> sender;  // where any may be
    std::optional<std::uint8_t> other_sender;
    bool two_senders = false;  // that one was heard between two frames of `sender`
  };

  void take_value(Role role, std::int64_t t_us, double value);
  void take_checked(Role role, std::int64_t t_us, double value);
  void refuse_value(Role role, std::int64_t t_us);
  [[nodiscard]] bool is_from_another(Role role, std::int64_t t_us,
                                     const wire::CanFrame& frame);
  [[nodiscard]] bool is_beyond(Role role, double value) const;
  [[nodiscard]] bool is_possible(Role role, double value) const;
  void start_clock(std::int64_t t_us);
  [[nodiscard]] Signal& signal(Role role) { return signals_[static_cast<int>(role)]; }
  [[nodiscard]] bool overdue(const Signal& s, std::int64_t now_us) const;
  [[nodiscard]] bool failing(const Signal& s) const;
  [[nodiscard]] bool suspended(std::int64_t now_us);

  const config::Loop& loop_;
  std::int64_t period_us_;
  std::int64_t stale_after_us_;
  Resampler resampler_;
  std::array<Signal, kRoles> signals_;
  wire::InputCounters counters_;
  wire::LoopMode mode_ = wire::LoopMode::kUnknown;
  std::int64_t uncertain_until_us_ = 0;
  bool started_ = false;
  bool missing_ = false;
};

}  // namespace firmware
