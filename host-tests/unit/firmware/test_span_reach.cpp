#include <gtest/gtest.h>

#include <limits>

#include "firmware/span_reach.hpp"
#include "support/ident/microseconds.hpp"

namespace firmware {
namespace {

using test::kSecond;

class Reach : public testing::Test {
 protected:
  // One value a second.
  void take(int seconds, double value) {
    for (int k = 0; k < seconds; ++k) reach.take(now += kSecond, value);
  }
  SpanReach reach{{0, 100}, 5 * kSecond};
  std::int64_t now = 0;
};

TEST_F(Reach, IsLeftByValuesAWholeSpanOutsideThatLast) {
  take(10, 200);
  take(10, -100);
  EXPECT_FALSE(reach.left()) << "not more than a whole span";
  take(5, 535);
  EXPECT_FALSE(reach.left()) << "not for long";
  take(1, 535);
  EXPECT_TRUE(reach.left());
  take(5, 50);
  EXPECT_TRUE(reach.left());
  EXPECT_EQ(reach.far_value(), 535);
  take(1, 50);
  EXPECT_FALSE(reach.left());
}

TEST_F(Reach, IsLeftFromTheStart) {
  take(7, std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(reach.left());
}

TEST_F(Reach, IsNotFoundAgainBySingleValues) {
  take(10, -1e11);
  for (int k = 0; k < 20; ++k) {
    take(3, 50);
    take(1, 9e10);
    EXPECT_TRUE(reach.left()) << k;
  }
}

TEST_F(Reach, IsNotLeftBySingleValues) {
  for (int k = 0; k < 20; ++k) {
    take(3, 50);
    take(1, 9e10);
    EXPECT_FALSE(reach.left()) << k;
  }
}

}  // namespace
}  // namespace firmware
