// Lags, dead time and integrators against their closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "workbench/effects/process_shape.hpp"

namespace workbench {
namespace {

constexpr double kPeriod = 2;

std::vector<double> step(std::size_t n) {
  std::vector<double> u(n, 1.0);
  u[0] = 0;
  return u;
}

std::vector<double> response(const ProcessShape& shape, const std::vector<double>& in) {
  std::vector<double> scratch;
  std::vector<double> out(in.size());
  respond(shape, kPeriod, in, scratch, out);
  return out;
}

// The step comes with sample 1, so t counts from there.
double since(std::size_t k) {
  return kPeriod * (static_cast<double>(k) - 1);
}

TEST(ProcessShape, OneLagIsExactForAStep) {
  ProcessShape shape;
  shape.first_lag_s = 7;
  const auto y = response(shape, step(30));
  for (std::size_t k = 1; k < y.size(); ++k) {
    EXPECT_NEAR(y[k], 1 - std::exp(-since(k) / 7), 1e-12) << k;
  }
}

TEST(ProcessShape, ADirectionalLagIsExactBothWays) {
  for (const double second : {0.0, 3.0}) {
    ProcessShape shape;
    shape.first_lag_s = 7;
    shape.second_lag_s = second;
    const auto rising = response(shape, step(300));
    shape.falling_over_rising = 4;
    std::vector<double> u = step(600);
    std::fill(u.begin() + 300, u.end(), 0.0);
    const auto y = response(shape, u);
    for (std::size_t k = 1; k < 300; ++k) EXPECT_NEAR(y[k], rising[k], 1e-12) << k;
    shape.first_lag_s = 28;
    shape.falling_over_rising = 1;
    const auto slow = response(shape, step(300));
    for (std::size_t k = 301; k < 599; ++k) {
      EXPECT_NEAR(y[k], 1 - slow[k - 299], 1e-9) << k;
    }
  }
}

TEST(ProcessShape, ATailComesThroughALagOfItsOwn) {
  ProcessShape shape;
  shape.first_lag_s = 7;
  const auto fast = response(shape, step(200));
  shape.second_lag_s = 60;
  const auto both = response(shape, step(200));
  shape.second_lag_s = 0;
  shape.tail_share = 0.3;
  shape.tail_lag_s = 60;
  const auto y = response(shape, step(200));
  for (std::size_t k = 0; k < y.size(); ++k) {
    EXPECT_NEAR(y[k], 0.7 * fast[k] + 0.3 * both[k], 3e-4) << k;
  }
}

TEST(ProcessShape, ALagMayWriteOverItsInput) {
  const std::vector<double> in = {0, 3, 1, 4, 1, 5};
  std::vector<double> apart(in.size());
  lag(in, 1, 2, 0, apart);
  std::vector<double> over = in;
  lag(over, 1, 2, 0, over);
  EXPECT_EQ(over, apart);
  lag_of_lines(in, 1, 2, apart);
  over = in;
  lag_of_lines(over, 1, 2, over);
  EXPECT_EQ(over, apart);
}

TEST(ProcessShape, TwoLagsAreExactForAStepEqualOnesIncluded) {
  for (const double second : {0.3, 3.0, 7.0, 7.0000001, 40.0}) {
    ProcessShape shape;
    shape.first_lag_s = 7;
    shape.second_lag_s = second;
    const auto y = response(shape, step(30));
    for (std::size_t k = 1; k < y.size(); ++k) {
      const double t = since(k);
      const double expected =
          std::abs(second - 7) < 1e-3
              ? 1 - (1 + t / 7) * std::exp(-t / 7)
              : 1 - (7 * std::exp(-t / 7) - second * std::exp(-t / second)) /
                        (7 - second);
      EXPECT_NEAR(y[k], expected, 1e-6) << second << ' ' << k;
    }
  }
}

// In small steps: a first storage that is full passes on a share of what it cannot hold.
TEST(ProcessShape, AFullFirstStorageSpillsIntoTheSecond) {
  for (const double share : {0.0, 0.6, 1.0}) {
    ProcessShape shape;
    shape.first_lag_s = 60;
    shape.second_lag_s = 90;
    shape.brim = 1.5;
    shape.spill_share = share;
    std::vector<double> in(200, 1.0);
    for (std::size_t k = 20; k < 120; ++k) in[k] = 2;
    const auto y = response(shape, in);
    double z1 = 1;
    double z2 = 1;
    constexpr int kSmall = 400;
    for (std::size_t k = 0; k < in.size(); ++k) {
      EXPECT_NEAR(y[k], z2, 2e-3) << share << ' ' << k;
      for (int i = 0; i < kSmall; ++i) {
        const bool full = z1 >= shape.brim && in[k] > shape.brim;
        const double spilt = full ? share * (in[k] - shape.brim) : 0;
        z2 += kPeriod / kSmall / shape.second_lag_s * (z1 + spilt - z2);
        z1 += kPeriod / kSmall / shape.first_lag_s * (in[k] - z1);
        z1 = std::min(z1, shape.brim);
      }
    }
  }
}

TEST(ProcessShape, ABrimThatIsNotReachedChangesNothing) {
  ProcessShape shape;
  shape.first_lag_s = 6;
  shape.second_lag_s = 9;
  const auto without = response(shape, step(30));
  shape.brim = 1.0;
  EXPECT_EQ(response(shape, step(30)), without);
  shape.second_lag_s = 0;
  shape.brim = 0.5;
  EXPECT_NEAR(response(shape, step(30)).back(), 1, 1e-3);
}

TEST(ProcessShape, OnlyTheLastOfTwoStoragesIsCurvedWhereAsked) {
  ProcessShape shape;
  shape.first_lag_s = 6;
  shape.second_lag_s = 9;
  shape.storage = {2, 0, 1, false};
  const auto both = response(shape, step(30));
  shape.last_only = true;
  const auto last = response(shape, step(30));
  EXPECT_NE(both, last);
  EXPECT_NEAR(both.back(), last.back(), 0.05);
}

TEST(ProcessShape, DeadTimeShiftsBySamplesAndFractions) {
  const std::vector<double> in = {0, 1, 2, 3, 4, 5};
  std::vector<double> out(in.size());
  delay(in, kPeriod, 2 * kPeriod, 0, out);
  EXPECT_EQ(out, (std::vector<double>{0, 0, 0, 1, 2, 3}));
  delay(in, kPeriod, 1.25 * kPeriod, 0, out);
  EXPECT_EQ(out, (std::vector<double>{0, 0, 0.75, 1.75, 2.75, 3.75}));
}

TEST(ProcessShape, DeadTimeBeforeALagIsExactForAStep) {
  ProcessShape shape;
  shape.first_lag_s = 3;
  shape.dead_time_s = 2.7 * kPeriod;
  const auto y = response(shape, step(30));
  for (std::size_t k = 1; k < y.size(); ++k) {
    const double t = since(k) - 2.7 * kPeriod;
    EXPECT_NEAR(y[k], t > 0 ? 1 - std::exp(-t / 3) : 0, 1e-12) << k;
  }
}

TEST(ProcessShape, IntegratorsAddUpWithAndWithoutALag) {
  ProcessShape shape;
  shape.integrating = true;
  const auto y = response(shape, step(20));
  for (std::size_t k = 1; k < y.size(); ++k) EXPECT_NEAR(y[k], since(k), 1e-12);
  shape.second_lag_s = 5;
  const auto lagged = response(shape, step(20));
  for (std::size_t k = 1; k < y.size(); ++k) {
    EXPECT_NEAR(lagged[k], since(k) - 5 * (1 - std::exp(-since(k) / 5)), 1e-9);
  }
}

TEST(IntervalWeight, IsTheMeanThatALagSees) {
  for (const double next : {0.0, 3.0, 9.0, 50.0}) {
    const IntervalWeight weight{kPeriod, next};
    double sum = 0;
    double of_decay = 0;
    double of_ramp = 0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
      const double t = kPeriod * (i + 0.5) / kSteps;
      const double w = next > 0 ? std::exp((t - kPeriod) / next) : 1;
      sum += w;
      of_decay += w * std::exp(-t / 9);
      of_ramp += w * std::max(0.0, 1 - t / 1.3);
    }
    EXPECT_NEAR(weight.decay(9), of_decay / sum, 1e-6) << next;
    EXPECT_NEAR(weight.ramp_down(1.3), of_ramp / sum, 1e-6) << next;
  }
}

TEST(ProcessShape, ALagBeforeTheFirstIsExactlyASecond) {
  const std::vector<double> u = {0, 1, 1, 4, 4, -2, -2, -2, 0, 1};
  ProcessShape one;
  one.first_lag_s = 7;
  ProcessShape two = one;
  two.second_lag_s = 3;
  std::vector<double> v = u;
  lag_means({kPeriod, 7}, 3, v);
  const auto a = response(one, v);
  const auto b = response(two, u);
  for (std::size_t k = 0; k < u.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-12) << k;
}

TEST(ProcessShape, MeansOfALagKeepTheArea) {
  std::vector<double> v = step(200);
  lag_means({kPeriod, 0}, 9, v);
  double lost = 0;
  for (std::size_t k = 1; k < v.size(); ++k) lost += kPeriod * (1 - v[k]);
  EXPECT_NEAR(lost, 9, 1e-6);
}

TEST(ProcessShape, ALagOfLinesFollowsARampOneLagBehind) {
  std::vector<double> ramp(100);
  for (std::size_t k = 0; k < ramp.size(); ++k) ramp[k] = static_cast<double>(k);
  std::vector<double> out(ramp.size());
  lag_of_lines(ramp, kPeriod, 3 * kPeriod, out);
  EXPECT_NEAR(out.back(), ramp.back() - 3, 1e-9);
  lag_of_lines(ramp, kPeriod, 0, out);
  EXPECT_EQ(out, ramp);
}

TEST(ProcessShape, ADelayBeyondTheSignalLeavesItsStart) {
  const std::vector<double> in = {3, 4, 5};
  std::vector<double> out(in.size());
  for (const double time_s : {1e6, 1e300}) {
    delay(in, kPeriod, time_s, 2, out);
    EXPECT_EQ(out, std::vector<double>(3, 3.0)) << time_s;
  }
  delay(in, kPeriod, -5, 0, out);
  EXPECT_EQ(out, in);
}

TEST(ProcessShape, DecayIsAnExponential) {
  std::vector<double> out(10);
  decay(kPeriod, 4, out);
  EXPECT_DOUBLE_EQ(out[0], 1);
  EXPECT_NEAR(out[9], std::exp(-9 * kPeriod / 4), 1e-12);
}

}  // namespace
}  // namespace workbench
