// Loops that oscillate together, and the one that moves the others.
#pragma once

#include <vector>

#include "workbench/screen/screened_loop.hpp"

namespace workbench {

/// What the past of the signals of `leader` adds to the past of `follower`'s own, one
/// step ahead, in nats; the price of the added terms is taken off, and less than nothing
/// is nothing.
[[nodiscard]] double explained_by(const Rhythm& leader, const Rhythm& follower);

/// Numbers the groups (group, leads, group_is, lag_s), the largest cost first.
///
/// Two loops belong together where they oscillate with one period and hold their phase
/// to each other over the time that both were recorded: coherence above kLeastCoherence.
/// The leader is the loop with the best score: the closed-loop evidence that its own
/// valve sticks, and how much of the others its signals foretell beyond what theirs
/// foretell of it. A leader without evidence of a valve that sticks makes the group one
/// that no valve explains. O(n log n) to find candidates, then the pairs of a group.
void find_groups(std::vector<ScreenedLoop>& loops);

/// Notes at each loop that oscillates which others are not compared with it, since their
/// zones may have several meanings (of_one_clock()), and what to do.
void note_zones(std::vector<ScreenedLoop>& loops);

inline constexpr double kFewestCycles = 8;
inline constexpr double kLeastCoherence = 0.8;

/// What a group costs is its leader's, where that is a valve: it pays for those that it
/// shakes, which are left with a part of their cost and suspicion.
void share_costs(std::vector<ScreenedLoop>& loops);

}  // namespace workbench
