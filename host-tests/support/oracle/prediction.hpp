// One-step prediction by dense least squares: every row written out, in double.
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "ident/evidence/lag_bins.hpp"

namespace test {

/// Rows t = reach … N − 1 of the prediction of y(t) − y(t−1) from means of
/// lags of y, of a further signal z, and a constant (docs/model.md, E10).
class PredictionOracle {
 public:
  PredictionOracle(const std::vector<double>& y, const std::vector<double>& z,
                   std::span<const ident::LagBin> bins);

  /// Squared error of ordinary least squares on the means of lags as they are.
  [[nodiscard]] double least_error() const;
  /// The same with another signal beside z, or only so many of its newest bins.
  [[nodiscard]] double least_error_beside(
      const std::vector<double>& w,
      std::size_t newest = std::numeric_limits<std::size_t>::max()) const;
  /// Least sum of the squared error and of the share `disbelief` of what each column
  /// takes part with, the columns being differences of neighbouring means.
  [[nodiscard]] double error(double disbelief) const;
  /// What the regression on z says of w's part in y, Σ weight·mean, is regressed on all
  /// columns: what is left of its squares, with the same disbelief.
  [[nodiscard]] double planted(const std::vector<double>& w, double disbelief) const;

 private:
  [[nodiscard]] Eigen::MatrixXd means(const std::vector<double>& signal) const;
  [[nodiscard]] Eigen::VectorXd weights(const Eigen::VectorXd& of,
                                        double disbelief) const;
  [[nodiscard]] double left(const Eigen::VectorXd& of, double disbelief) const;

  std::span<const ident::LagBin> bins_;
  Eigen::Index rows_;
  Eigen::Index reach_;
  Eigen::VectorXd target_;
  Eigen::MatrixXd plain_;  // means of y, of z, 1
  Eigen::MatrixXd steps_;  // the first mean, differences of means; of y, 1, of z
};

}  // namespace test
