#include <gtest/gtest.h>

#include <cmath>

#include "ident/base/quick_random.hpp"

namespace ident {
namespace {

TEST(QuickRandom, IsASequenceOfItsOwn) {
  QuickRandom<double> one;
  QuickRandom<double> other;
  // 1664525 + 1013904223 = 1015568748, without its last 8 bits.
  EXPECT_EQ(one.uniform(), (1015568748 / 256) / 16777216.0);
  EXPECT_EQ(other.symmetric(), 2 * ((1015568748 / 256) / 16777216.0) - 1);
  EXPECT_EQ(one.uniform(), other.uniform());
}

TEST(QuickRandom, HasTheMomentsItSays) {
  QuickRandom<double> random;
  double uniform = 0;
  double mean = 0;
  double square = 0;
  constexpr int kCount = 100000;
  for (int i = 0; i < kCount; ++i) {
    uniform += random.uniform() / kCount;
    const double normal = random.normal();
    EXPECT_LE(std::abs(normal), 3);
    mean += normal / kCount;
    square += normal * normal / kCount;
  }
  EXPECT_NEAR(uniform, 0.5, 0.01);
  EXPECT_NEAR(mean, 0, 0.02);
  EXPECT_NEAR(square, 1, 0.02);
}

}  // namespace
}  // namespace ident
