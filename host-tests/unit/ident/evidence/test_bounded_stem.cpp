// What stems of limited speed and travel tell of valves that are slow, stop, or stick.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "ident/evidence/bounded_stem.hpp"
#include "support/ident/loop.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

struct Bounded {
  double nats = 0;
  Bound bound = Bound::kSpeed;
};

Bounded weighed(const Signal& u, Signal y, double period, double swing,
                int budget = 1000000) {
  double mean = 0;
  for (const double v : y) mean += v / static_cast<double>(y.size());
  for (double& v : y) v -= mean;
  Signal scratch(u.size());
  OneStepSums<double> sums;
  EvidenceWindow<double> window;
  window.u = u;
  window.y = y;
  window.scratch = scratch;
  window.sums = &sums;
  window.period = period;
  window.swing = swing;
  BoundedStem<double> stem;
  stem.start(window);
  while (!stem.step(budget)) {
  }
  return {stem.nats(), stem.bound()};
}

struct Loop {
  Signal u, y;
};

// A lag moved to and fro by u, through a stem of limited speed and with an upper end.
Loop swinging(double speed, double end, double period = 50) {
  test::Random random(5);
  Loop out;
  double stem = 0;
  double state = 0;
  double load = 0;
  for (int t = 0; t < 1500; ++t) {
    const double u = 4 * std::sin(2 * M_PI * t / period) + 0.3 * test::normal(random);
    stem += std::clamp(std::min(u, end) - stem, -speed, speed);
    state += 0.2 * (stem - state);
    load = 0.98 * load + 0.05 * test::normal(random);
    out.u.push_back(u);
    out.y.push_back(state + load + 0.02 * test::normal(random));
  }
  return out;
}

TEST(BoundedStem, KnowsAStemOfLimitedSpeed) {
  const Loop loop = swinging(0.25, 100);
  const Bounded found = weighed(loop.u, loop.y, 50, 8);
  EXPECT_GT(found.nats, 100);
  EXPECT_EQ(found.bound, Bound::kSpeed);
}

TEST(BoundedStem, KnowsAStemThatStopsAtAnEnd) {
  const Loop loop = swinging(100, 1.5);
  const Bounded found = weighed(loop.u, loop.y, 50, 8);
  EXPECT_GT(found.nats, 100);
  EXPECT_EQ(found.bound, Bound::kTravel);
}

TEST(BoundedStem, SaysNothingOfOneThatFollows) {
  const Loop loop = swinging(100, 100);
  EXPECT_LT(weighed(loop.u, loop.y, 50, 8).nats, 5);
}

TEST(BoundedStem, SaysLessOfOneThatSticksThanTheStemThatDoes) {
  test::Random random(3);
  test::LoopSettings settings;
  settings.friction = {1, 4, 4, SlipMotion::kSlides};
  settings.noise = 0.3;
  const test::Window window = test::simulate_loop(settings, 1800, random);
  const auto [low, high] = std::minmax_element(window.u.begin(), window.u.end());
  const Bounded found = weighed(window.u, window.y, 40, *high - *low);
  Signal y = window.y;
  Signal scratch(y.size());
  OneStepSums<double> sums;
  EvidenceWindow<double> asked{window.u, y, scratch, &sums, 40, *high - *low, 1};
  ClosedLoopEvidence<double> sticks;
  sticks.start_with(asked, {settings.friction, window.u[0]}, 0, kCoarseLagBins);
  while (!sticks.step(1000)) {
  }
  EXPECT_GT(sticks.nats(), found.nats + 10);
}

TEST(BoundedStem, IsTheSameInPieces) {
  const Loop loop = swinging(0.25, 100);
  EXPECT_EQ(weighed(loop.u, loop.y, 50, 8, 1).nats, weighed(loop.u, loop.y, 50, 8).nats);
}

TEST(BoundedStem, IsSilentInAWindowTooShort) {
  const Loop loop = swinging(0.25, 100);
  const Signal u(loop.u.begin(), loop.u.begin() + 110);
  const Signal y(loop.y.begin(), loop.y.begin() + 110);
  EXPECT_EQ(weighed(u, y, 50, 8).nats, 0);
  EXPECT_EQ(weighed(loop.u, loop.y, 0, 8).nats, 0);
}

}  // namespace
}  // namespace ident
