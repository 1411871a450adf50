// The regression behind a valve against dense least squares with every column written
// out.
#include <gtest/gtest.h>

#include <cmath>

#include "ident/process_regression.hpp"
#include "support/ident_problems.hpp"

namespace ident {
namespace {

using test::Random;

// x through both poles by convolution with the impulse response, from the steady state of
// its first sample: the past is continued with x(0).
Eigen::VectorXd filtered(const Eigen::VectorXd& x, const ProcessPoles<double>& poles) {
  const Eigen::VectorXd centred = x.array() - x.mean();
  const Eigen::Index n = x.size();
  Eigen::VectorXd z = Eigen::VectorXd::Zero(n);
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
    for (Eigen::Index t = 0; t < n; ++t) {
      for (Eigen::Index k = 0; k < length; ++k) {
        z(t) += h(k) * centred(std::max<Eigen::Index>(t - k, 0));
      }
    }
    return z;
  }
  double slow = 0;
  double fast = 0;
  for (Eigen::Index t = 0; t < n; ++t) {
    slow += centred(t);
    fast = poles.fast * fast + slow;
    z(t) = (1 - poles.fast) * 16.0 / static_cast<double>(n) * fast;
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
  const double before = poles.slow < 1 ? z(0) : 0.0;
  // Before the window the output was that of a steady x(0).
  const double held = poles.slow < 1 ? x(0) - x.mean() : before;
  DenseFit best;
  for (int delay = first; delay <= last; ++delay) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, 6);
    for (Eigen::Index t = 0; t < n; ++t) {
      const double time = static_cast<double>(t);
      a(t, 0) = t >= delay ? z(t - delay) : held;
      a(t, 1) = t >= delay + 1 ? z(t - delay - 1) : held;
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
  const ProcessPoles<double> all[] = {{0, 0},     {0.9, 0}, {0.95, 0.4}, {0.8, 0.79},
                                      {0.7, 0.7}, {1, 0},   {1, 0.7}};
  for (int k = 0; k < 140; ++k) {
    SCOPED_TRACE(k);
    const Eigen::Index n = 20 + static_cast<Eigen::Index>(random() % 300);
    const ProcessPoles<double>& poles = all[k % 7];
    Eigen::VectorXd x(n);
    double level = 0;
    for (Eigen::Index t = 0; t < n; ++t) {
      if (random() % 8 == 0) {
        level = test::normal(random);
      }
      x(t) = level;
    }
    Eigen::VectorXd y = 0.5 * filtered(x, poles);
    for (double& value : y) {
      value += 0.5 * test::normal(random) + 0.3;
    }
    const int first = static_cast<int>(random() % 4);
    const int last = std::min(first + static_cast<int>(random() % 8), kDelayTaps - 2);
    const bool drift = random() % 2 == 0;
    const auto fit = regression.fit({x.data(), static_cast<std::size_t>(n)},
                                    {y.data(), static_cast<std::size_t>(n)}, poles, first,
                                    last, drift);
    const DenseFit dense = dense_fit(x, y, poles, first, last, drift);
    ASSERT_NEAR(fit.error, dense.error, 1e-7 * y.squaredNorm());
    EXPECT_GE(fit.delay, first);
    EXPECT_LE(fit.delay, last);
  }
}

}  // namespace
}  // namespace ident
