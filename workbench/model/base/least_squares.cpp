#include "workbench/model/base/least_squares.hpp"

#include <algorithm>
#include <cmath>

namespace workbench {
namespace {

constexpr double kDependent = 1e-11;  // squared size left of a scaled column

// Cholesky factor of a matrix with unit diagonal, in place in the lower triangle; a
// dependent row becomes zero with a zero pivot.
void factor(std::vector<double>& a, std::size_t n, double dependent) {
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = a[i * n + j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i * n + k] * a[j * n + k];
      if (i == j) {
        a[i * n + i] = sum > dependent ? std::sqrt(sum) : 0;
      } else {
        a[i * n + j] = a[j * n + j] > 0 ? sum / a[j * n + j] : 0;
      }
    }
    if (a[i * n + i] == 0) {
      for (std::size_t j = 0; j < i; ++j) a[i * n + j] = 0;
    }
  }
}

void solve_factored(const std::vector<double>& l, std::size_t n, std::vector<double>& b) {
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= l[i * n + k] * b[k];
    b[i] = l[i * n + i] > 0 ? b[i] / l[i * n + i] : 0;
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= l[k * n + i] * b[k];
    b[i] = l[i * n + i] > 0 ? b[i] / l[i * n + i] : 0;
  }
}

}  // namespace

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
  const std::size_t n = columns.size();
  const auto within = [&extents](SampleRange range, std::size_t column) {
    if (extents.empty()) return range;
    const SampleRange& own = extents[column];
    range.first = std::max(range.first, own.first);
    range.last = std::max(range.first, std::min(range.last, own.last));
    return range;
  };
  const auto product = [](std::span<const double> a, std::span<const double> b,
                          SampleRange range) {
    const std::size_t count = range.last - range.first;
    return dot(a.subspan(range.first, count), b.subspan(range.first, count));
  };
  std::vector<double> a(n * n, 0.0);
  std::vector<double> b(n, 0.0);
  for (const Block& block : rows) {
    if (!block.estimation) continue;
    for (std::size_t i = 0; i < n; ++i) {
      const SampleRange range = within({block.first, block.last}, i);
      if (range.first == range.last) continue;
      b[i] += product(columns[i], target, range);
      for (std::size_t j = 0; j <= i; ++j) {
        a[i * n + j] += product(columns[i], columns[j], within(range, j));
      }
    }
  }
  std::vector<double> scale(n);
  for (std::size_t i = 0; i < n; ++i) {
    scale[i] = a[i * n + i] > 0 ? 1 / std::sqrt(a[i * n + i]) : 0;
  }
  for (std::size_t i = 0; i < n; ++i) {
    b[i] *= scale[i];
    for (std::size_t j = 0; j <= i; ++j) a[i * n + j] *= scale[i] * scale[j];
  }
  factor(a, n, kDependent);
  solve_factored(a, n, b);
  for (std::size_t i = 0; i < n; ++i) b[i] *= scale[i];
  return b;
}

std::vector<double> inverse_spd(std::vector<double> matrix, std::size_t n) {
  std::vector<double> scale(n);
  for (std::size_t i = 0; i < n; ++i) {
    scale[i] = matrix[i * n + i] > 0 ? 1 / std::sqrt(matrix[i * n + i]) : 0;
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) matrix[i * n + j] *= scale[i] * scale[j];
  }
  factor(matrix, n, 1e-12);
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
