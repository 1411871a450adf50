#include "workbench/model/base/least_squares.hpp"

#include <cmath>

#include "workbench/model/base/normal_equations.hpp"

namespace workbench {
double dot(std::span<const double> a, std::span<const double> b) {
  // As many partial sums as keep the adders busy; their order is fixed.
  constexpr std::size_t kSums = 8;
  double sums[kSums] = {};
  std::size_t k = 0;
  for (; k + kSums <= a.size(); k += kSums) {
    for (std::size_t i = 0; i < kSums; ++i) sums[i] += a[k + i] * b[k + i];
  }
  for (; k < a.size(); ++k) sums[0] += a[k] * b[k];
  return ((sums[0] + sums[1]) + (sums[2] + sums[3])) +
         ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

double sum_of_squares(std::span<const double> values, std::span<const Block> rows) {
  double sum = 0;
  for (const Block& block : rows) {
    if (!block.estimation) continue;
    const auto part = values.subspan(block.first, block.last - block.first);
    sum += dot(part, part);
  }
  return sum;
}

std::vector<double> least_squares(std::span<const std::span<const double>> columns,
                                  std::span<const double> target,
                                  std::span<const Block> rows,
                                  std::span<const SampleRange> extents) {
  return NormalEquations(columns, rows, extents).solve(target);
}

std::vector<double> inverse_spd(std::vector<double> matrix, std::size_t n) {
  std::vector<double> scale(n);
  for (std::size_t i = 0; i < n; ++i) {
    scale[i] = matrix[i * n + i] > 0 ? 1 / std::sqrt(matrix[i * n + i]) : 0;
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) matrix[i * n + j] *= scale[i] * scale[j];
  }
  factor_spd(matrix, n, 1e-12);
  std::vector<double> inverse(n * n, 0.0);
  for (std::size_t j = 0; j < n; ++j) {
    if (matrix[j * n + j] == 0) continue;
    std::vector<double> unit(n, 0.0);
    unit[j] = 1;
    solve_factored(matrix, n, unit);
    for (std::size_t i = 0; i < n; ++i)
      inverse[i * n + j] = unit[i] * scale[i] * scale[j];
  }
  return inverse;
}

}  // namespace workbench
