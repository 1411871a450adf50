#include "workbench/recording/further_signals.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/recording/column_name.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/spelling/column_words.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

constexpr std::size_t kLeastRun = 8;  // 7 rises in a row are one chance in 40,000
constexpr double kNearlyAll = 0.9;    // of the steps; the others held, for want of rows

// Steps that go `way` (1 or -1), and those that hold.
struct Steps {
  std::vector<double> on;
  std::size_t held = 0;
  std::vector<std::size_t> restarts;  // first values after a step the other way
};

Steps steps_of(std::span<const double> values, double way) {
  Steps out;
  for (std::size_t k = 1; k < values.size(); ++k) {
    const double step = way * (values[k] - values[k - 1]);
    if (step > 0) out.on.push_back(step);
    if (step == 0) ++out.held;
    if (step < 0) out.restarts.push_back(k);
  }
  return out;
}

// Equal steps, each run but the first from the same value on and none of them short.
bool is_clock(std::span<const double> values, const Steps& steps) {
  constexpr double kAlike = 0.1;  // of a step: rounding
  const double usual = median(steps.on);
  const auto alike = [usual](double step) {
    return std::abs(step - usual) <= kAlike * usual;
  };
  const auto equal = static_cast<double>(std::ranges::count_if(steps.on, alike));
  if (equal < kNearlyAll * static_cast<double>(steps.on.size())) return false;
  std::size_t before = 0;
  for (const std::size_t k : steps.restarts) {
    const double off = std::abs(values[k] - values[steps.restarts.front()]);
    const bool is_short = before > 0 && k - before < kLeastRun;
    if (is_short || off > usual) return false;
    before = k;
  }
  return true;
}

}  // namespace

bool is_count(std::span<const double> values) {
  if (values.size() < kLeastRun) return false;
  for (const double way : {1.0, -1.0}) {
    const Steps steps = steps_of(values, way);
    const auto on = static_cast<double>(steps.on.size());
    const bool goes_on = steps.on.size() + 1 >= kLeastRun &&
                         on >= kNearlyAll * (on + static_cast<double>(steps.held));
    if (goes_on && (steps.restarts.empty() || is_clock(values, steps))) return true;
  }
  return false;
}

std::vector<std::string> names_of_moving(const std::vector<Load>& loads) {
  std::vector<std::string> out;
  for (const Load& load : loads) {
    const auto [low, high] = std::ranges::minmax_element(load.values);
    const bool moves = low != high && *low < *high;
    const bool wanted = part_hinted(column_name(load.name).pieces) == Part::kSp;
    if (moves && !wanted && !is_count(load.values)) out.push_back(load.name);
  }
  return out;
}

std::string first_three(const std::vector<std::string>& names) {
  return first_listed(names, {.things = 3});
}

}  // namespace workbench
