// What one identification of a window says, with everything it rests on.
#pragma once

#include <cstdint>

#include "ident/gap/model_gap.hpp"
#include "ident/signal/controller_action.hpp"
#include "ident/signal/oscillation_detector.hpp"
#include "ident/signal/record_check.hpp"
#include "ident/two_path/two_path_model.hpp"
#include "ident/valve/valve_search.hpp"
#include "ident/verdict/evidence.hpp"
#include "ident/verdict/oscillation_cause.hpp"
#include "ident/verdict/verdict.hpp"

namespace ident {

/// Why the verdict is what it is; each has one sentence in `sentence()`.
enum class Reason : std::uint8_t {
  kNone,
  // stiction, backlash
  kSticksBothStrokes,  ///< the valve sticks on both strokes
  kSticksAscending,    ///< only with rising u
  kSticksDescending,   ///< only with falling u
  kSlipUnresolved,     ///< sticks, with a slip jump too small to be measured
  kDeadbandOnly,       ///< deadband without slip jump
  kSticksUnderLoad,    ///< seen one sample ahead; other influences hide its strokes
  // no stiction
  kLinearExplains,     ///< a valve that follows u explains y as well
  kBandDoesNotMatter,  ///< a band was found, but it is small against the swing of u
  kNotTheValve,        ///< oscillates, but no valve explains it: look elsewhere
  // undecided
  kConstant,             ///< u or y does not move
  kTooShort,             ///< fewer samples than the smallest model needs
  kOneStroke,            ///< u does not reverse: nothing to learn about a valve
  kTooFewCycles,         ///< fewer reversals than needed to see a pattern repeat
  kAtLimit,              ///< u rests at a limit much of the time
  kSetpointMoves,        ///< the setpoint explains the movement, the valve adds little
  kModelTooPoor,         ///< neither valve explains y: other influences dominate
  kEvidenceTooWeak,      ///< a sticking valve is better, but not by enough
  kBandBelowResolution,  ///< the band is smaller than the resolution of u or y
  kBandWouldNotShow,     ///< a band that matters could hide in this recording
  kStemUnconfirmed,      ///< running free a valve sticks; one sample ahead it does not
  kSticksTogether,       ///< stiction: several windows together, none of them alone
  kStrokesUnresolved,    ///< stiction: on which stroke cannot be told
  kWindowsDisagree,      ///< undecided: windows want valves that exclude each other
  // bad data
  kNotFinite,  ///< a sample is not a finite number
  // undecided: something else than the valve is wrong with u and y
  kSensorSticks,    ///< y holds its value and jumps while u runs on
  kSignalsSwapped,  ///< the column called y is the controller output
  kSeam,            ///< two recordings were joined
  kCompressed,      ///< the historian stored too few points to say that nothing sticks
  // undecided
  kLoadRepeats,   ///< what happened one cycle ago foretells y as well as a stem does
  kTurnsTooFast,  ///< u turns about as often as it is sampled: noise, or a faster cycle
  kStemBounded,   ///< a stem of limited speed or travel foretells y better
  // no stiction
  kCurveExplains,  ///< a bent characteristic foretells y, and no stem beside it
  // undecided
  kReadingCutOff,  ///< y is cut off at an end of its range, and that looks like a stem
};
inline constexpr int kReasons = static_cast<int>(Reason::kReadingCutOff) + 1;

/// Each reason has one verdict.
[[nodiscard]] constexpr Verdict verdict_of(Reason reason) {
  switch (reason) {
    case Reason::kSticksBothStrokes:
    case Reason::kSticksAscending:
    case Reason::kSticksDescending:
    case Reason::kSlipUnresolved:
    case Reason::kSticksUnderLoad:
    case Reason::kSticksTogether:
    case Reason::kStrokesUnresolved:
      return Verdict::kStiction;
    case Reason::kDeadbandOnly:
      return Verdict::kBacklash;
    case Reason::kLinearExplains:
    case Reason::kBandDoesNotMatter:
    case Reason::kNotTheValve:
    case Reason::kCurveExplains:
      return Verdict::kNoStiction;
    case Reason::kNotFinite:
      return Verdict::kBadData;
    default:
      return Verdict::kUndecided;
  }
}

/// The contract's sentence for a reason: what a technician should know or do.
[[nodiscard]] std::string_view sentence(Reason reason);

/// What a window says of its valve. Numbers are in the units of the recording unless said
/// otherwise.
template <class Real>
struct Findings {
  Verdict verdict = Verdict::kUndecided;
  Reason reason = Reason::kNone;
  OscillationReport<Real> oscillation;  ///< of u
  Real cycles = 0;                      ///< in the window
  PerStroke<Real> stick_band;           ///< units of u
  PerStroke<Real> slip_jump;            ///< units of u
  /// Smallest stick band that this window would have shown, units of u; 0: none.
  Real detectable_band = 0;
  Real fit_percent = 0;  ///< equation (23), two-path model
  /// The same search behind a linear valve, or that of the valve's forms: the better one.
  Real fit_linear_percent = 0;
  Real fit_valve_percent = 0;  ///< equation (23), physical valve
  ModelGapReport<Real> gap;    ///< where the physical valve's model fails
  Real residual_rms = 0;       ///< of that model, units of y; 0 unknown
};

/// The whole answer.
template <class Real>
struct Identification : Findings<Real> {
  Real aic = 0;              ///< equation (8)
  Real aic_linear = 0;       ///< of the search's linear valve; 0: it found none
  TwoPathModel<Real> model;  ///< the paper's model
  int gain_sign = 1;         ///< sign of the process gain, in model.process.b
  ValveModel<Real> valve;    ///< the physical valve; friction in units of u
  int decimation = 1;        ///< samples of the recording per sample of `valve`
  ControllerAction<Real> controller;
  Evidence<Real> evidence;
  LoopEvidence<Real> loop;
  RecordHealth<Real> health;
  Cause cause = Cause::kUnknown;  ///< of the movement of u and y
};

}  // namespace ident
