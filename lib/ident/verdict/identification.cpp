#include "ident/verdict/identification.hpp"

#include <array>

namespace ident {
namespace {

struct Sentence {
  Reason reason;
  std::string_view text;
};

constexpr std::array kSentences = std::to_array<Sentence>({
    {Reason::kNone, ""},
    {Reason::kSticksBothStrokes,
     "The valve sticks on both strokes: a sticking stem foretells the process output "
     "better than the controller output does."},
    {Reason::kSticksAscending,
     "The valve sticks when the controller output rises, not when it falls."},
    {Reason::kSticksDescending,
     "The valve sticks when the controller output falls, not when it rises."},
    {Reason::kSlipUnresolved,
     "The valve sticks: the loop hunts across its stick band, which play alone keeps up "
     "only where the process stores, as a level does. The slip jump is too small to be "
     "measured."},
    {Reason::kDeadbandOnly,
     "The valve has play: it loses part of each stroke at every reversal, but moves "
     "smoothly after that."},
    {Reason::kSticksUnderLoad,
     "The valve sticks: a sticking stem foretells the process output better than the "
     "controller output does. Loads move the process output as well, so its slip jumps "
     "cannot be measured."},
    {Reason::kLinearExplains,
     "A valve that follows the controller output explains the process output as well "
     "as a sticking one."},
    {Reason::kBandDoesNotMatter,
     "A small stick band was found, too small against the swing of the controller "
     "output to matter."},
    {Reason::kNotTheValve,
     "The controller output swings, but no valve, sticking or not, explains the process "
     "output from it: look at the tuning, other loops and the sensor first."},
    {Reason::kConstant,
     "A signal does not move: record the loop while it is in automatic and "
     "oscillating."},
    {Reason::kTooShort,
     "Too few samples: record at least five cycles of the oscillation, with 10 samples"
     " or more a cycle."},
    {Reason::kOneStroke,
     "The controller output moves one way only, or turns back too little: record more "
     "cycles, or step the setpoint up and down. Where the process output does not "
     "follow, the valve is stuck or nothing flows: stroke it by hand."},
    {Reason::kTooFewCycles,
     "Too few reversals to see a pattern repeat: record twice as long, or longer, or "
     "more steps of the controller output up and down with the loop in manual."},
    {Reason::kAtLimit,
     "The controller output rests at its limit much of the time, where the valve is "
     "not asked to move: record the loop away from its limits."},
    {Reason::kSetpointMoves,
     "The moving setpoint explains the movement, and a sticking valve would add too "
     "little to be sure: record with a constant setpoint, or small steps of the "
     "controller output up and down with the loop in manual."},
    {Reason::kModelTooPoor,
     "Most of the process output does not come from this valve in this recording: "
     "record while the loop oscillates, or small steps of the controller output up and "
     "down with the loop in manual."},
    {Reason::kEvidenceTooWeak,
     "Something speaks for a sticking valve, not enough to be sure: "
     "record more cycles, or small steps of the controller output up and down with the"
     " loop in manual."},
    {Reason::kBandBelowResolution,
     "A stick band would be lost between the values that the signals take: record with "
     "finer resolution, or with a controller output that takes more values."},
    {Reason::kBandWouldNotShow,
     "Nothing speaks for a sticking valve, but in this recording a stick band that "
     "matters would not have shown: record while the controller output moves more, or "
     "for longer."},
    {Reason::kStemUnconfirmed,
     "A sticking valve describes the recording as a whole, but its stem does not "
     "foretell the process output from one sample to the next: loads, the tuning or a "
     "controller that acts between the samples may look so. Record at the controller's "
     "own rate, or small steps of the controller output up and down with the loop in "
     "manual."},
    {Reason::kSticksTogether,
     "The valve sticks: one stick band explains all windows, and together they leave no "
     "doubt."},
    {Reason::kStrokesUnresolved,
     "The valve sticks; whether on one stroke or on both, this recording cannot tell."},
    {Reason::kWindowsDisagree,
     "Windows of this loop seem to want different valves, and no stick band serves all"
     " of them: it may not be the valve. Record longer without a change of the loop."},
    {Reason::kNotFinite, "A sample is not a finite number: repair the recording."},
    {Reason::kSensorSticks,
     "The process output holds its value exactly while the controller output runs on, "
     "then jumps: look at the transmitter, not at the valve."},
    {Reason::kSignalsSwapped,
     "The column read as process output is the controller output: exchange the columns,"
     " or name the process output."},
    {Reason::kSeam,
     "Two recordings were joined in this one: record or judge each alone."},
    {Reason::kCompressed,
     "The historian stored too few points to tell a stick band from what it put between "
     "them: record with its compression off."},
    {Reason::kLoadRepeats,
     "A load that comes back at its own time moves the process output, and this "
     "recording "
     "does not tell it from a sticking valve: put the controller in manual. If the "
     "oscillation stays, it comes from elsewhere."},
    {Reason::kTurnsTooFast,
     "The controller output turns at nearly every sample: it follows noise, or a cycle "
     "that is too fast for this sample period. Record with 10 samples or more a cycle, "
     "or with a setpoint step."},
    {Reason::kStemBounded,
     "A valve that moves slowly, or a process that answers less beyond some controller "
     "output (a travel stop, a limit downstream, a curve), foretells the process output "
     "better than a valve that sticks."},
    {Reason::kCurveExplains,
     "The process output answers more to the controller output at one end of its swing "
     "than at the other: that bent characteristic foretells it, and a sticking valve "
     "adds nothing."},
    {Reason::kReadingCutOff,
     "The process output rests at an end of its range, to the last digit, as a reading "
     "that is cut off does, and that looks like a sticking valve: record where it stays "
     "inside."},
});

}  // namespace

std::string_view sentence(Reason reason) {
  for (const Sentence& one : kSentences) {
    if (one.reason == reason) {
      return one.text;
    }
  }
  return "";
}

}  // namespace ident
