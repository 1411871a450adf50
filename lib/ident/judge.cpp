#include "ident/judge.hpp"

namespace ident {
namespace {

// A valve that explains less than this share of y is not what moves y.
constexpr double kPoorFit = 25;
// Log-likelihood gain, in nats, below which a sticking valve is not claimed.
constexpr double kEnough = 10;
constexpr double kSuggestive = 3;
// Squared error of the linear valve over that of the sticking one.
constexpr double kRatio = 1.25;
// Stick band over the usual swing of u below which it does not matter.
constexpr double kMatters = 0.05;

}  // namespace

template <class Real>
Judgement judge(const Evidence<Real>& e, bool oscillates) {
  const double ratio = static_cast<double>(e.error_ratio);
  const double score = static_cast<double>(e.score);
  const double fit = static_cast<double>(e.fit_percent);
  const double band = static_cast<double>(e.band_over_swing);
  if (e.reversals < 2) {
    return {Verdict::kUndecided, Reason::kNoMovement};
  }
  if (fit < kPoorFit) {
    return oscillates ? Judgement{Verdict::kNoStiction, Reason::kNotTheValve}
                      : Judgement{Verdict::kUndecided, Reason::kModelTooPoor};
  }
  if (e.form == ValveForm::kLinear || score < kSuggestive) {
    return {Verdict::kNoStiction, Reason::kLinearExplains};
  }
  if (band < kMatters) {
    return {Verdict::kNoStiction, Reason::kBandDoesNotMatter};
  }
  if (ratio < kRatio || score < kEnough) {
    return {Verdict::kUndecided, Reason::kEvidenceTooWeak};
  }
  switch (e.form) {
    case ValveForm::kAscending: return {Verdict::kStiction, Reason::kSticksAscending};
    case ValveForm::kDescending: return {Verdict::kStiction, Reason::kSticksDescending};
    case ValveForm::kBacklash: return {Verdict::kBacklash, Reason::kDeadbandOnly};
    default: return {Verdict::kStiction, Reason::kSticksBothStrokes};
  }
}

template Judgement judge<float>(const Evidence<float>&, bool);
template Judgement judge<double>(const Evidence<double>&, bool);

std::string_view sentence(Reason reason) {
  switch (reason) {
    case Reason::kNone: return "";
    case Reason::kSticksBothStrokes:
      return "The valve sticks and slips on both strokes: a sticking valve explains the "
             "process output much better than one that follows the controller.";
    case Reason::kSticksAscending:
      return "The valve sticks when the controller output rises, not when it falls.";
    case Reason::kSticksDescending:
      return "The valve sticks when the controller output falls, not when it rises.";
    case Reason::kDeadbandOnly:
      return "The valve has play: it loses part of each stroke at every reversal, but "
             "moves smoothly after that.";
    case Reason::kLinearExplains:
      return "A valve that follows the controller output explains the process output as "
             "well as a sticking one.";
    case Reason::kBandDoesNotMatter:
      return "A small stick band was found, too small against the swing of the controller "
             "output to matter.";
    case Reason::kNotTheValve:
      return "The loop oscillates, but no valve explains it from the controller output: "
             "look for a disturbance from outside.";
    case Reason::kConstant:
      return "A signal does not move: record the loop while it is in automatic and "
             "oscillating.";
    case Reason::kTooShort:
      return "Too few samples: record at least five cycles of the oscillation, with 10 "
             "samples or more a cycle.";
    case Reason::kNoMovement:
      return "The controller output hardly reverses: record more cycles, or step the "
             "setpoint up and down.";
    case Reason::kTooFewCycles:
      return "Too few reversals to see a pattern repeat: record at least five cycles.";
    case Reason::kModelTooPoor:
      return "Most of the process output does not come from this valve in this recording: "
             "record while the loop oscillates, or step the setpoint.";
    case Reason::kEvidenceTooWeak:
      return "A sticking valve explains the recording a little better, not enough to be "
             "sure: record more cycles.";
    case Reason::kBandBelowResolution:
      return "The stick band would be below the resolution of the signals: record with "
             "finer resolution.";
    case Reason::kNotFinite:
      return "A sample is not a finite number: repair the recording.";
  }
  return "";
}

}  // namespace ident
