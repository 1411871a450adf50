// The parts of a recording that were recorded in one go.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/analysis/uncut_parts.hpp"

namespace workbench {
namespace {

TEST(UncutParts, LeavesARecordingInOneGoAsItIs) {
  const Recording recording = test::simulated({});
  EXPECT_TRUE(in_one_go(recording));
  const auto parts = uncut_parts(recording);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].u, recording.u);
}

TEST(UncutParts, CutsAtPausesAndAtWhatIsLeftOutAndDropsWhatIsShort) {
  Recording recording = test::simulated({});
  recording.pieces = {{.first = 0, .last = 700}, {.first = 700, .last = 1200}};
  recording.left_out = {{300, 320}, {680, 690}};
  EXPECT_FALSE(in_one_go(recording));
  const auto parts = uncut_parts(recording);
  ASSERT_EQ(parts.size(), 3u);  // the ten samples up to 700 say nothing
  EXPECT_EQ(parts[0].size(), 300u);
  EXPECT_EQ(parts[1].size(), 360u);
  EXPECT_EQ(parts[2].size(), 500u);
  EXPECT_EQ(parts[2].u.front(), recording.u[700]);
  EXPECT_TRUE(parts[1].pieces.empty());
}

}  // namespace
}  // namespace workbench
