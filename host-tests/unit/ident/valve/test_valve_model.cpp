#include <gtest/gtest.h>

#include <cmath>

#include "ident/valve/valve_model.hpp"

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

TEST(Delays, BeginAtTheNewestSampleOnlyWithinMeans) {
  SearchWindow<double> window;
  EXPECT_EQ(every_delay(window).first, 1);
  window.decimation = 3;
  EXPECT_EQ(every_delay(window).first, 0);
  EXPECT_EQ(every_delay(window).last, kDelayTaps - 2);
}

TEST(Delays, NearOneStayWithinAll) {
  SearchWindow<double> window;
  EXPECT_EQ(delays_near(window, 5).first, 3);
  EXPECT_EQ(delays_near(window, 5).last, 7);
  EXPECT_EQ(delays_near(window, 1).first, 1);
  EXPECT_EQ(delays_near(window, kDelayTaps - 2).last, kDelayTaps - 2);
}

}  // namespace
}  // namespace ident
