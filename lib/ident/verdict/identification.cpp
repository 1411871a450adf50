#include "ident/verdict/identification.hpp"

namespace ident {

std::string_view sentence(Reason reason) {
  switch (reason) {
    case Reason::kNone:
      return "";
    case Reason::kSticksBothStrokes:
      return "The valve sticks and slips on both strokes: a sticking valve explains the "
             "process output much better than one that follows the controller.";
    case Reason::kSticksAscending:
      return "The valve sticks when the controller output rises, not when it falls.";
    case Reason::kSticksDescending:
      return "The valve sticks when the controller output falls, not when it rises.";
    case Reason::kSlipUnresolved:
      return "The valve sticks: the loop hunts across its stick band, which play alone "
             "could "
             "not keep up. The slip jump is too small to be measured.";
    case Reason::kDeadbandOnly:
      return "The valve has play: it loses part of each stroke at every reversal, but "
             "moves smoothly after that.";
    case Reason::kSticksUnderLoad:
      return "The valve sticks: a sticking stem foretells the process output better than "
             "the controller output does. Loads move the process output as well, so its "
             "strokes cannot be told apart.";
    case Reason::kLinearExplains:
      return "A valve that follows the controller output explains the process output as "
             "well as a sticking one.";
    case Reason::kBandDoesNotMatter:
      return "A small stick band was found, too small against the swing of the "
             "controller "
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
    case Reason::kOneStroke:
      return "The controller output moves one way only: record more cycles, or step the "
             "setpoint up and down. Where the process output does not follow, the valve "
             "is stuck or nothing flows: stroke it by hand.";
    case Reason::kTooFewCycles:
      return "Too few reversals to see a pattern repeat: record at least five cycles.";
    case Reason::kAtLimit:
      return "The controller output rests at its limit much of the time, where the valve "
             "is not asked to move: record the loop away from its limits.";
    case Reason::kSetpointMoves:
      return "The moving setpoint explains the movement, and a sticking valve would add "
             "too little to be sure: record with a constant setpoint.";
    case Reason::kModelTooPoor:
      return "Most of the process output does not come from this valve in this "
             "recording: "
             "record while the loop oscillates, or step the setpoint.";
    case Reason::kEvidenceTooWeak:
      return "A sticking valve explains the recording a little better, not enough to be "
             "sure: record more cycles, or small steps of the controller output up and "
             "down with the loop in manual.";
    case Reason::kBandBelowResolution:
      return "A stick band would be lost in the resolution of the signals: record with "
             "finer resolution, or while the loop moves more.";
    case Reason::kBandWouldNotShow:
      return "Nothing speaks for a sticking valve, but in this recording a stick band "
             "that matters would not have shown: record while the controller output "
             "moves more, or for longer.";
    case Reason::kStemUnconfirmed:
      return "A sticking valve describes the recording as a whole, but its stem does not "
             "foretell the process output from one sample to the next: loads or the "
             "tuning may look like a valve here. Record again, with a setpoint step.";
    case Reason::kSticksTogether:
      return "The valve sticks: no window alone is sure, but one stick band explains all "
             "of them, and together they leave no doubt.";
    case Reason::kStrokesUnresolved:
      return "The valve sticks; whether on one stroke or on both, this recording cannot "
             "tell.";
    case Reason::kWindowsDisagree:
      return "Windows of this loop seem to want different valves, and no stick band "
             "serves all of them: it may not be the valve. Record longer without a "
             "change of the loop.";
    case Reason::kNotFinite:
      return "A sample is not a finite number: repair the recording.";
    case Reason::kSensorSticks:
      return "The process output holds its value exactly while the controller output "
             "runs on, then jumps: look at the transmitter, not at the valve.";
    case Reason::kSignalsSwapped:
      return "The column read as process output is the controller output: exchange the "
             "columns.";
    case Reason::kSeam:
      return "Two recordings were joined in this one: record or judge each alone.";
    case Reason::kCompressed:
      return "The historian stored too few points to tell a stick band from the lines "
             "between them: record with its compression off.";
  }
  return "";
}

}  // namespace ident
