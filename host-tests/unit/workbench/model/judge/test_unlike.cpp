// Recordings that do not behave like the others they were fitted with.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/base/joined.hpp"
#include "workbench/model/judge/unlike.hpp"

namespace workbench {
namespace {

Recording day(const char* name, double gain) {
  test::SetpointLoop loop;
  loop.samples = 600;
  Recording recording = test::simulated(loop);
  recording.name = name;
  for (double& y : recording.y) y *= gain;
  return recording;
}

std::vector<Unlike> unlike_of(std::vector<Recording> recordings) {
  const Recording all = joined(std::move(recordings));
  const Fitter fitter(all, Column::y);
  return unlike(all, Column::y, quality(fitter, fitter.start({})).recordings);
}

TEST(Unlike, TwoDaysOfOneLoopAreAlike) {
  EXPECT_TRUE(unlike_of({day("monday.csv", 1), day("tuesday.csv", 1)}).empty());
  EXPECT_TRUE(unlike_of({day("monday.csv", 1)}).empty());
}

TEST(Unlike, ADayWithAnotherGainIsToldFromTwoOthers) {
  const std::vector<Unlike> found =
      unlike_of({day("monday.csv", 1), day("tuesday.csv", 1), day("other.csv", -3)});
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.back().file, "other.csv");
  EXPECT_GT(found.back().fit_alone, found.back().fit_shared);
}

}  // namespace
}  // namespace workbench
