// How much of u is what a controller with a constant setpoint makes of y.
#pragma once

#include <span>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// Shares of the squares of u, less a straight line, and of its changes, that a linear
/// PID controller makes of y: 0 … 1. Samples at an end of the way of u, where it stays
/// for three and more, are left out: a controller that stops there begins anew. 0 where u
/// does not move, or is elsewhere for less than a quarter of the samples.
struct LawShare {
  double of_level = 0;
  double of_changes = 0;
  bool integrates = false;  ///< the sum of y takes a third of what is left without it,
                            ///< with the sign that y has
  bool switches = false;    ///< u moves by four amounts or fewer, as a relay moves it
  bool leads = false;       ///< the change of y that follows leaves less than half
  double slope = 0;  ///< u by y; 0 where it is not seen beside the sum of y, from sample
                     ///< to sample, with one sign in all
};

/// `u` and `y` of one length, 1 or more; `pieces` cover it, each with a setpoint of its
/// own. O(samples).
[[nodiscard]] LawShare law_share(std::span<const double> u, std::span<const double> y,
                                 std::span<const Piece> pieces);

/// (W31) True where u holds nothing but such a law: a tenth of its squares at most are of
/// setpoints, hands, feedforward or a relay, and as little of its changes. A controller
/// whose gain depends on the error, or that reads another filter, and one whose output is
/// rounded leave up to nine tenths of its changes: they are known by their integrating
/// part. Where u switches, or is rounded so that it seems to, a hundredth of its squares
/// at most. Never where u leads without such a part: a process that follows u nearly
/// without noise.
[[nodiscard]] bool follows_law(const LawShare& share);

}  // namespace workbench
