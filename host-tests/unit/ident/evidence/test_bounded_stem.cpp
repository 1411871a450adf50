// What stems of limited speed and travel tell of valves that are slow, stop, or stick.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ident/evidence/bounded_stem.hpp"
#include "ident/evidence/closed_loop_evidence.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using Values = std::vector<double>;

struct Bounded {
  double nats = 0;
  Bound bound = Bound::kSpeed;
};

Bounded weighed(const Values& u, Values y, double period, double swing,
                int budget = 1000000) {
  double mean = 0;
  for (const double v : y) mean += v / static_cast<double>(y.size());
  for (double& v : y) v -= mean;
  Values scratch(u.size());
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

struct Moved {
  Values u, y;
};

// A lag moved to and fro by u, through a valve.
template <class Valve>
Moved swinging(Valve valve) {
  test::Random random(5);
  Moved out;
  double stem = 0;
  double state = 0;
  double load = 0;
  for (int t = 0; t < 1500; ++t) {
    const double u = 4 * std::sin(2 * M_PI * t / 50) + 0.3 * test::normal(random);
    state += 0.2 * (stem - state);
    stem = valve(u);
    load = 0.98 * load + 0.02 * test::normal(random);
    out.u.push_back(u);
    out.y.push_back(state + load + 0.02 * test::normal(random));
  }
  return out;
}

Moved slow() {
  return swinging([stem = 0.0](double u) mutable {
    return stem += std::clamp(u - stem, -0.25, 0.25);
  });
}

TEST(BoundedStem, KnowsAStemOfLimitedSpeed) {
  const Moved loop = slow();
  const Bounded found = weighed(loop.u, loop.y, 50, 8);
  EXPECT_GT(found.nats, 100);
  EXPECT_EQ(found.bound, Bound::kSpeed);
}

TEST(BoundedStem, KnowsAStemThatStopsAtAnEnd) {
  const Moved loop = swinging([](double u) { return std::min(u, 1.5); });
  const Bounded found = weighed(loop.u, loop.y, 50, 8);
  EXPECT_GT(found.nats, 100);
  EXPECT_EQ(found.bound, Bound::kTravel);
}

TEST(BoundedStem, SaysNothingOfOneThatFollows) {
  const Moved loop = swinging([](double u) { return u; });
  EXPECT_LT(weighed(loop.u, loop.y, 50, 8).nats, 5);
}

TEST(BoundedStem, SaysLessOfOneThatSticksThanTheStemThatDoes) {
  const ValveFriction<double> friction{1, 2, 2, SlipMotion::kSlides};
  const StickSlipValve<double> valve(friction, 0.0);
  const Moved loop = swinging([v = valve](double u) mutable { return v.step(u); });
  Values scratch(loop.u.size());
  OneStepSums<double> sums;
  ClosedLoopEvidence<double> sticks;
  sticks.start_with({loop.u, loop.y, scratch, &sums, 50, 8, 8}, valve, 0, kCoarseLagBins);
  while (!sticks.step(1000)) {
  }
  EXPECT_GT(sticks.nats(), 2 * weighed(loop.u, loop.y, 50, 8).nats);
}

TEST(BoundedStem, IsTheSameInPieces) {
  const Moved loop = slow();
  EXPECT_EQ(weighed(loop.u, loop.y, 50, 8, 1).nats, weighed(loop.u, loop.y, 50, 8).nats);
}

TEST(BoundedStem, IsSilentInAWindowTooShort) {
  const Moved loop = slow();
  const Values u(loop.u.begin(), loop.u.begin() + 65);
  const Values y(loop.y.begin(), loop.y.begin() + 65);
  EXPECT_EQ(weighed(u, y, 50, 8).nats, 0);
  EXPECT_EQ(weighed(loop.u, loop.y, 0, 8).nats, 0);
}

}  // namespace
}  // namespace ident
