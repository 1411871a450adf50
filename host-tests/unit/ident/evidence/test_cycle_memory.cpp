// What the cycle before tells of loads that keep a clock and of valves that do not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "ident/evidence/cycle_memory.hpp"
#include "support/ident/loop.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

double nats(const Signal& u, Signal y, double period, int budget = 1000000) {
  double mean = 0;
  for (const double v : y) mean += v / static_cast<double>(y.size());
  double square = 0;
  for (double& v : y) {
    v -= mean;
    square += v * v / static_cast<double>(y.size());
  }
  for (double& v : y) v /= std::sqrt(square);
  Signal scratch(u.size());
  OneStepSums<double> sums;
  EvidenceWindow<double> window;
  window.u = u;
  window.y = y;
  window.scratch = scratch;
  window.sums = &sums;
  window.period = period;
  CycleMemory<double> memory;
  memory.start(window);
  while (!memory.step(budget)) {
  }
  return memory.nats();
}

struct Loop {
  Signal u, y;
};

// A healthy loop that integrates away what a square load of this period brings.
Loop shaken(std::size_t samples, double period, double noise, double jitter = 0) {
  test::Random random(7);
  Loop out;
  double state = 0;
  double u = 0;
  double level = 1;
  double next = period / 2;
  for (std::size_t t = 0; t < samples; ++t) {
    if (static_cast<double>(t) >= next) {
      level = -level;
      next += period / 2 * (1 + jitter * test::normal(random));
    }
    state += 0.3 * (u - state);
    const double y = state + level + noise * test::normal(random);
    u -= 0.08 * y;
    out.u.push_back(u);
    out.y.push_back(y);
  }
  return out;
}

// From its passages through a band around the mean.
double period_of(const Signal& u) {
  const auto [low, high] = std::minmax_element(u.begin(), u.end());
  const double middle = (*low + *high) / 2;
  const double band = (*high - *low) / 8;
  int passages = 0;
  bool above = false;
  for (const double v : u) {
    const bool now = v > middle + (above ? -band : band);
    passages += now && !above ? 1 : 0;
    above = now;
  }
  return static_cast<double>(u.size()) / passages;
}

TEST(CycleMemory, ForetellsALoadThatKeepsAClock) {
  for (const double period : {25.0, 40.0, 90.0}) {
    const Loop loop = shaken(1500, period, 0.05);
    EXPECT_GT(nats(loop.u, loop.y, period), 100) << period;
  }
}

TEST(CycleMemory, ForetellsNoLoadThatKeepsNone) {
  const Loop loop = shaken(1500, 40, 0.05, 0.2);
  EXPECT_LT(nats(loop.u, loop.y, 40), 25);
}

TEST(CycleMemory, SaysLittleOfAValveThatSticks) {
  test::Random random(3);
  test::LoopSettings settings;
  settings.friction = {1, 4, 4, SlipMotion::kSlides};
  settings.noise = 0.3;
  const test::Window window = test::simulate_loop(settings, 1800, random);
  const double period = period_of(window.u);
  ASSERT_GT(period, 15);
  EXPECT_LT(nats(window.u, window.y, period), 25);
}

TEST(CycleMemory, IsTheSameInPieces) {
  const Loop loop = shaken(1500, 40, 0.05);
  EXPECT_EQ(nats(loop.u, loop.y, 40, 1), nats(loop.u, loop.y, 40));
}

TEST(CycleMemory, IsSilentWhereThereIsNoCycleToRemember) {
  const Loop loop = shaken(600, 40, 0.05);
  EXPECT_EQ(nats(loop.u, loop.y, 0), 0);
  EXPECT_EQ(nats(loop.u, loop.y, 7), 0);    // near lags know it
  EXPECT_EQ(nats(loop.u, loop.y, 400), 0);  // no three of them
  const Loop few = shaken(60, 12, 0.05);
  EXPECT_EQ(nats(few.u, few.y, 12), 0);  // too few samples to predict
}

}  // namespace
}  // namespace ident
