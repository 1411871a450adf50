#include "workbench/model/base/normal_equations.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/model/base/least_squares.hpp"

namespace workbench {
namespace {

constexpr double kDependent = 1e-11;  // squared size left of a scaled column

double product(std::span<const double> a, std::span<const double> b, SampleRange range) {
  const std::size_t count = range.last - range.first;
  return dot(a.subspan(range.first, count), b.subspan(range.first, count));
}

}  // namespace

void factor_spd(std::vector<double>& matrix, std::size_t n, double dependent) {
  std::vector<double>& a = matrix;
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

void solve_factored(const std::vector<double>& factor, std::size_t n,
                    std::vector<double>& target) {
  const std::vector<double>& l = factor;
  std::vector<double>& b = target;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= l[i * n + k] * b[k];
    b[i] = l[i * n + i] > 0 ? b[i] / l[i * n + i] : 0;
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= l[k * n + i] * b[k];
    b[i] = l[i * n + i] > 0 ? b[i] / l[i * n + i] : 0;
  }
}

NormalEquations::NormalEquations(std::span<const std::span<const double>> columns,
                                 std::span<const Block> rows,
                                 std::span<const SampleRange> extents)
    : columns_(columns),
      rows_(rows),
      extents_(extents),
      scale_(columns.size()),
      factor_(columns.size() * columns.size(), 0.0) {
  const std::size_t n = columns_.size();
  for (const Block& block : rows_) {
    if (!block.estimation) continue;
    for (std::size_t i = 0; i < n; ++i) {
      const SampleRange range = within({block.first, block.last}, i);
      if (range.first == range.last) continue;
      for (std::size_t j = 0; j <= i; ++j) {
        factor_[i * n + j] += product(columns_[i], columns_[j], within(range, j));
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    scale_[i] = factor_[i * n + i] > 0 ? 1 / std::sqrt(factor_[i * n + i]) : 0;
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) factor_[i * n + j] *= scale_[i] * scale_[j];
  }
  factor_spd(factor_, n, kDependent);
}

SampleRange NormalEquations::within(SampleRange range, std::size_t column) const {
  if (extents_.empty()) return range;
  const SampleRange& own = extents_[column];
  range.first = std::max(range.first, own.first);
  range.last = std::max(range.first, std::min(range.last, own.last));
  return range;
}

std::vector<double> NormalEquations::solve(std::span<const double> target) const {
  const std::size_t n = columns_.size();
  std::vector<double> b(n, 0.0);
  for (const Block& block : rows_) {
    if (!block.estimation) continue;
    for (std::size_t i = 0; i < n; ++i) {
      const SampleRange range = within({block.first, block.last}, i);
      if (range.first < range.last) b[i] += product(columns_[i], target, range);
    }
  }
  for (std::size_t i = 0; i < n; ++i) b[i] *= scale_[i];
  solve_factored(factor_, n, b);
  for (std::size_t i = 0; i < n; ++i) b[i] *= scale_[i];
  return b;
}

}  // namespace workbench
