// Small dense least squares over chosen stretches of long columns.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "workbench/model/base/blocks.hpp"

namespace workbench {

/// Coefficients that bring `columns` closest to `target` on the estimation blocks of
/// `rows`. A column that the others explain to 1e-9 of its size gets 0. Columns of one
/// length; O(rows·columns²). `extents`: the samples outside of which each column is zero;
/// then only what lies within two of them is summed.
[[nodiscard]] std::vector<double> least_squares(
    std::span<const std::span<const double>> columns, std::span<const double> target,
    std::span<const Block> rows, std::span<const SampleRange> extents = {});

/// Over the estimation blocks of `rows`.
[[nodiscard]] double sum_of_squares(std::span<const double> values,
                                    std::span<const Block> rows);

/// Σ a·b, four partial sums.
[[nodiscard]] double dot(std::span<const double> a, std::span<const double> b);

/// A symmetric positive semidefinite matrix, row by row, and its inverse. Directions
/// below 1e-12 of the largest diagonal entry (after scaling to a unit diagonal) get a
/// zero row and column.
[[nodiscard]] std::vector<double> inverse_spd(std::vector<double> matrix, std::size_t n);

}  // namespace workbench
