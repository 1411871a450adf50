#include <gtest/gtest.h>

#include <cmath>

#include "ident/valve_model.hpp"

namespace ident {
namespace {

TEST(TimeConstants, ArePolesAndBack) {
  EXPECT_NEAR(pole_of(10.0), std::exp(-0.1), 1e-15);
  for (const double time_constant : {0.2, 1.0, 30.0, 1e4}) {
    EXPECT_NEAR(time_constant_of(pole_of(time_constant)), time_constant,
                1e-9 * time_constant);
  }
}

TEST(TimeConstants, TooShortForTheSamplesAreNoPole) {
  EXPECT_EQ(pole_of(0.1), 0);
  EXPECT_DOUBLE_EQ(time_constant_of(0.0), kNoTimeConstant);
  EXPECT_EQ(pole_of(time_constant_of(0.0)), 0);
}

}  // namespace
}  // namespace ident
