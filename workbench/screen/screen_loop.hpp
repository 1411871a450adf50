// From the recordings of one loop to its line in the result.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "workbench/recording/recording.hpp"
#include "workbench/screen/screened_loop.hpp"

namespace workbench {

/// The verdict that `identify` gives on the same recordings, with what a ranking needs:
/// share of the time oscillating, trend, rhythm, picture. At least one recording;
/// `clocks` (one each) name whose time t is where no date is known. `stop` is asked every
/// few milliseconds; Stopped is thrown where it says so. The time is that of Analysis at
/// Depth::kVerdict, one or two tenths of a second for each window of 3,000 samples.
[[nodiscard]] ScreenedLoop screen_loop(std::vector<Recording> recordings,
                                       const std::vector<std::string>& clocks,
                                       const std::function<bool()>& stop);

/// Fills `suspicion` and `cost`. The suspicion follows the verdict first; within one
/// verdict the closed-loop evidence, and how much better a sticking valve runs free. The
/// cost is the suspicion, more for a loop that oscillates all the time and whose band is
/// a large share of the swing of u: 100 is a valve that surely sticks, with a band as
/// wide as its travel, all the time. It orders loops; it is no sum of money.
void rate(ScreenedLoop& loop);

}  // namespace workbench
