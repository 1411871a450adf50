#include "workbench/analysis/wording.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "workbench/recording/resample.hpp"
#include "workbench/recording/time_unit.hpp"

namespace workbench {

std::string_view headline(ident::Verdict verdict, ident::Reason reason,
                          double detectable_band) {
  switch (verdict) {
    case ident::Verdict::kStiction:
      return "The valve sticks.";
    case ident::Verdict::kBacklash:
      return "The valve has play (backlash).";
    case ident::Verdict::kNoStiction:
      if (reason == ident::Reason::kNotTheValve) {
        return "Nothing says that the valve causes what is seen.";
      }
      if (reason == ident::Reason::kBandDoesNotMatter) {
        return "If the valve sticks, then by too little to matter.";
      }
      return detectable_band > 0 ? "The valve does not stick."
                                 : "Nothing speaks for a sticking valve.";
    case ident::Verdict::kUndecided:
      return "This recording cannot tell whether the valve sticks.";
    case ident::Verdict::kBadData:
      return "These samples cannot be used.";
  }
  return "";
}

namespace {

// Of a valve that is fine, where the cause is known.
std::string_view advice_on(ident::Cause cause) {
  switch (cause) {
    case ident::Cause::kExternalPeriodic:
      return "Put the controller in manual: if the oscillation goes on, look for another "
             "loop or a machine with this period, upstream first, and leave the tuning "
             "alone; if it dies out, retune with half the gain.";
    case ident::Cause::kTightTuning:
      return "Put the controller in manual: the oscillation dies out. Then retune with "
             "half the gain or less.";
    case ident::Cause::kUnknown:
    case ident::Cause::kValve:
    case ident::Cause::kSetpoint:
    case ident::Cause::kSensor:
      break;
  }
  return "";
}

// Without a slip a valve that sticks looks like one with play.
std::string_view advice_on_sticking(bool slips) {
  return slips
             ? "Confirm in manual: step the controller output by less than the stick "
               "band, then by more; the process answers only to the second. Then look at "
               "packing, actuator and positioner. Retuning may slow a cycle but does not "
               "free the stem."
             : "Confirm in manual: step the controller output by less than the stick "
               "band, then by more; the process answers only to the second. Then look at "
               "packing, actuator and positioner, and for play in the linkage: the "
               "recording does not tell which. Retuning may slow a cycle but does not "
               "free the stem.";
}

std::string_view advice_on(ident::Reason reason, bool slips) {
  using ident::Reason;
  switch (reason) {
    case Reason::kSticksBothStrokes:
    case Reason::kSticksAscending:
    case Reason::kSticksDescending:
    case Reason::kSlipUnresolved:
    case Reason::kSticksUnderLoad:
    case Reason::kSticksTogether:
    case Reason::kStrokesUnresolved:
      return advice_on_sticking(slips);
    case Reason::kDeadbandOnly:
      return "Look for play in linkage, coupling and positioner feedback. Confirm in "
             "manual: after a reversal the process answers only once the controller "
             "output has crossed the band.";
    case Reason::kLinearExplains:
    case Reason::kBandDoesNotMatter:
      return "Leave the valve alone. If the loop oscillates, look at the tuning and at "
             "disturbances from other loops.";
    case Reason::kCurveExplains:
      return "Tune for the end of the swing where the process output answers most, or "
             "linearise the controller output. The valve may still stick: step the "
             "controller output in manual, by as little as matters, and see whether the "
             "process answers.";
    case Reason::kNotTheValve:
      return "Look for the cause elsewhere first: the tuning, another loop with the same "
             "period, or a periodic load. Small steps of the controller output in manual "
             "tell whether the valve sticks as well; one that answers none is stuck.";
    case Reason::kStemBounded:
      return "Step the controller output in manual by more than the swing, and watch how "
             "fast the stem moves and where it stops: look at air supply, positioner, "
             "actuator size, travel stops and output limits. Slower tuning may end the "
             "oscillation. Whether the valve sticks as well shows then.";
    case Reason::kSensorSticks:
      return "Check the transmitter: float or displacer, impulse lines, its own deadband "
             "or damping, and whether a system in between only passes on larger changes. "
             "Then record again.";
    case Reason::kReadingCutOff:
      return "Widen the range of the transmitter, or look for an overflow or an empty "
             "vessel; then record again.";
    case Reason::kSignalsSwapped:
      return "Ask which column is the controller output; name that one u, the process "
             "output y, and identify again.";
    case Reason::kSeam:
      return "Cut the recording where it was joined and identify each part alone.";
    case Reason::kCompressed:
      return "Switch off compression and exception deadband for both tags in the "
             "historian, or record at the controller, and record again.";
    default:
      return "";  // the reason itself says what data would tell
  }
}

}  // namespace

std::string_view advice(ident::Reason reason, ident::Cause cause, double detectable_band,
                        bool slips) {
  const std::string_view of_cause = advice_on(cause);
  if (!of_cause.empty()) return of_cause;
  if (reason == ident::Reason::kLinearExplains && !(detectable_band > 0)) {
    return "Look at the tuning and at disturbances from other loops first. The valve may "
           "still stick: step the controller output in manual, by as little as matters, "
           "and see whether the process answers.";
  }
  return advice_on(reason, slips);
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "–";
  constexpr double kMost = 1e15;  // whose last digit a double still tells
  if (std::abs(value) >= kMost) return number(value, 4);
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", std::min(decimals, 15), value);
  std::string out = text;
  const bool zero = out.find_first_of("123456789") == std::string::npos;
  if (zero && out.front() == '-') out.erase(0, 1);
  return out;
}

int decimals_for(double resolution) {
  if (!(resolution > 0) || !std::isfinite(resolution)) return 3;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(resolution))), 0, 9);
}

EstimateText text_of(const ident::Estimate<double>& estimate) {
  if (!estimate.known) return {"unknown", ""};
  const double width = estimate.high - estimate.low;
  const double scale = std::max(std::abs(estimate.high), std::abs(estimate.low));
  const int decimals = decimals_for(std::max(width / 2, scale / 200));
  return {fixed(estimate.value, decimals),
          fixed(estimate.low, decimals) + " to " + fixed(estimate.high, decimals)};
}

std::string duration(double seconds) {
  const auto in = [seconds](double unit, const char* name) {
    const double value = seconds / unit;
    return fixed(value, decimals_for(value / 10)) + ' ' + name;
  };
  if (seconds < 300) return in(1, "s");
  if (seconds < 2 * kHourS) return in(60, "min");
  if (seconds < 2 * kDayS) return in(kHourS, "h");
  return in(kDayS, "days");
}

double span_of(const std::vector<double>& values) {
  const auto [low, high] = std::ranges::minmax_element(values);
  return *high - *low;
}

}  // namespace workbench
