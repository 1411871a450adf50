// Least squares of the same columns for several targets.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "workbench/model/base/blocks.hpp"

namespace workbench {

/// Cholesky factor of an n × n matrix, row by row, with unit diagonal, in place in the
/// lower triangle. A row that leaves less than `dependent` of its squared size beside
/// those before it becomes zero.
void factor_spd(std::vector<double>& matrix, std::size_t n, double dependent);
/// Solves with such a factor, in place; 0 for its zero rows.
void solve_factored(const std::vector<double>& factor, std::size_t n,
                    std::vector<double>& target);

/// The normal equations of columns over the estimation blocks of `rows`, factored once;
/// `extents` as of least_squares(). What is referred to must outlive this.
class NormalEquations {
 public:
  NormalEquations(std::span<const std::span<const double>> columns,
                  std::span<const Block> rows, std::span<const SampleRange> extents);

  /// As least_squares() says of `target`.
  [[nodiscard]] std::vector<double> solve(std::span<const double> target) const;

 private:
  [[nodiscard]] SampleRange within(SampleRange range, std::size_t column) const;

  std::span<const std::span<const double>> columns_;
  std::span<const Block> rows_;
  std::span<const SampleRange> extents_;
  std::vector<double> scale_;
  std::vector<double> factor_;
};

}  // namespace workbench
