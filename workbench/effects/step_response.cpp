#include "workbench/effects/step_response.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

namespace workbench::effects {
namespace {

constexpr std::size_t kOrder = 10;  // lags of y and of u
constexpr std::size_t kSteps = 60;  // of the response
constexpr std::size_t kDraws = 200;

// theta: kOrder of y, kOrder of u, the mean.
std::vector<double> followed(const Eigen::VectorXd& theta) {
  std::vector<double> y(kSteps, 0.0);
  for (std::size_t k = 1; k < kSteps; ++k) {
    for (std::size_t lag = 1; lag <= kOrder && lag <= k; ++lag) {
      y[k] += theta[static_cast<Eigen::Index>(lag - 1)] * y[k - lag] +
              theta[static_cast<Eigen::Index>(kOrder + lag - 1)];
    }
  }
  return y;
}

// Mean of a contrast over its standard deviation, over the draws but the first.
template <class Contrast>
double score(const StepResponse& response, const Contrast& contrast) {
  double mean = 0;
  double square = 0;
  const auto n = static_cast<double>(response.draws.size() - 1);
  for (std::size_t i = 1; i < response.draws.size(); ++i) {
    const double value = contrast(response.draws[i]);
    mean += value / n;
    square += value * value / n;
  }
  const double spread = std::sqrt(std::max(square - mean * mean, 0.0));
  return spread > 0 && std::isfinite(spread) ? contrast(response.draws[0]) / spread : 0;
}

}  // namespace

std::size_t samples_within(double period_s, double time_s) {
  constexpr double kWithin = 8;
  return static_cast<std::size_t>(std::clamp(time_s / (kWithin * period_s), 1.0, 1e6));
}

StepResponse step_response_of(std::span<const double> u, std::span<const double> y,
                              std::size_t apart) {
  StepResponse out;
  const std::size_t count = y.size() / apart;
  constexpr auto kUnknown = static_cast<Eigen::Index>(2 * kOrder + 1);
  if (count < 4 * kOrder + 10) return out;
  // y at the end of each interval, u as its mean over the interval before.
  std::vector<double> v(count, 0.0);
  std::vector<double> z(count);
  for (std::size_t i = 0; i < count; ++i) {
    z[i] = y[i * apart] - y[0];
    for (std::size_t k = 0; k < apart; ++k) {
      v[i] +=
          (u[std::min(i * apart + k, u.size() - 1)] - u[0]) / static_cast<double>(apart);
    }
  }
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(kUnknown, kUnknown);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(kUnknown);
  Eigen::VectorXd row(kUnknown);
  double power = 0;
  for (std::size_t i = kOrder; i < count; ++i) {
    for (std::size_t lag = 1; lag <= kOrder; ++lag) {
      row[static_cast<Eigen::Index>(lag - 1)] = z[i - lag];
      row[static_cast<Eigen::Index>(kOrder + lag - 1)] = v[i - lag];
    }
    row[kUnknown - 1] = 1;
    a.selfadjointView<Eigen::Lower>().rankUpdate(row);
    b += z[i] * row;
    power += z[i] * z[i];
  }
  Eigen::MatrixXd full = a.selfadjointView<Eigen::Lower>();
  full.diagonal() *= 1 + 1e-10;
  const Eigen::LLT<Eigen::MatrixXd> factor(full);
  if (factor.info() != Eigen::Success) return out;
  const Eigen::VectorXd theta = factor.solve(b);
  const double degrees =
      static_cast<double>(count - kOrder) - static_cast<double>(kUnknown);
  const double variance = std::max(power - theta.dot(b), 0.0) / degrees;
  out.draws.push_back(followed(theta));
  std::minstd_rand random(1);
  for (std::size_t draw = 0; draw < kDraws; ++draw) {
    Eigen::VectorXd normal(kUnknown);
    for (double& value : normal) {
      // Twelve uniform draws: near enough to normal, and the same on every machine.
      value = -6;
      for (int i = 0; i < 12; ++i) {
        value += static_cast<double>(random()) / static_cast<double>(random.max());
      }
    }
    const Eigen::VectorXd off = factor.matrixU().solve(normal);
    out.draws.push_back(followed(theta + std::sqrt(variance) * off));
  }
  return out;
}

double wrong_way(const StepResponse& response) {
  if (response.draws.empty()) return 0;
  const std::vector<double>& likely = response.draws[0];
  const auto [low, high] = std::ranges::minmax_element(likely);
  // The larger excursion is where it goes; the other one counts if it comes first.
  const bool rises = *high > -*low;
  const auto goal = rises ? high : low;
  const auto turn = rises ? std::min_element(likely.begin(), goal)
                          : std::max_element(likely.begin(), goal);
  const auto at = static_cast<std::size_t>(turn - likely.begin());
  const double sign = rises ? -1 : 1;
  if (!(sign * likely[at] > 0)) return 0;
  return score(response, [&](const std::vector<double>& y) { return sign * y[at]; });
}

double swing_back(const StepResponse& response) {
  if (response.draws.empty()) return 0;
  const std::vector<double>& likely = response.draws[0];
  const auto [low, high] = std::ranges::minmax_element(likely);
  const bool rises = *high > -*low;
  const auto peak = rises ? high : low;
  const auto trough =
      rises ? std::min_element(peak, likely.end()) : std::max_element(peak, likely.end());
  const auto from = static_cast<std::size_t>(peak - likely.begin());
  const auto to = static_cast<std::size_t>(trough - likely.begin());
  const double sign = rises ? 1 : -1;
  return score(response,
               [&](const std::vector<double>& y) { return sign * (y[from] - y[to]); });
}

}  // namespace workbench::effects
