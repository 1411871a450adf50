// The whitening filter by hand, and the rivals on loops whose truth is known.
#include <gtest/gtest.h>

#include <vector>

#include "ident/in_place_identifier.hpp"
#include "ident/verdict/load_rival.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

// 1, 3, 2 with memory ½ and smoothing ¼, at rest before: ⅔, 3 − ½ + ⅙, 2 − 1½ + ⅔.
TEST(Whiten, FollowsItsDifferenceEquation) {
  Signal e{1, 3, 2};
  whiten<double>({0.5, 0.25}, e);
  EXPECT_NEAR(e[0], 2.0 / 3, 1e-12);
  EXPECT_NEAR(e[1], 8.0 / 3, 1e-12);
  EXPECT_NEAR(e[2], 7.0 / 6, 1e-12);
}

TEST(Whiten, LeavesAWhiteLoadAlone) {
  Signal e{1, -2, 4};
  whiten<double>({}, e);
  EXPECT_EQ(e, (Signal{1, -2, 4}));
}

TEST(Whiten, TakesAConstantFromALoadThatNeverForgets) {
  Signal e(20, 7.0);
  whiten<double>({1, 0.3}, e);
  for (const double value : e) {
    EXPECT_NEAR(value, 0, 1e-12);
  }
}

using Answer = Identification<double>;

// What is found in a loop with few setpoint steps, worked out in slices of `budget`.
Answer identify(const char* scenario, std::uint64_t seed, int budget) {
  static InPlaceIdentifier<double, kLargeWindow> identifier;
  const auto loop = workbench::simulate(scenario, seed);
  Signal u = loop->u;
  Signal y = loop->y;
  identifier.start(u, y, loop->sp);
  while (!identifier.step(budget)) {
  }
  return identifier.result();
}

// Running free a stem at rest is far better there; a load foresees y as well.
TEST(LoadRival, DoesAsWellAsAStemAtRest) {
  for (const std::uint64_t seed : {1000, 1005, 1021, 1032}) {
    const Answer answer = identify("few-steps", seed, 1000);
    EXPECT_GT(answer.evidence.error_ratio, 2.5);  // of the free simulations
    EXPECT_LT(answer.evidence.ladder.nats, 10);
    EXPECT_LT(answer.evidence.stem_nats, 10);
    EXPECT_GT(answer.evidence.load_ratio, 0);
    EXPECT_LT(answer.evidence.load_ratio, 1.2);
    EXPECT_EQ(name(answer.verdict), "undecided");
  }
}

TEST(LoadRival, IsAskedWhereverAFaultIsFoundInAFewSteps) {
  for (const std::uint64_t seed : {1005, 1017}) {
    const Answer answer = identify("stiction-few-steps", seed, 1000);
    ASSERT_LT(answer.evidence.reversals, 10);
    ASSERT_EQ(name(answer.verdict), "stiction");
    EXPECT_GT(answer.evidence.load_ratio, 0);
  }
}

TEST(LoadRival, CannotStandInForAValveThatSticks) {
  for (const std::uint64_t seed : {1018, 1024}) {
    const Answer answer = identify("stiction-few-steps", seed, 1000);
    EXPECT_GT(answer.evidence.load_ratio, 1.5);
    EXPECT_EQ(name(answer.verdict), "stiction");
  }
}

TEST(LoadRival, IsAskedOnlyAboutFewStepsOfTheSetpoint) {
  EXPECT_EQ(identify("stiction", 1000, 1000).evidence.load_ratio, 0);
  EXPECT_EQ(identify("stiction-setpoint", 1005, 1000).evidence.load_ratio, 0);
}

TEST(LoadRival, GivesTheSameInSlices) {
  const auto ratio = identify("stiction-few-steps", 1018, 1).evidence.load_ratio;
  EXPECT_GT(ratio, 0);
  EXPECT_EQ(ratio, identify("stiction-few-steps", 1018, 100000).evidence.load_ratio);
}

}  // namespace
}  // namespace ident
