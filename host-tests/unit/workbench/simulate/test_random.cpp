#include <gtest/gtest.h>

#include <cmath>

#include "workbench/simulate/random.hpp"

namespace workbench {
namespace {

TEST(SimulateRandom, RepeatsForOneLabelAndSeedOnly) {
  Random a("label", 7);
  Random b("label", 7);
  Random other_seed("label", 8);
  Random other_label("lebal", 7);
  const double first = a.uniform();
  EXPECT_EQ(first, b.uniform());
  EXPECT_NE(first, other_seed.uniform());
  EXPECT_NE(first, other_label.uniform());
}

TEST(SimulateRandom, IsTheSameStreamEverywhere) {
  // std::mt19937_64 and 53 bits of it: no platform may differ.
  Random random("golden", 1);
  EXPECT_EQ(random.uniform(), 0x1.c6f66a90fd585p-1);
  EXPECT_EQ(random.uniform(), 0x1.9532edd768268p-2);
}

TEST(SimulateRandom, MomentsAndRanges) {
  Random random("moments", 3);
  double sum = 0;
  double squares = 0;
  double fourth = 0;
  constexpr int kDraws = 200000;
  for (int i = 0; i < kDraws; ++i) {
    const double z = random.normal();
    sum += z;
    squares += z * z;
    fourth += z * z * z * z;
  }
  // Five standard deviations of each estimate.
  EXPECT_NEAR(sum / kDraws, 0, 5 / std::sqrt(kDraws));
  EXPECT_NEAR(squares / kDraws, 1, 5 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(fourth / kDraws, 3, 5 * std::sqrt(96.0 / kDraws));

  bool seen[3] = {};
  for (int i = 0; i < 1000; ++i) {
    const int drawn = random.integer(-1, 1);
    ASSERT_GE(drawn, -1);
    ASSERT_LE(drawn, 1);
    seen[drawn + 1] = true;
    const double u = random.log_uniform(0.5, 8);
    ASSERT_GE(u, 0.5);
    ASSERT_LT(u, 8.0000001);
  }
  EXPECT_TRUE(seen[0] && seen[1] && seen[2]);
}

}  // namespace
}  // namespace workbench
