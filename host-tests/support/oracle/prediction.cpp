#include "support/oracle/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ident/evidence/lag_bins.hpp"

namespace test {
namespace {

// The first column and the fall from each column to the next.
Eigen::MatrixXd differences(const Eigen::MatrixXd& means) {
  Eigen::MatrixXd out = means;
  for (Eigen::Index b = 1; b < means.cols(); ++b) {
    out.col(b) = means.col(b - 1) - means.col(b);
  }
  return out;
}

}  // namespace

PredictionOracle::PredictionOracle(const std::vector<double>& y,
                                   const std::vector<double>& z,
                                   std::span<const ident::LagBin> bins)
    : bins_(bins),
      rows_(static_cast<Eigen::Index>(y.size()) - bins.back().last),
      reach_(bins.back().last),
      target_(rows_),
      plain_(rows_, static_cast<Eigen::Index>(2 * bins.size() + 1)),
      steps_(rows_, static_cast<Eigen::Index>(2 * bins.size() + 1)) {
  const Eigen::Map<const Eigen::VectorXd> values(y.data(),
                                                 static_cast<Eigen::Index>(y.size()));
  target_ = values.tail(rows_) - values.segment(reach_ - 1, rows_);
  const Eigen::MatrixXd of_y = means(y);
  const Eigen::MatrixXd of_z = means(z);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(rows_);
  plain_ << of_y, of_z, ones;
  steps_ << differences(of_y), ones, differences(of_z);
}

Eigen::MatrixXd PredictionOracle::means(const std::vector<double>& signal) const {
  Eigen::MatrixXd out =
      Eigen::MatrixXd::Zero(rows_, static_cast<Eigen::Index>(bins_.size()));
  const Eigen::Map<const Eigen::VectorXd> values(
      signal.data(), static_cast<Eigen::Index>(signal.size()));
  for (std::size_t b = 0; b < bins_.size(); ++b) {
    const ident::LagBin bin = bins_[b];
    const auto column = static_cast<Eigen::Index>(b);
    for (int lag = bin.first; lag <= bin.last; ++lag) {
      out.col(column) += values.segment(reach_ - lag, rows_);
    }
    out.col(column) /= bin.last - bin.first + 1;
  }
  return out;
}

double PredictionOracle::least_error() const {
  const Eigen::VectorXd best = plain_.colPivHouseholderQr().solve(target_);
  return (target_ - plain_ * best).squaredNorm();
}

double PredictionOracle::least_error_beside(const std::vector<double>& w,
                                            std::size_t newest) const {
  const auto beside = static_cast<Eigen::Index>(std::min(newest, bins_.size()));
  Eigen::MatrixXd all(rows_, plain_.cols() + beside);
  all << plain_, means(w).leftCols(beside);
  const Eigen::VectorXd best = all.colPivHouseholderQr().solve(target_);
  return (target_ - all * best).squaredNorm();
}

// One row more for each column, in which it is asked to be 0.
Eigen::VectorXd PredictionOracle::weights(const Eigen::VectorXd& of,
                                          double disbelief) const {
  const Eigen::Index count = steps_.cols();
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(rows_ + count, count);
  all.topRows(rows_) = steps_;
  for (Eigen::Index k = 0; k < count; ++k) {
    all(rows_ + k, k) = std::sqrt(disbelief) * steps_.col(k).norm();
  }
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(rows_ + count);
  wanted.head(rows_) = of;
  return all.householderQr().solve(wanted);
}

double PredictionOracle::left(const Eigen::VectorXd& of, double disbelief) const {
  const Eigen::VectorXd best = weights(of, disbelief);
  const Eigen::VectorXd sizes = steps_.colwise().norm().transpose();
  return (of - steps_ * best).squaredNorm() +
         disbelief * sizes.cwiseProduct(best).squaredNorm();
}

double PredictionOracle::error(double disbelief) const {
  return left(target_, disbelief);
}

double PredictionOracle::planted(const std::vector<double>& w, double disbelief) const {
  const Eigen::VectorXd of_z =
      weights(target_, disbelief).tail(static_cast<Eigen::Index>(bins_.size()));
  return left(differences(means(w)) * of_z, disbelief);
}

}  // namespace test
