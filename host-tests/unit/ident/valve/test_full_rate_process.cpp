// A process found on means, solved again on every sample.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include "ident/valve/full_rate_process.hpp"
#include "support/ident/all_at_once.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

struct RateLoop {
  Signal stem;
  Signal y;
};

// Square wave through a lag of 40 samples and a dead time; y of unit variance.
RateLoop make_loop(std::size_t dead_time) {
  RateLoop loop;
  double state = 0;
  for (std::size_t t = 0; t < 1200; ++t) {
    loop.stem.push_back(t / 100 % 2 == 0 ? 0 : 1);
    const double x = t >= dead_time ? loop.stem[t - dead_time] : 0;
    state = std::exp(-1 / 40.0) * state + (1 - std::exp(-1 / 40.0)) * x;
    loop.y.push_back(state);
  }
  const double mean = std::accumulate(loop.y.begin(), loop.y.end(), 0.0) / 1200;
  double square = 0;
  for (double& value : loop.y) {
    value -= mean;
    square += value * value;
  }
  for (double& value : loop.y) {
    value /= std::sqrt(square / 1200);
  }
  return loop;
}

FullRateProcess<double> solve(const RateLoop& loop, const ValveModel<double>& model,
                              int decimation) {
  const auto regression = std::make_unique<ProcessRegression<double>>();
  auto process =
      begin_full_rate_process<double>(model, decimation, loop.stem, loop.y, *regression);
  test::finish(*regression);
  process.fit = regression->result();
  return process;
}

FullRateProcess<double> solve(const RateLoop& loop, int decimation, int delay) {
  ValveModel<double> model;
  model.poles.slow = std::exp(-decimation / 40.0);
  model.fit.delay = delay;
  return solve(loop, model, decimation);
}

// Samples, what the second tap adds included.
double dead_time_of(const FullRateProcess<double>& process) {
  const auto& fit = process.fit;
  return static_cast<double>(process.delay) + fit.delay +
         fit.gain_b / (fit.gain_a + fit.gain_b);
}

TEST(FullRateProcess, TakesThePolesToTheRateOfTheRecording) {
  const auto process = solve(make_loop(5), 4, 1);
  EXPECT_NEAR(process.poles.slow, std::exp(-1 / 40.0), 1e-12);
  EXPECT_EQ(process.poles.fast, 0);
  EXPECT_EQ(process.delay, 0u);
  EXPECT_NEAR(dead_time_of(process), 5, 1e-3);
  EXPECT_GT(process.fit_percent(1200), 99.9);
}

// 12 means of 4 samples: more than the fit itself would try.
TEST(FullRateProcess, ReachesLongDeadTimes) {
  const auto process = solve(make_loop(48), 4, 12);
  EXPECT_EQ(process.delay, 40u);
  EXPECT_NEAR(dead_time_of(process), 48, 1e-2);
  EXPECT_GT(process.fit_percent(1200), 99);
}

TEST(FullRateProcess, LetsOnlyAnIntegratorDrift) {
  const RateLoop loop = make_loop(5);
  EXPECT_FALSE(solve(loop, 1, 5).fit.drifts);
  ValveModel<double> model;
  model.poles.slow = 1;
  const auto process = solve(loop, model, 3);
  EXPECT_EQ(process.poles.slow, 1);
  EXPECT_TRUE(process.fit.drifts);
}

}  // namespace
}  // namespace ident
