#include "workbench/recording/own_readings.hpp"

#include <algorithm>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

constexpr double kMadeOfThem = 0.9999;
// Parts with a memory begin somewhere, and are filtered.
constexpr double kPartAlike = 0.99;

std::vector<double> error_of(const Recording& recording) {
  std::vector<double> out = recording.y;
  if (!recording.has(Column::sp)) return out;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = recording.sp[k] - out[k];
  return out;
}

// The part of a controller's output that sums its error, or follows its steps.
bool is_part_with_memory(std::span<const double> values, std::span<const double> error) {
  const std::vector<double> steps = intervals_of(values);
  return squared_correlation(steps, error.subspan(1)) > kPartAlike ||
         squared_correlation(steps, error.first(steps.size())) > kPartAlike ||
         squared_correlation(values.subspan(1), intervals_of(error)) > kPartAlike;
}

}  // namespace

bool is_own_reading(const Recording& recording, const Load& load, double alike) {
  const bool is_column = std::ranges::any_of(kLoopColumns, [&](Column column) {
    return recording.has(column) &&
           squared_correlation(load.values, recording.values(column)) > alike;
  });
  if (is_column || !recording.has(Column::y) || recording.size() < 3) return is_column;
  const std::vector<double> error = error_of(recording);
  return squared_correlation(load.values, error) > alike ||
         is_part_with_memory(load.values, error);
}

std::vector<std::string> take_out_own_readings(Recording& recording,
                                               std::span<const std::string> kept) {
  std::vector<std::string> names;
  std::erase_if(recording.loads, [&](const Load& load) {
    const bool out = std::ranges::find(kept, load.name) == kept.end() &&
                     is_own_reading(recording, load, kMadeOfThem);
    if (out) names.push_back(load.name);
    return out;
  });
  return names;
}

void leave_out_own_readings(Recording& recording, std::span<const std::string> kept) {
  for (const std::string& name : take_out_own_readings(recording, kept)) {
    recording.resampling.notes.push_back(filled(
        "column {0} is made of u, y or the setpoint of the loop, sample by sample: "
        "no load of its own, left out",
        {name}));
  }
}

}  // namespace workbench
