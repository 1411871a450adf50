#include "workbench/recording/statistics.hpp"

#include <algorithm>
#include <numeric>

namespace workbench {

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(values.size());
}

std::vector<double> centred(std::span<const double> values) {
  std::vector<double> out(values.begin(), values.end());
  if (out.empty()) return out;
  const double mean = mean_of(values);
  for (double& value : out) value -= mean;
  return out;
}

double of_rank(std::vector<double>& values, std::size_t rank) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double median(std::vector<double> values) {
  const std::size_t middle = values.size() / 2;
  const double upper = of_rank(values, middle);
  if (values.size() % 2 == 1) return upper;
  const auto end = values.begin() + static_cast<std::ptrdiff_t>(middle);
  return (upper + *std::max_element(values.begin(), end)) / 2;
}

}  // namespace workbench
