// One loop, and what a sensor, an export or a historian can do to its record.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "ident/signal/record_check.hpp"
#include "support/ident/pi_loop.hpp"
#include "support/workbench/historian.hpp"

namespace ident {
namespace {

constexpr std::size_t kRecordSamples = 1500;

test::LoopRecord sound() {
  return test::run({}, kRecordSamples, 1);
}

RecordHealth<double> health_of(const test::LoopRecord& record) {
  return check_record(record.u, record.y, {});
}

TEST(RecordCheck, FindsNothingInASoundRecord) {
  const auto health = health_of(sound());
  EXPECT_FALSE(health.sensor_sticks);
  EXPECT_FALSE(health.swapped);
  EXPECT_FALSE(health.compressed);
  EXPECT_EQ(health.points_apart, 1);
  EXPECT_EQ(health.seam_at, 0u);
  EXPECT_EQ(health.cut_off, 0);
}

TEST(RecordCheck, FindsAReadingThatIsCutOff) {
  test::PiLoop loop;
  loop.sensor = [](double y) { return std::max(y, 0.2); };
  const double lower = health_of(test::run(loop, kRecordSamples, 1)).cut_off;
  EXPECT_GT(lower, 0.05);
  loop.sensor = [](double y) { return std::clamp(y, 0.2, 0.4); };
  EXPECT_GT(health_of(test::run(loop, kRecordSamples, 1)).cut_off, lower + 0.05);
}

TEST(RecordCheck, FindsASensorThatSticks) {
  test::PiLoop loop;
  loop.sensor = test::sticking(0.5);
  const auto health = health_of(test::run(loop, kRecordSamples, 1));
  EXPECT_TRUE(health.sensor_sticks);
  EXPECT_FALSE(health.swapped);
  EXPECT_EQ(health.seam_at, 0u);
}

TEST(RecordCheck, FindsExchangedColumns) {
  test::LoopRecord record = sound();
  std::swap(record.u, record.y);
  EXPECT_TRUE(health_of(record).swapped);
}

TEST(RecordCheck, FindsASeam) {
  test::LoopRecord record = sound();
  const test::LoopRecord more = test::run({}, 1000, 2);
  for (const double value : more.u) record.u.push_back(value + 20);
  for (const double value : more.y) record.y.push_back(value + 20);
  const auto health = health_of(record);
  EXPECT_EQ(health.seam_at, kRecordSamples);
}

TEST(RecordCheck, FindsLinesBetweenStoredPoints) {
  test::LoopRecord record = sound();
  record.u = workbench::test::swinging_door(record.u, 0.3);
  record.y = workbench::test::swinging_door(record.y, 0.3);
  const auto health = health_of(record);
  EXPECT_TRUE(health.compressed);
  EXPECT_GT(health.points_apart, 3);
  EXPECT_EQ(health.held_apart, 1);
}

TEST(RecordCheck, FindsThatAHistorianHeldY) {
  test::LoopRecord record = sound();
  record.y = workbench::test::boxcar(record.y, 0.15, kRecordSamples);
  const auto health = health_of(record);
  EXPECT_FALSE(health.compressed);
  EXPECT_GT(health.held_apart, 2);
}

// A controller that acts seldom holds u, and is not to be blamed for it.
TEST(RecordCheck, LetsUBeHeld) {
  test::LoopRecord record = sound();
  record.u = workbench::test::boxcar(record.u, 0.15, kRecordSamples);
  EXPECT_EQ(health_of(record).held_apart, 1);
}

}  // namespace
}  // namespace ident
