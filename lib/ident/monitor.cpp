#include "ident/monitor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ident/base/elementary.hpp"
#include "ident/monitor_evaluation.hpp"

namespace ident {
namespace {

constexpr std::array<std::string_view, kEventKinds> kEventNames = {
    "oscillation_started", "oscillation_ended", "stiction_raised", "stiction_cleared",
    "undecided",           "input_fault",       "input_restored",
};

constexpr double kDefaultSpan = 100;
constexpr std::uint8_t kMostWaits = 4;

template <class Real>
MonitorSettings<Real> in_range(MonitorSettings<Real> settings) {
  settings.evaluate_every_pct = std::clamp(settings.evaluate_every_pct, 1, 100);
  settings.memory_pct = std::clamp(settings.memory_pct, 0, 100);
  settings.first_cycles = std::clamp(settings.first_cycles, 2, 100);
  settings.gain_sign = std::clamp(settings.gain_sign, -1, 1);
  const Real span = settings.span_high - settings.span_low;
  if (!std::isfinite(span) || !(span > Real(0))) {
    settings.span_low = 0;
    settings.span_high = Real(kDefaultSpan);
  }
  return settings;
}

std::uint64_t restarts_of(const WindowCounters& counters) {
  return counters.restarts + counters.overruns;
}

}  // namespace

std::string_view name(EventKind kind) {
  return kEventNames[static_cast<std::size_t>(kind)];
}

template <class Real, std::size_t Capacity>
Monitor<Real, Capacity>::Monitor(const MonitorSettings<Real>& settings)
    : settings_(in_range(settings)),
      window_(settings.sample_period_us, settings.longest_hold),
      health_(settings.input, settings.sample_period_us),
      alarm_(settings.alarm) {}

template <class Real, std::size_t Capacity>
PushResult Monitor<Real, Capacity>::push(const Sample<Real>& sample) {
  const std::uint64_t filled = window_.counters().filled;
  const std::uint64_t restarts = restarts_of(window_.counters());
  const PushResult result = window_.push(sample);
  const InputFault before = health_.fault();
  const Real period =
      u_oscillation_.oscillating ? u_oscillation_.period_samples : Real(0);
  announce_health(health_.push(sample, result, period), before);
  if (result != PushResult::kAccepted && result != PushResult::kGap) {
    return result;
  }
  if (restarts_of(window_.counters()) != restarts) {
    restart_evidence();
  }
  const std::size_t held = static_cast<std::size_t>(window_.counters().filled - filled);
  for (std::size_t k = 0; k < held; ++k) {
    show_to_detectors(newest_);
  }
  newest_ = sample;
  show_to_detectors(sample);
  watch_oscillation();
  if (health_.fault() != InputFault::kNone) {
    return result;
  }
  usable_ = std::min(usable_ + held + 1, window_.size());
  fresh_ += held + 1;
  since_ = std::min(since_ + held + 1, usable_);
  if (window_due()) {
    make_due();
  }
  return result;
}

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::make_due() {
  fresh_ = 0;
  compared_ = usable_;
  report_.counters.skipped_windows += due_ || (running_ && counts_) ? 1 : 0;
  due_ = due_ || !(running_ && counts_);
}

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::advance(std::int64_t now_us) {
  const InputFault before = health_.fault();
  announce_health(health_.advance(now_us), before);
}

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::announce_health(HealthChange change, InputFault before) {
  if (change == HealthChange::kNone) {
    return;
  }
  const bool fault = change == HealthChange::kFault;
  report_.counters.input_faults += fault ? 1 : 0;
  announce({.t_us = health_.changed_us(),
            .kind = fault ? EventKind::kInputFault : EventKind::kInputRestored,
            .fault = fault ? health_.fault() : before});
  restart_evidence();
}

// Samples up to now are not used for any further window.
template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::restart_evidence() {
  usable_ = fresh_ = compared_ = since_ = 0;
  asked_ = due_ = false;
}

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::show_to_detectors(const Sample<Real>& sample) {
  const bool u_cycle = u_detector_.push(sample.u);
  const bool y_cycle = y_detector_.push(sample.y);
  u_cycle_ |= u_cycle;
  y_cycle_ |= y_cycle;
  waited_ = u_cycle || y_cycle ? static_cast<std::uint8_t>(waited_ + 1) : kMostWaits;
}

// Detectors are asked after samples that end no cycle, which cost less, or after the
// fourth that does; one at a time: where both have news, y's comes later.
template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::watch_oscillation() {
  if (waited_ < kMostWaits) {
    return;
  }
  waited_ = 0;
  if (u_cycle_) {
    u_cycle_ = false;
    u_oscillation_ = u_detector_.rhythm();
  } else if (y_cycle_) {
    y_cycle_ = false;
    y_oscillation_ = y_detector_.rhythm();
  }
  if (health_.fault() != InputFault::kNone) {
    return;
  }
  const OscillationRhythm<Real>& now =
      u_oscillation_.oscillating ? u_oscillation_ : y_oscillation_;
  if (now.oscillating) {
    period_ = now.period_samples;
  }
  if (now.oscillating == oscillating_) {
    return;
  }
  oscillating_ = now.oscillating;
  announce({.t_us = window_.newest_us(),
            .kind = oscillating_ ? EventKind::kOscillationStarted
                                 : EventKind::kOscillationEnded,
            .period_samples = period_});
}

// New samples that make the next window due.
template <class Real, std::size_t Capacity>
std::size_t Monitor<Real, Capacity>::hop() const {
  const std::size_t percent = static_cast<std::size_t>(settings_.evaluate_every_pct);
  const std::size_t share = std::max<std::size_t>(Capacity * percent / 100, 1);
  return usable_ < Capacity ? std::min(std::max(compared_ / 2, kFewest), share) : share;
}

template <class Real, std::size_t Capacity>
bool Monitor<Real, Capacity>::window_due() const {
  if (compared_ > 0 && fresh_ < hop()) {
    return false;
  }
  if (usable_ == Capacity) {
    return true;
  }
  return usable_ >= kFewest && u_oscillation_.oscillating &&
         static_cast<Real>(usable_) >=
             static_cast<Real>(settings_.first_cycles) * u_oscillation_.period_samples;
}

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::request_evaluation() {
  asked_ = asked_ || (!running_ && usable_ > 0 && has_news());
}

template <class Real, std::size_t Capacity>
bool Monitor<Real, Capacity>::has_news() const {
  return !report_.evaluated || report_.window_end_us != window_.newest_us();
}

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::end_recording() {
  if (has_news() && fresh_ > 0 && (compared_ == 0 || 2 * fresh_ >= hop())) {
    make_due();
  } else {
    request_evaluation();
  }
}

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::evaluate_now() {
  while (step(kLargeBudget)) {
  }
  end_recording();
  while (step(kLargeBudget)) {
  }
}

template <class Real, std::size_t Capacity>
bool Monitor<Real, Capacity>::step(int budget) {
  return advance_evaluation(due_ || asked_, budget);
}

template <class Real, std::size_t Capacity>
bool Monitor<Real, Capacity>::step_asked(int budget) {
  const bool due = std::exchange(due_, false);
  const bool working = advance_evaluation(asked_, budget);
  due_ = due;
  return working;
}

template <class Real, std::size_t Capacity>
bool Monitor<Real, Capacity>::advance_evaluation(bool may_begin, int budget) {
  if (may_begin && !running_) {
    begin_evaluation();
  } else if (running_) {
    identifier_.step(std::max(budget, 1));
    window_.set_scale(identifier_.scale_of_u(), identifier_.scale_of_y());
  }
  if (running_ && identifier_.done()) {
    finish_evaluation();
  }
  return busy();
}

// Share of the evidence that is left when so many windows of samples (> 0) have come.
template <class Real, std::size_t Capacity>
float Monitor<Real, Capacity>::kept_after(float windows) const {
  return elementary::pow(0.01f * static_cast<float>(settings_.memory_pct), windows);
}

template <class Real, std::size_t Capacity>
MonitorMemory Monitor<Real, Capacity>::memory() const {
  return {pool_,          alarm_.state(),     report_.alike_windows,
          alike_verdict_, alike_oscillation_, earlier_};
}

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::restore(const MonitorMemory& memory, Real missed_windows) {
  pool_ = memory.pool;
  if (missed_windows > Real(0)) {
    pool_.fade(kept_after(static_cast<float>(missed_windows)));
  }
  alarm_.restore(memory.alarm);
  report_.alike_windows = std::clamp(memory.alike_windows, 0, kLongestDelay);
  alike_verdict_ = memory.alike_verdict;
  alike_oscillation_ = memory.alike_oscillation;
  earlier_ = memory.earlier;
}

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::resume(std::size_t unjudged) {
  since_ = fresh_ = std::min(unjudged, usable_);
  compared_ = usable_ - fresh_;
  due_ = window_due();
  event_count_ = 0;
  report_.counters = {};
}

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::announce(const Event<Real>& event) {
  if (event_count_ == kEvents) {
    first_event_ = static_cast<std::uint8_t>((first_event_ + 1) % kEvents);
    --event_count_;
    ++report_.counters.events_lost;
  }
  events_[(first_event_ + event_count_) % kEvents] = event;
  ++event_count_;
}

template <class Real, std::size_t Capacity>
std::optional<Event<Real>> Monitor<Real, Capacity>::poll() {
  if (event_count_ == 0) {
    return std::nullopt;
  }
  const Event<Real>& oldest = events_[first_event_];
  first_event_ = static_cast<std::uint8_t>((first_event_ + 1) % kEvents);
  --event_count_;
  return oldest;
}

template <class Real, std::size_t Capacity>
MonitorReport<Real> Monitor<Real, Capacity>::report() const {
  MonitorReport<Real> out = report_;
  out.confirmed = report_.alike_windows >= alarm_.on_delay();
  out.stiction_raised = alarm_.raised();
  out.oscillating = oscillating_;
  out.fault = health_.fault();
  out.samples = window_.counters();
  return out;
}

template class Monitor<float, kSmallWindow>;
template class Monitor<float, kStandardWindow>;
template class Monitor<float, kLargeWindow>;
template class Monitor<double, kSmallWindow>;
template class Monitor<double, kStandardWindow>;
template class Monitor<double, kLargeWindow>;

}  // namespace ident
