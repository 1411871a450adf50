// Bends, resolution and straightness of signals made by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "ident/signal/differences.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

TEST(Differences, ALineHasNoBendAndOneStep) {
  Signal line;
  for (int t = 0; t < 100; ++t) line.push_back(0.25 * t - 7);
  const auto d = measure_differences(line);
  EXPECT_EQ(d.bend, 0);
  EXPECT_EQ(d.smallest, 0.25);
  EXPECT_EQ(d.straight, 0);
}

// Second differences of a zigzag of height 1 are all 2.
TEST(Differences, BendIsTheMeanSecondDifference) {
  Signal zigzag;
  for (int t = 0; t < 100; ++t) zigzag.push_back(t % 2);
  const auto d = measure_differences(zigzag);
  EXPECT_DOUBLE_EQ(d.bend, 2);
  EXPECT_EQ(d.smallest, 1);
  EXPECT_DOUBLE_EQ(d.straight, 0.2);
}

TEST(Differences, AConstantDiffersNowhere) {
  const auto d = measure_differences(Signal(10, 5.0));
  EXPECT_EQ(d.bend, 0);
  EXPECT_EQ(d.smallest, std::numeric_limits<double>::max());
  EXPECT_GT(d.same, 0);
}

// Fine values by a fiftieth of the bend, rounded ones by their resolution, at most a
// tenth.
TEST(Differences, StraightKnowsTheResolution) {
  test::Random random(1);
  Signal fine;
  for (int t = 0; t < 2000; ++t) fine.push_back(test::normal(random));
  const auto of = [&](double step) {
    Signal x = fine;
    for (double& v : x) v = step * std::round(v / step);
    return measure_differences(x);
  };
  EXPECT_NEAR(measure_differences(fine).straight, 0.02 * measure_differences(fine).bend,
              1e-3);
  EXPECT_NEAR(of(0.04).straight, 2.02 * 0.04, 1e-9);
  EXPECT_NEAR(of(1).straight, 0.1 * of(1).bend, 1e-9);
}

}  // namespace
}  // namespace ident
