// Stretches of a recording that a reader should know of before trusting a fit to them.
#pragma once

#include <string_view>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

struct Mark {
  enum class Kind {
    kLimit,  ///< u rests at its lowest or highest value: the valve is not asked to move
    kRest,   ///< u keeps another value far longer than it usually does: manual mode
    kHeld,   ///< y keeps one value far longer than it usually does: a gap, compression,
             ///< or a reading that sticks
    kStraight,  ///< y runs on a straight line: drawn between stored points
    kStep,      ///< u jumps: a setpoint was changed, or someone moved the valve by hand
    kGap,       ///< no samples: the values before are held
    kManual,    ///< the file says that the controller is in manual
  };
  Kind kind = Kind::kLimit;
  double from_s = 0;  ///< time of its first and last sample
  double to_s = 0;
};

/// In the order of time, at most kMostMarks, longest first where there are more. A
/// stretch has at least kFewestMarked samples, one in manual any number, and u that
/// rests in manual is not told again; for kRest and kHeld ten times as many as
/// half of all values keep. A jump is a twentieth of the span of u or more between two
/// samples, and eight times what nine in ten of its moves are. O(samples).
[[nodiscard]] std::vector<Mark> marks_of(const Recording& recording);
inline constexpr std::size_t kFewestMarked = 10;
inline constexpr std::size_t kMostMarks = 200;

/// "limit", "rest", "held", "straight", "step", "gap", "manual".
[[nodiscard]] std::string_view name_of(Mark::Kind kind);

}  // namespace workbench
