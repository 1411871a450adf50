#include "workbench/analysis/start_up.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "workbench/analysis/analysis.hpp"
#include "workbench/analysis/listening.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

// Share of the squares of y that a straight line over time takes away.
double straight_share(std::span<const double> y) {
  std::vector<double> time(y.size());
  std::iota(time.begin(), time.end(), 0.0);
  return squared_correlation(time, y);
}

}  // namespace

std::size_t start_up_end(std::span<const double> u, std::span<const double> y) {
  constexpr double kFar = 3;   // swings of the second half that a start-up moves u beyond
  constexpr double kNear = 1;  // swings off the middle that still are the limit cycle
  constexpr double kFewestCycles = 5;
  constexpr double kRunsAway = 0.5;  // share of y that a straight line takes away
  const std::size_t half = u.size() / 2;
  if (half < Identifier::kFewestSamples) return 0;
  const std::span<const double> late = u.subspan(half);
  const auto [low, high] = std::ranges::minmax_element(late);
  const double swing = *high - *low;
  const double middle = (*high + *low) / 2;
  const auto off = [middle](double value) { return std::abs(value - middle); };
  std::size_t end = half;
  while (end > 0 && off(u[end - 1]) <= kNear * swing) --end;
  const bool far = std::any_of(u.begin(), u.begin() + static_cast<std::ptrdiff_t>(end),
                               [&](double value) { return off(value) > kFar * swing; });
  if (!far) return 0;
  const Heard heard = listen(late);
  const bool cycles =
      heard.period > 0 && kFewestCycles * heard.period < static_cast<double>(late.size());
  return cycles && straight_share(y.subspan(half)) < kRunsAway ? end : 0;
}

}  // namespace workbench
