#include "workbench/recording/statistics.hpp"

#include <algorithm>
#include <cmath>
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

double squared_correlation(std::span<const double> a, std::span<const double> b) {
  const double mean_a = mean_of(a);
  const double mean_b = mean_of(b);
  double aa = 0;
  double bb = 0;
  double ab = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    aa += (a[k] - mean_a) * (a[k] - mean_a);
    bb += (b[k] - mean_b) * (b[k] - mean_b);
    ab += (a[k] - mean_a) * (b[k] - mean_b);
  }
  return aa > 0 && bb > 0 ? ab * ab / (aa * bb) : 0;
}

std::vector<double> intervals_of(std::span<const double> values) {
  std::vector<double> out(values.size() - 1);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = values[i + 1] - values[i];
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

bool are_alike(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace workbench
