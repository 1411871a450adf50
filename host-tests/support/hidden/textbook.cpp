#include "support/hidden/textbook.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace hidden {
namespace {

double misfit_at(std::span<const double> u, std::span<const double> y,
                 double lag_samples) {
  const double pole = std::exp(-1 / lag_samples);
  const double centre = u[0];
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double energy = 0;
  double filtered = 0;
  double decay = 1;
  for (std::size_t k = 0; k < y.size(); ++k) {
    const Eigen::Vector3d row(filtered, decay, 1);
    const double value = y[k] - y[0];
    gram += row * row.transpose();
    moment += value * row;
    energy += value * value;
    filtered = pole * filtered + (1 - pole) * (u[k] - centre);
    decay *= pole;
  }
  const Eigen::Vector3d best = gram.completeOrthogonalDecomposition().solve(moment);
  const double left = energy - 2 * best.dot(moment) + best.dot(gram * best);
  return std::sqrt(std::max(0.0, left) / static_cast<double>(y.size()));
}

}  // namespace

double textbook_misfit(std::span<const double> u, std::span<const double> y) {
  constexpr int kGrid = 60;
  const double low = std::log(1.0 / 3);
  const double high = std::log(static_cast<double>(y.size()));
  const double spacing = (high - low) / kGrid;
  const auto at = [&](double log_lag) { return misfit_at(u, y, std::exp(log_lag)); };
  double best = low;
  double least = at(low);
  for (int i = 1; i <= kGrid; ++i) {
    const double misfit = at(low + spacing * i);
    if (misfit < least) {
      least = misfit;
      best = low + spacing * i;
    }
  }
  for (double step = spacing / 2; step > spacing / 200; step /= 2) {
    for (const double candidate : {best - step, best + step}) {
      const double inside = std::clamp(candidate, low, high);
      const double misfit = at(inside);
      if (misfit < least) {
        least = misfit;
        best = inside;
      }
    }
  }
  return least;
}

}  // namespace hidden
