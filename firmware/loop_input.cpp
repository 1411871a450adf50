#include "firmware/loop_input.hpp"

#include <algorithm>
#include <cmath>

#include "wire/j1939.hpp"

namespace firmware {
namespace {

constexpr int kUncertainPeriods = 60;  // after a drop or a refused value
// No choice of units puts a value farther out; one alone would swamp the window in
// single precision (24 bits).
constexpr double kMostSpans = 1e9;

std::int64_t microseconds(double seconds) {
  return std::llround(seconds * 1e6);
}

hal::Ne43Limits limits_of(const config::CurrentLimits& limits) {
  return {limits.failure_low_ma, limits.saturated_low_ma, limits.saturated_high_ma,
          limits.failure_high_ma, microseconds(limits.debounce_s)};
}

}  // namespace

const char* name_of(Role role) {
  constexpr std::array<const char*, kRoles> kNames = {"u", "y", "sp", "mode", "alive"};
  return kNames[static_cast<std::size_t>(role)];
}

std::array<const config::Source*, kRoles> sources_of(const config::Loop& loop) {
  const auto pointer = [](const std::optional<config::Source>& source) {
    return source ? &*source : nullptr;
  };
  return {&loop.u, &loop.y, pointer(loop.sp), pointer(loop.mode), pointer(loop.alive)};
}

const config::Source* source_of(const config::Loop& loop, Role role) {
  return sources_of(loop)[static_cast<std::size_t>(role)];
}

LoopInput::LoopInput(const config::Loop& loop)
    : loop_(loop),
      period_us_(microseconds(loop.sample_period_s)),
      stale_after_us_(microseconds(loop.stale_after_s)),
      resampler_(period_us_, stale_after_us_) {
  for (std::size_t k = 0; k < kRoles; ++k) {
    Signal& s = signals_[k];
    s.source = sources_of(loop)[k];
    if (s.source && s.source->ne43) s.current.emplace(limits_of(s.source->limits));
  }
  signal(Role::kU).reach.emplace(loop.span, stale_after_us_);
  // A span of y that nobody gave says nothing about its unit.
  if (loop.has_y_span) signal(Role::kY).reach.emplace(loop.y_span, stale_after_us_);
}

void LoopInput::start_clock(std::int64_t t_us) {
  if (started_) return;
  started_ = true;
  for (Signal& s : signals_) s.usable_us = s.alive_us = t_us;
  uncertain_until_us_ = t_us;
}

void LoopInput::refuse_value(Role role, std::int64_t t_us) {
  ++counters_.refused_values;
  signal(role).out_of_range = true;
  uncertain_until_us_ = t_us + kUncertainPeriods * period_us_;
}

bool LoopInput::is_possible(Role role, double value) const {
  if (role != Role::kU && role != Role::kY && role != Role::kSp) return true;
  const std::array<double, 2>& span = role == Role::kU ? loop_.span : loop_.y_span;
  const double widest =
      std::max({std::abs(span[0]), std::abs(span[1]), span[1] - span[0]});
  return std::abs(value) <= kMostSpans * widest;
}

void LoopInput::take_value(Role role, std::int64_t t_us, double value) {
  start_clock(t_us);
  Signal& s = signal(role);
  if (s.reach) s.reach->take(t_us, value);
  if (!is_possible(role, value)) return refuse_value(role, t_us);
  if (role == Role::kAlive && (!s.any || value != s.value)) s.alive_us = t_us;
  s.any = true;
  s.out_of_range = false;
  s.value = value;
  s.usable_us = t_us;
  if (role == Role::kU || role == Role::kY || role == Role::kSp) {
    resampler_.take(static_cast<Channel>(role), t_us, value);
  } else if (role == Role::kMode) {
    const auto& automatic = loop_.auto_values;
    const bool on = std::ranges::find(automatic, value) != automatic.end();
    mode_ = on ? wire::LoopMode::kAutomatic : wire::LoopMode::kManual;
  }
}

bool LoopInput::is_from_another(Role role, std::int64_t t_us,
                                const wire::CanFrame& frame) {
  using wire::j1939::kSourceAddress;
  Signal& s = signal(role);
  if ((s.source->signal.ignored & kSourceAddress) != kSourceAddress) return false;
  const auto address = static_cast<std::uint8_t>(frame.id & kSourceAddress);
  const bool may_follow = !s.two_senders && s.sender && overdue(s, t_us);
  if (!s.sender || may_follow) {
    s.sender = address;
    s.other_sender.reset();
  }
  if (*s.sender == address) {
    s.two_senders = s.two_senders || s.other_sender;
    return false;
  }
  s.other_sender = address;
  ++counters_.refused_values;
  uncertain_until_us_ = t_us + kUncertainPeriods * period_us_;
  return true;
}

// Farther outside the span than the span is wide.
bool LoopInput::is_beyond(Role role, double value) const {
  const bool of_y = role == Role::kY || role == Role::kSp;
  if (role != Role::kU && !(of_y && loop_.has_y_span)) return false;
  const std::array<double, 2>& span = of_y ? loop_.y_span : loop_.span;
  const double width = span[1] - span[0];
  return value < span[0] - width || value > span[1] + width;
}

void LoopInput::take_frame(Role role, std::int64_t t_us, const wire::CanFrame& frame) {
  Signal& s = signal(role);
  double value = 0;
  const wire::SignalError error = wire::extract(s.source->signal, frame, value);
  if (error == wire::SignalError::kOtherFrame ||
      error == wire::SignalError::kNotSelected) {
    return;
  }
  start_clock(t_us);
  ++counters_.frames;
  if (is_from_another(role, t_us, frame)) return;
  const config::Source& source = *s.source;
  const bool highest =
      error == wire::SignalError::kNone && is_highest_raw(source.signal.signal, frame);
  wire::Signal limited = source.signal.signal;
  limited.minimum = source.has_range ? source.minimum : 0;
  limited.maximum = source.has_range ? source.maximum : 0;
  const bool outside = source.has_range ? !within_limits(limited, value)
                                        : highest && is_beyond(role, value);
  if (error == wire::SignalError::kNotFinite) {
    refuse_value(role, t_us);
  } else if (error != wire::SignalError::kNone) {
    s.out_of_range = false;
  } else if (outside) {
    s.out_of_range = false;
    if (!highest) refuse_value(role, t_us);
  } else {
    take_value(role, t_us, value);
  }
}

void LoopInput::take_reading(Role role, std::int64_t t_us, bool ok, double reading) {
  start_clock(t_us);
  if (!ok || !std::isfinite(reading)) return;
  Signal& s = signal(role);
  const config::Source& source = *s.source;
  if (source.kind == config::SourceKind::kModbus) {
    return take_checked(role, t_us,
                        reading * source.scale.value_or(1) + source.offset.value_or(0));
  }
  // mV over Ω are mA; a voltage is configured in V.
  const double measured = source.shunt_ohm > 0 ? reading / source.shunt_ohm
                          : source.is_current  ? reading
                                               : reading / 1000;
  if (s.current) {
    const hal::CurrentState before = s.state;
    s.state = s.current->take(t_us, measured);
    if (failing(s) && s.state != before) ++counters_.ne43_faults;
    if (failing(s) || s.state == hal::CurrentState::kSettling) return;
    if (s.state == hal::CurrentState::kSaturated) {
      uncertain_until_us_ = t_us + kUncertainPeriods * period_us_;
    }
  }
  const double share = (measured - source.in[0]) / (source.in[1] - source.in[0]);
  take_checked(role, t_us, source.out[0] + share * (source.out[1] - source.out[0]));
}

void LoopInput::take_checked(Role role, std::int64_t t_us, double value) {
  const config::Source& source = *signal(role).source;
  if (source.has_range && !(value >= source.minimum && value <= source.maximum)) {
    refuse_value(role, t_us);
  } else {
    take_value(role, t_us, value);
  }
}

void LoopInput::take_drops(std::int64_t t_us, std::uint32_t count) {
  counters_.dropped += count;
  uncertain_until_us_ = t_us + kUncertainPeriods * period_us_;
}

bool LoopInput::failing(const Signal& s) const {
  return s.state == hal::CurrentState::kFailureLow ||
         s.state == hal::CurrentState::kFailureHigh;
}

std::optional<FarSignal> LoopInput::far_signal() const {
  for (const Role role : {Role::kU, Role::kY}) {
    const Signal& s = signals_[static_cast<int>(role)];
    if (s.reach && s.reach->left()) return FarSignal{role, s.reach->far_value()};
  }
  return std::nullopt;
}

std::optional<SlowSignal> LoopInput::slow_signal() const {
  const std::int64_t u_us = resampler_.interval_us(Channel::kU);
  const std::int64_t y_us = resampler_.interval_us(Channel::kY);
  const std::int64_t slower_us = std::max(u_us, y_us);
  if (2 * slower_us < 3 * period_us_) return std::nullopt;
  return SlowSignal{u_us >= y_us ? Role::kU : Role::kY,
                    static_cast<double>(slower_us) * 1e-6};
}

std::optional<TwoSenders> LoopInput::two_senders() const {
  for (std::size_t k = 0; k < kRoles; ++k) {
    const Signal& s = signals_[k];
    if (s.two_senders)
      return TwoSenders{static_cast<Role>(k), *s.sender, *s.other_sender};
  }
  return std::nullopt;
}

bool LoopInput::overdue(const Signal& s, std::int64_t now_us) const {
  return now_us - s.usable_us > stale_after_us_;
}

bool LoopInput::suspended(std::int64_t now_us) {
  const Signal& alive = signal(Role::kAlive);
  return mode_ == wire::LoopMode::kManual || far_signal() || failing(signal(Role::kU)) ||
         failing(signal(Role::kY)) ||
         (alive.source && now_us - alive.alive_us > stale_after_us_);
}

bool LoopInput::next(std::int64_t until_us, ident::Sample<float>& out) {
  GridSample grid;
  while (resampler_.next(until_us, grid)) {
    counters_.gaps += grid.held ? 1 + static_cast<std::uint32_t>(grid.passed) : 0;
    if (grid.stale || suspended(grid.t_us)) continue;
    out.t_us = grid.t_us;
    out.u = static_cast<float>(grid.u);
    out.y = static_cast<float>(grid.y);
    out.has_sp = grid.has_sp;
    out.sp = grid.has_sp ? static_cast<float>(grid.sp) : 0.0F;
    return true;
  }
  return false;
}

wire::InputStatus LoopInput::status(std::int64_t now_us) {
  using wire::InputStatus;
  start_clock(now_us);
  const Signal& u = signal(Role::kU);
  const Signal& y = signal(Role::kY);
  const Signal& alive = signal(Role::kAlive);
  const bool silent = overdue(u, now_us) || overdue(y, now_us) ||
                      (alive.source && now_us - alive.alive_us > stale_after_us_);
  const bool far = far_signal().has_value() && !silent;
  const bool out_of_range = far || (u.out_of_range && overdue(u, now_us)) ||
                            (y.out_of_range && overdue(y, now_us));
  const bool low = u.state == hal::CurrentState::kFailureLow ||
                   y.state == hal::CurrentState::kFailureLow;
  const bool high = u.state == hal::CurrentState::kFailureHigh ||
                    y.state == hal::CurrentState::kFailureHigh;
  const InputStatus status = low            ? InputStatus::kCurrentLow
                             : high         ? InputStatus::kCurrentHigh
                             : out_of_range ? InputStatus::kOutOfRange
                             : silent       ? InputStatus::kMissing
                             : !u.any || !y.any || now_us < uncertain_until_us_
                                 ? InputStatus::kUncertain
                                 : InputStatus::kGood;
  const bool missing = status == InputStatus::kMissing;
  counters_.stale += missing && !missing_;
  missing_ = missing;
  return status;
}

double LoopInput::live(Role role) const {
  return signals_[static_cast<int>(role)].value;
}

}  // namespace firmware
