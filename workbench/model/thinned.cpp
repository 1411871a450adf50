#include "workbench/model/thinned.hpp"

#include <algorithm>

namespace workbench {
namespace {

std::vector<double> first_of_each(const std::vector<double>& values, std::size_t count) {
  std::vector<double> out;
  for (std::size_t k = 0; k + count <= values.size(); k += count) {
    out.push_back(values[k]);
  }
  return out;
}

std::vector<double> means_of(const std::vector<double>& values, std::size_t count) {
  std::vector<double> out;
  for (std::size_t k = 0; k + count <= values.size(); k += count) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += values[k + i];
    out.push_back(sum / static_cast<double>(count));
  }
  return out;
}

}  // namespace

std::size_t thinning_of(std::size_t samples, double memory_samples) {
  constexpr std::size_t kEnough = 5000;
  constexpr double kFewestOfMemory = 4;
  const auto most = static_cast<std::size_t>(memory_samples / kFewestOfMemory);
  return std::clamp<std::size_t>((samples + kEnough - 1) / kEnough, 1,
                                 std::max<std::size_t>(most, 1));
}

Recording thinned(const Recording& recording, std::size_t count) {
  Recording out;
  out.name = recording.name;
  out.units = recording.units;
  out.start = recording.start;
  out.resampling = recording.resampling;
  out.period_s = recording.period_s * static_cast<double>(count);
  for (const Column column : {Column::t, Column::y, Column::sp, Column::x}) {
    out.values(column) = first_of_each(recording.values(column), count);
  }
  for (const Load& load : recording.loads) {
    out.loads.push_back({load.name, load.unit, means_of(load.values, count)});
  }
  out.u = means_of(recording.u, count);
  return out;
}

}  // namespace workbench
