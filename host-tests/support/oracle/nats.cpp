#include "support/oracle/nats.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "workbench/recording/statistics.hpp"
#include "workbench/simulate/cycles.hpp"

namespace workbench::test {
namespace {

constexpr Eigen::Index kLags = 20;

// Least squared error over the variance of y.
double prediction_error(std::span<const double> y, std::span<const double> input) {
  const auto rows = static_cast<Eigen::Index>(y.size()) - kLags;
  const double y_mean = mean_of(y);
  const double y_std = std_of(y);
  const double input_mean = mean_of(input);
  const double input_std = std_of(input);
  Eigen::MatrixXd columns(rows, 2 * kLags + 1);
  Eigen::VectorXd target(rows);
  const auto at = [](std::span<const double> signal, Eigen::Index t) {
    return signal[static_cast<std::size_t>(t)];
  };
  for (Eigen::Index row = 0; row < rows; ++row) {
    const Eigen::Index t = row + kLags;
    target(row) = (at(y, t) - y_mean) / y_std;
    for (Eigen::Index lag = 1; lag <= kLags; ++lag) {
      columns(row, lag - 1) = (at(y, t - lag) - y_mean) / y_std;
      columns(row, kLags + lag - 1) =
          input_std > 0 ? (at(input, t - lag) - input_mean) / input_std : 0.0;
    }
    columns(row, 2 * kLags) = 1;
  }
  const Eigen::VectorXd weights = columns.colPivHouseholderQr().solve(target);
  return (target - columns * weights).squaredNorm();
}

}  // namespace

double oracle_nats(std::span<const double> y, std::span<const double> signal,
                   std::span<const double> stem) {
  if (!(std_of(y) > 0)) return 0;
  const double samples = static_cast<double>(y.size()) - static_cast<double>(kLags);
  const double by_signal = prediction_error(y, signal);
  const double by_stem = prediction_error(y, stem);
  // Below this, rounding decides.
  const double least = 1e-20 * samples;
  if (by_signal <= least || by_stem <= least) return 0;
  return samples / 2 * std::log(by_signal / by_stem);
}

}  // namespace workbench::test
