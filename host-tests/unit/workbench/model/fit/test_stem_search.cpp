// What the identification proposes for a fit.
#include <gtest/gtest.h>

#include <cmath>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/fit/stem_search.hpp"

namespace workbench {
namespace {

TEST(StemSearch, SeesAStemThatSticksAndSlips) {
  test::SetpointLoop loop;
  double x = 50;
  loop.valve = [&x](double u) {
    if (std::abs(u - x) > 4) x = u;
    return x;
  };
  const Recording recording = simulated(loop);
  const auto stems = stems_seen(recording.u, recording.y, recording.period_s);
  ASSERT_EQ(stems.size(), 1u);
  EXPECT_NEAR(stems[0].deadband + stems[0].slip_ascending, 4, 0.4);
  EXPECT_NEAR(stems[0].slip_descending, 4, 0.8);
  EXPECT_NEAR(stems[0].lag_s, 20, 3);
}

TEST(StemSearch, ProposesNothingForSignalsThatDoNotMove) {
  const std::vector<double> flat(200, 1.0);
  EXPECT_TRUE(stems_seen(flat, flat, 1).empty());
}

}  // namespace
}  // namespace workbench
