// What a loop shows of itself: verdict, bands, input, trend.
#include <algorithm>
#include <cmath>

#include "firmware/monitored_loop.hpp"

namespace firmware {
namespace {

using wire::InputStatus;
using wire::LoopVerdict;

constexpr double kAtLimit = 0.005;  // share of the span
// What is shown as a number of 16 bits, in hundredths of a percent, ends there.
constexpr double kMostShown = 327;     // % of the span, signed
constexpr double kMostResidual = 655;  // %, unsigned

double if_shown(double percent, double most) {
  return std::abs(percent) <= most ? percent : wire::kNotAvailable;
}

LoopVerdict verdict_of(const ident::MonitorReport<float>& report) {
  switch (report.verdict) {
    case ident::Verdict::kStiction:
      return LoopVerdict::kStiction;
    case ident::Verdict::kBacklash:
      return LoopVerdict::kBacklash;
    case ident::Verdict::kNoStiction:
      return report.oscillation.detected ? LoopVerdict::kOtherOscillation
                                         : LoopVerdict::kNoStiction;
    case ident::Verdict::kUndecided:
      return LoopVerdict::kUndecided;
    case ident::Verdict::kBadData:
      return LoopVerdict::kInputInvalid;
  }
  return LoopVerdict::kUndecided;
}

wire::StrokeValues known_or_none(const ident::PerStroke<float>& strokes,
                                 float ident::Estimate<float>::*part, double scale) {
  const auto one = [&](const ident::Estimate<float>& estimate) {
    return estimate.known ? static_cast<double>(estimate.*part) * scale
                          : wire::kNotAvailable;
  };
  return {one(strokes.ascending), one(strokes.descending)};
}

// How sure the numbers make the verdict, 0 … 1; NaN: it says nothing.
double margin(const ident::MonitorReport<float>& report) {
  const auto valve = static_cast<double>(report.fit_valve_percent);
  const auto linear = static_cast<double>(report.fit_linear_percent);
  switch (report.verdict) {
    case ident::Verdict::kStiction:
    case ident::Verdict::kBacklash:
      return linear < 100 ? std::clamp((valve - linear) / (100 - linear), 0.0, 1.0) : 0;
    case ident::Verdict::kNoStiction: {
      // A window that ends early has nothing fitted, but evidence against a stem.
      const auto against = static_cast<double>(std::min(report.evidence_nats, 0.0f));
      return std::clamp(std::max(linear / 100, -std::expm1(against)), 0.0, 1.0);
    }
    default:
      return wire::kNotAvailable;
  }
}

// Nothing is fitted to a window that ends early.
void show_fits(const ident::MonitorReport<float>& report, wire::LoopStatus& status) {
  const auto fit_or_none = [&](float percent) {
    return report.fit_valve_percent != 0 ? static_cast<double>(percent)
                                         : wire::kNotAvailable;
  };
  status.fit_percent =
      fit_or_none(std::max(report.fit_percent, report.fit_valve_percent));
  status.fit_linear_percent = fit_or_none(report.fit_linear_percent);
}

}  // namespace

double MonitoredLoop::percent_of_span(double value) const {
  return 100 * (value - loop_.span[0]) / (loop_.span[1] - loop_.span[0]);
}

double MonitoredLoop::received_share(const ident::MonitorReport<float>& report) const {
  const std::uint64_t held = input_.counters().gaps + input_.counters().dropped;
  const auto made_up =
      static_cast<double>(report.samples.filled - filled_before_ + held - held_before_);
  const auto samples =
      static_cast<double>(std::max<std::size_t>(report.window_samples, 1));
  return std::clamp(1 - made_up / samples, 0.0, 1.0);
}

void MonitoredLoop::show_paths() {
  const ident::TwoPathModel<float>& model = monitor_->identification().model;
  const ident::Path<float>& up = model.ascending;
  const ident::Path<float>& down = model.descending;
  const auto u_low = static_cast<double>(up.knots[0]);
  const auto u_high =
      static_cast<double>(up.knots[static_cast<std::size_t>(up.segments)]);
  const int knots = std::min<int>(up.segments + 1, wire::kMostPathKnots);
  // x is known up to scale and offset: shown as the u that a valve without friction
  // needs.
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (int k = 0; k < knots; ++k) {
    const float u = up.knots[static_cast<std::size_t>(k)];
    for (const float x : {up.x[static_cast<std::size_t>(k)], down.at(u)}) {
      low = std::min(low, static_cast<double>(x));
      high = std::max(high, static_cast<double>(x));
    }
  }
  status_.path_knots = 0;
  if (!(low < high) || !(u_low < u_high)) return;
  const auto shown = [&](float x) {
    const double share = (static_cast<double>(x) - low) / (high - low);
    return percent_of_span(u_low + share * (u_high - u_low));
  };
  for (int k = 0; k < knots; ++k) {
    const auto at = static_cast<std::size_t>(k);
    status_.path[at] = {percent_of_span(static_cast<double>(up.knots[at])),
                        shown(up.x[at]), shown(down.at(up.knots[at]))};
  }
  status_.path_knots = static_cast<std::uint8_t>(knots);
}

void MonitoredLoop::show_window(const ident::MonitorReport<float>& report) {
  const double per_span = 100 / (loop_.span[1] - loop_.span[0]);
  const LoopVerdict verdict = verdict_of(report);
  using E = ident::Estimate<float>;
  status_.stick_band_low_pct = known_or_none(report.stick_band, &E::low, per_span);
  status_.stick_band_high_pct = known_or_none(report.stick_band, &E::high, per_span);
  status_.detectable_band_pct =
      report.detectable_band > 0 ? static_cast<double>(report.detectable_band) * per_span
                                 : wire::kNotAvailable;
  status_.evidence_nats = report.evidence_nats != 0
                              ? static_cast<double>(report.evidence_nats)
                              : wire::kNotAvailable;
  counted_ = counted_ || !report.asked;
  if (!report.asked) {
    standing_ = verdict;
    judged_ = report.window_samples;
    judged_since_ = judged_since_ || report.window_end_us > returned_us_;
    const wire::StrokeValues& low = status_.stick_band_low_pct;
    const wire::StrokeValues& high = status_.stick_band_high_pct;
    const bool changed = bands_.take(
        {{{low.ascending, high.ascending}, {low.descending, high.descending}}});
    band_changed_ = band_changed_ || changed;
  }
  remembered_ = true;
  dated_ = false;
  status_.window_verdict = verdict;
  status_.stick_band_pct = known_or_none(report.stick_band, &E::value, per_span);
  status_.slip_jump_pct = known_or_none(report.slip_jump, &E::value, per_span);
  status_.period_s =
      report.oscillation.detected
          ? static_cast<double>(report.oscillation.period_samples) * loop_.sample_period_s
          : wire::kNotAvailable;
  status_.window_samples = static_cast<double>(report.window_samples);
  status_.window_cycles = static_cast<double>(report.cycles);
  show_fits(report, status_);
  status_.suspect_effect = static_cast<std::uint8_t>(report.gap.suspect);
  status_.share_of_error_pct = report.residual_rms > 0
                                   ? 100 * static_cast<double>(report.gap.share_of_error)
                                   : wire::kNotAvailable;
  const double residual = 100 * static_cast<double>(report.residual_rms) /
                          (loop_.y_span[1] - loop_.y_span[0]);
  status_.residual_share_pct =
      report.residual_rms > 0 ? if_shown(residual, kMostResidual) : wire::kNotAvailable;
  const double share = received_share(report);
  status_.confidence_pct = (50 + 50 * margin(report)) * share;
  filled_before_ = report.samples.filled;
  held_before_ = input_.counters().gaps + input_.counters().dropped;
  status_.counters.refused_fits += verdict == LoopVerdict::kUndecided;
  show_paths();
}

InputStatus MonitoredLoop::input_status(const ident::MonitorReport<float>& report,
                                        std::int64_t now_us) {
  const InputStatus status = input_.status(now_us);
  if (!wire::is_usable(status) || input_.mode() == wire::LoopMode::kManual) return status;
  if (report.fault == ident::InputFault::kFrozenY) return InputStatus::kFrozen;
  if (report.fault == ident::InputFault::kFrozenU) {
    const double u = percent_of_span(input_.live(Role::kU)) / 100;
    return u <= kAtLimit || u >= 1 - kAtLimit ? InputStatus::kClipped
                                              : InputStatus::kFrozen;
  }
  return status;
}

void MonitoredLoop::show_verdict(const ident::MonitorReport<float>& report) {
  LoopVerdict verdict = status_.window_verdict;
  bool confirmed = report.confirmed && standing_ != LoopVerdict::kStiction;
  if (confirmed) verdict = standing_;
  if (report.stiction_raised && !swapped_) {
    verdict = LoopVerdict::kStiction;
    confirmed = true;
  }
  if (!wire::is_usable(status_.input)) {
    verdict = LoopVerdict::kInputInvalid;
    confirmed = true;
  }
  if (returning_ && verdict == LoopVerdict::kStiction) confirmed = false;
  if (simulated_) {
    verdict = *simulated_;
    confirmed = true;
  }
  status_.simulated = simulated_.has_value();
  status_.verdict = verdict;
  status_.confirmed = confirmed;
  status_.flag = confirmed && verdict == LoopVerdict::kStiction;
}

void MonitoredLoop::show_live(const ident::MonitorReport<float>& report, const Now& now) {
  const auto y_percent = [this](double value) {
    return 100 * (value - loop_.y_span[0]) / (loop_.y_span[1] - loop_.y_span[0]);
  };
  status_.u_pct = if_shown(percent_of_span(input_.live(Role::kU)), kMostShown);
  status_.y_pct = if_shown(y_percent(input_.live(Role::kY)), kMostShown);
  status_.sp_pct = if_shown(y_percent(input_.live(Role::kSp)), kMostShown);
  status_.mode = input_.mode();
  if (!dated_) {
    dated_ = true;
    ended_ms_ = evidence_ms_ = (now.epoch_us - now.us + report.window_end_us) / 1000;
  }
  status_.age_s = age_of(report, now);
  static_cast<wire::InputCounters&>(status_.counters) = input_.counters();
}

double MonitoredLoop::age_of(const ident::MonitorReport<float>& report,
                             const Now& now) const {
  if (report.evaluated) {
    return static_cast<double>(now.us - report.window_end_us) * 1e-6;
  }
  // Of a window before the restart, by the calendar, which may not be set yet.
  const double age_s = static_cast<double>(now.epoch_us / 1000 - ended_ms_) * 1e-3;
  return remembered_ && age_s >= 0 ? age_s : wire::kNotAvailable;
}

void MonitoredLoop::show_trend(std::int64_t epoch_s) {
  const bool stood = !std::isnan(status_.trend_pct_per_day);
  const Trend trend = trend_.find(epoch_s, loop_.band_limit_pct);
  const auto if_stands = [&](double value) {
    return trend.stands ? value : wire::kNotAvailable;
  };
  status_.trend_pct_per_day = if_stands(trend.slope);
  status_.trend_low_pct_per_day = if_stands(trend.low);
  status_.trend_high_pct_per_day = if_stands(trend.high);
  status_.days_to_limit = if_stands(trend.days);
  if (trend.stands && !stood) new_trend_ = trend;
}

}  // namespace firmware
