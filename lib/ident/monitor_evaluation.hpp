// The part of the monitor that judges windows and says what came of them.
// Definitions for monitor.cpp alone: an archive of intermediate code does not pull in
// what only members of a class ask for.
#pragma once

#include <algorithm>

#include "ident/monitor.hpp"
#include "ident/verdict/judge.hpp"
#include "ident/verdict/pooled_view.hpp"

namespace ident {

// Decided windows in a row after which the same undecided is news again.
inline constexpr int kDecided = 2;
// A window is added to the pool once one part in so many of it is new.
inline constexpr std::size_t kPoolShare = 10;

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::begin_evaluation() {
  counts_ = due_;
  due_ = asked_ = false;
  running_ = true;
  running_end_us_ = window_.newest_us();
  running_samples_ = usable_;
  const auto held = window_.hold(usable_);
  // Windows that were asked for leave the pool as it is.
  WindowOptions options;
  options.span = static_cast<float>(settings_.span_high - settings_.span_low);
  options.earlier = &earlier_;
  if (counts_) {
    options.ends_early = true;
    if constexpr (kTwoPathSearch) options.two_path = false;
  }
  // A smaller share of a window would be lost where the pool is rounded.
  if (counts_ && (!kStemSearch || kPoolShare * since_ >= usable_)) {
    options.pool = &pool_;
    options.weight = static_cast<float>(since_) / static_cast<float>(usable_);
    // Also where the window then says nothing: what it shows was not there before.
    pool_.fade(kept_after(options.weight));
    since_ = 0;
  }
  identifier_.start(held.u, held.y, held.sp, settings_.gain_sign, options);
}

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::finish_evaluation() {
  running_ = false;
  window_.release();
  const Identification<Real>& result = identifier_.result();
  static_cast<Findings<Real>&>(report_) = result;
  ++report_.counters.evaluations;
  report_.evaluated = true;
  report_.asked = !counts_;
  report_.window_end_us = running_end_us_;
  report_.window_samples = running_samples_;
  report_.evidence_nats =
      std::max(result.evidence.ladder.nats, nats_of_stems(result.evidence, Real(-1e6)));
  judge_with_pool();
  tell_undecided();
  if (counts_) {
    earlier_ = identifier_.next_start();
    show_to_alarm();
  }
}

// The sum over the windows against what the newest one says.
template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::judge_with_pool() {
  report_.pooled = pool_.finding(settings_.span_high - settings_.span_low);
  const PooledView view = view_of(report_.pooled, pool_.windows());
  const bool fault = is_fault(report_.verdict);
  // A valve that was mended no longer adds to the sum, nor makes u oscillate.
  const bool goes_on = identifier_.result().evidence.ladder.nats > Real(0) &&
                       report_.oscillation.detected &&
                       may_stick_together(identifier_.result().evidence);
  if (view == PooledView::kSticks && report_.verdict == Verdict::kUndecided && goes_on) {
    report_.verdict = Verdict::kStiction;
    report_.reason = Reason::kSticksTogether;
    const Estimate<Real> band{true, report_.pooled.band, report_.pooled.low,
                              report_.pooled.high};
    report_.stick_band = {band, band};
    report_.slip_jump = {};
  } else if (view == PooledView::kNothing && fault &&
             report_.evidence_nats < Real(kAloneNats)) {
    report_.verdict = Verdict::kUndecided;
    report_.reason = Reason::kWindowsDisagree;
    report_.stick_band = report_.slip_jump = {};
  }
}

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::tell_undecided() {
  if (report_.verdict != Verdict::kUndecided) {
    decided_windows_ = std::min(decided_windows_ + 1, kDecided);
    told_ = decided_windows_ < kDecided ? told_ : Reason::kNone;
    return;
  }
  decided_windows_ = 0;
  if (told_ == report_.reason) {
    return;
  }
  told_ = report_.reason;
  announce({.t_us = running_end_us_,
            .kind = EventKind::kUndecided,
            .verdict = report_.verdict,
            .reason = report_.reason});
}

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::count_alike() {
  // No stiction with an oscillation is another finding than without.
  const bool oscillation =
      report_.verdict == Verdict::kNoStiction && report_.oscillation.detected;
  const bool alike =
      report_.verdict == alike_verdict_ && oscillation == alike_oscillation_;
  alike_verdict_ = report_.verdict;
  alike_oscillation_ = oscillation;
  report_.alike_windows = alike ? std::min(report_.alike_windows + 1, kLongestDelay) : 1;
}

template <class Real, std::size_t Capacity>
void Monitor<Real, Capacity>::show_to_alarm() {
  count_alike();
  const Real percent = Real(100) * report_.stick_band.larger() /
                       (settings_.span_high - settings_.span_low);
  const AlarmChange change = alarm_.take(report_.verdict, static_cast<float>(percent),
                                         report_.oscillation.detected);
  if (change == AlarmChange::kNone) {
    return;
  }
  announce({.t_us = running_end_us_,
            .kind = change == AlarmChange::kRaised ? EventKind::kStictionRaised
                                                   : EventKind::kStictionCleared,
            .verdict = report_.verdict,
            .reason = report_.reason,
            .stick_band = report_.stick_band,
            .slip_jump = report_.slip_jump});
}

}  // namespace ident
