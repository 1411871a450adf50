// Which stretches without samples are too long to hold the value before.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "workbench/recording/recording.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {

/// How many instants without a sample of their own, at least 10, are no ordinary pause
/// between two of the strictly increasing times `t`: three times as many as 19 of 20
/// intervals have. A historian that stores only what changes has no gaps where nothing
/// does; where nearly all its intervals differ there is none at all. O(n).
[[nodiscard]] std::size_t shortest_gap(std::span<const double> t, const Spacing& spacing);

/// "2 long gaps are not judged: ..." `period_s` is that of the samples.
[[nodiscard]] std::string note_on_gaps(const std::vector<SampleRange>& gaps,
                                       double period_s);

/// Of `resampling.gaps` keeps those over which holding u and y would invent their motion:
/// as long as u or y need to move, on average, by half their standard deviation; for a
/// sine that is a twelfth of its period; and those over which u or y did move by half as
/// much, at a time that nobody knows. Only samples outside of the gaps count.
/// All of them where there is neither. O(n log n).
void keep_long_gaps(Recording& recording);

}  // namespace workbench
