// Which of the signals seen on a bus could be u and y of a loop.
//
// Two signals belong together where one follows the other: the largest correlation of u
// with a later y. Which of them is u, two regressions tell. A controller computes each
// move of u from y and the y before it, so that these explain the moves of u nearly
// whole, with the setpoint where that moves; a process with a valve, noise and load does
// not compute y from u like that. Range (within 0 … 100), unit and name count as hints;
// signals whose names say that they are of two loops are the last to be paired.
// None of it is proof: what comes out is a proposal, with its reasons, the best first,
// each signal in one only.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "firmware/learn/seen_signal.hpp"

namespace firmware {

struct LoopProposal {
  std::size_t u = 0;  ///< index into the signals
  std::size_t y = 0;
  std::optional<std::size_t> sp = {};
  double correlation = 0;     ///< of u with y, lag_s later; −1 … 1
  double lag_s = 0;           ///< ≥ 0
  double controller_pct = 0;  ///< of the moves of u: explained by y as a controller would
  double process_pct = 0;     ///< of the moves of y: explained by u in the same way
  double period_s = 0;        ///< of u's oscillation; 0: none was seen
  /// Proposed: that of the frames where 2048 of them hold ten cycles or more.
  double sample_period_s = 1;
  bool names_agree = false;  ///< u and y are called so
  double score = 0;
};

inline constexpr std::size_t kMostProposals = 4;

/// Cost: quadratic in the signals that move.
[[nodiscard]] std::vector<LoopProposal> propose_loops(
    const std::vector<SeenSignal>& signals);

}  // namespace firmware
