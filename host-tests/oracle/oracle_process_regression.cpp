// The regression behind a valve against dense least squares with every column written
// out.
#include <gtest/gtest.h>

#include <cmath>

#include "ident/process/process_regression.hpp"
#include "support/ident/all_at_once.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using test::Random;

constexpr Eigen::Index kBefore = 20;

// x through both poles, from kBefore samples before the window on, in which x stood at
// its first value. By convolution with the impulse response, or as a running sum.
Eigen::VectorXd filtered(const Eigen::VectorXd& x, const ProcessPoles<double>& poles) {
  const Eigen::VectorXd centred = x.array() - x.mean();
  const Eigen::Index n = x.size();
  Eigen::VectorXd z = Eigen::VectorXd::Zero(kBefore + n);
  if (poles.slow < 1) {
    // h(k) = (1 − p)(1 − q)·Σ p^i·q^(k−i); its sum up to k gives what the past adds.
    const Eigen::Index length = 4000;
    Eigen::VectorXd h(length);
    double slow = 0;
    double fast = 0;
    for (Eigen::Index k = 0; k < length; ++k) {
      slow = poles.slow * slow + (k == 0 ? 1 : 0);
      fast = poles.fast * fast + slow;
      h(k) = (1 - poles.slow) * (1 - poles.fast) * fast;
    }
    for (Eigen::Index t = -kBefore; t < n; ++t) {
      for (Eigen::Index k = 0; k < length; ++k) {
        z(kBefore + t) += h(k) * centred(std::max<Eigen::Index>(t - k, 0));
      }
    }
    return z;
  }
  const Eigen::Index settle = 400;
  double slow = -static_cast<double>(settle) * centred(0);
  double fast = 0;
  for (Eigen::Index t = -settle; t < n; ++t) {
    slow += centred(std::max<Eigen::Index>(t, 0));
    fast = poles.fast * fast + slow;
    if (t >= -kBefore) {
      z(kBefore + t) = (1 - poles.fast) * 16.0 / static_cast<double>(n) * fast;
    }
  }
  return z;
}

struct DenseFit {
  double error = INFINITY;
  int delay = 0;
};

DenseFit dense_fit(const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                   const ProcessPoles<double>& poles, int first, int last, bool drift) {
  const Eigen::VectorXd z = filtered(x, poles);
  const Eigen::Index n = x.size();
  DenseFit best;
  for (int delay = first; delay <= last; ++delay) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, 6);
    for (Eigen::Index t = 0; t < n; ++t) {
      const double time = static_cast<double>(t);
      a(t, 0) = z(kBefore + t - delay);
      a(t, 1) = z(kBefore + t - delay - 1);
      a(t, 2) = 1;
      a(t, 3) = drift ? 2 * time / static_cast<double>(n) - 1 : 0;
      a(t, 4) = poles.slow < 1 ? std::pow(poles.slow, time) : 0;
      a(t, 5) = poles.fast > 0 ? std::pow(poles.fast, time) : 0;
    }
    const Eigen::MatrixXd q = a.transpose() * a;
    const Eigen::VectorXd c = a.transpose() * y;
    const double error = y.squaredNorm() + 2 * test::exhaustive_minimum(q, c, 3);
    if (error < best.error - 1e-12) {
      best = {error, delay};
    }
  }
  return best;
}

TEST(ProcessRegressionOracle, FitAgreesWithDenseLeastSquares) {
  Random random(33);
  ProcessRegression<double> regression;
  const ProcessPoles<double> all[] = {{0, 0},      {0.9, 0},   {0.95, 0.4},
                                      {0.8, 0.79}, {0.7, 0.7}, {1, 0},
                                      {1, 0.7},    {0.99, 0},  {0.99, 0.5}};
  for (int k = 0; k < 180; ++k) {
    SCOPED_TRACE(k);
    const Eigen::Index n = 20 + static_cast<Eigen::Index>(random() % 300);
    const ProcessPoles<double>& poles = all[k % 9];
    Eigen::VectorXd x(n);
    double level = 0;
    for (Eigen::Index t = 0; t < n; ++t) {
      if (random() % 8 == 0) {
        level = test::normal(random);
      }
      x(t) = level;
    }
    Eigen::VectorXd y = 0.5 * filtered(x, poles).tail(n);
    for (double& value : y) {
      value += 0.5 * test::normal(random) + 0.3;
    }
    const int first = static_cast<int>(random() % 4);
    const int last = std::min(first + static_cast<int>(random() % 8), kDelayTaps - 2);
    const bool drift = random() % 2 == 0;
    const auto fit =
        test::fit(regression, {x.data(), static_cast<std::size_t>(n)},
                  {y.data(), static_cast<std::size_t>(n)}, poles, first, last, drift);
    const DenseFit dense = dense_fit(x, y, poles, first, last, drift);
    ASSERT_NEAR(fit.error, dense.error, 1e-7 * y.squaredNorm());
    EXPECT_GE(fit.delay, first);
    EXPECT_LE(fit.delay, last);
  }
}

}  // namespace
}  // namespace ident
