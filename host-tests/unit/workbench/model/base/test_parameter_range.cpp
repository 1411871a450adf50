// What a parameter of a model may be set to.
#include <gtest/gtest.h>

#include <limits>

#include "workbench/model/base/parameter_range.hpp"

namespace workbench {
namespace {

TEST(ParameterRange, IsThatOfThePhysicalBoundsToTheirRounding) {
  const Parameter lag{.name = "first_lag", .bound_low = 0.1, .bound_high = 1000};
  for (const double value : {0.1, 0.1 - 1e-6, 7.0, 1000.0, 1000.05}) {
    EXPECT_TRUE(may_be(lag, value)) << value;
  }
  for (const double value :
       {-5.0, 0.0, 0.09, 1001.0, 1e300, std::numeric_limits<double>::quiet_NaN(),
        -std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(may_be(lag, value)) << value;
  }
}

TEST(ParameterRange, HasNoRoomBelowZero) {
  const Parameter time{.name = "dead_time", .bound_low = 0, .bound_high = 100};
  EXPECT_TRUE(may_be(time, 0));
  EXPECT_FALSE(may_be(time, -1e-9));
}

TEST(ParameterRange, EndsWhereSquaresWouldNotBeFinite) {
  const Parameter gain{.name = "gain", .bound_low = -1e300, .bound_high = 1e300};
  EXPECT_TRUE(may_be(gain, -1e99));
  EXPECT_FALSE(may_be(gain, 1e101));
  EXPECT_FALSE(may_be(gain, 1e300));
}

}  // namespace
}  // namespace workbench
