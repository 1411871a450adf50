// How y answers a step of u, as seen one sample ahead beside the past of y.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace workbench::effects {

/// Drawn from what a linear regression leaves uncertain; draws[0] is the most likely one.
struct StepResponse {
  std::vector<std::vector<double>> draws;  ///< all of one length; empty: cannot be told
};

/// Regresses y on its own ten samples before and on those of u, every `apart` samples,
/// and follows the answer to a step of u over some sixty. In a closed loop, too, a load
/// of any colour is in the past of y, and so does not pass for an answer to u. 200 draws;
/// deterministic. O(n).
[[nodiscard]] StepResponse step_response_of(std::span<const double> u,
                                            std::span<const double> y, std::size_t apart);

/// `apart` for a response that takes `time_s`: so that it lasts some eight of them.
[[nodiscard]] std::size_t samples_within(double period_s, double time_s);

/// By how many standard deviations the response goes the wrong way before it goes where
/// it ends; 0 where it does not.
[[nodiscard]] double wrong_way(const StepResponse& response);

/// By how many standard deviations the response falls back behind its peak.
[[nodiscard]] double swing_back(const StepResponse& response);

}  // namespace workbench::effects
