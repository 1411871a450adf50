// Means and values by rank.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace workbench {

/// Of at least one value. O(n).
[[nodiscard]] double mean_of(std::span<const double> values);

/// The values less their mean. O(n).
[[nodiscard]] std::vector<double> centred(std::span<const double> values);

/// Squared correlation; 0 where one of them rests. Equal lengths, at least 1. O(n).
[[nodiscard]] double squared_correlation(std::span<const double> a,
                                         std::span<const double> b);

/// From each of at least one value to the next.
[[nodiscard]] std::vector<double> intervals_of(std::span<const double> values);

/// The value of that rank, 0 the smallest, below the number of values; reorders them.
/// O(n).
[[nodiscard]] double of_rank(std::vector<double>& values, std::size_t rank);

/// Of at least one value; of an even count the mean of the two in the middle. O(n).
[[nodiscard]] double median(std::vector<double> values);

/// Equal, or gaps (NaN) both.
[[nodiscard]] bool are_alike(double a, double b);

}  // namespace workbench
