// Loops whose sensor sticks, or whose valve does.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ident/signal/sensor_hold.hpp"
#include "support/ident/pi_loop.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

SensorHold hold_of(const test::LoopRecord& record) {
  return find_sensor_hold(record.u, record.y);
}

test::PiLoop with_sensor(std::function<double(double)> sensor) {
  test::PiLoop loop;
  loop.sensor = std::move(sensor);
  return loop;
}

TEST(SensorHold, ASensorThatHoldsAndJumpsIsNamed) {
  for (std::uint64_t seed = 1; seed < 10; ++seed) {
    const auto hold = hold_of(test::run(with_sensor(test::sticking(0.5)), 1500, seed));
    EXPECT_TRUE(hold.sticks) << seed;
    EXPECT_GT(hold.held, 0.8) << seed;
    EXPECT_GT(hold.driven, 0.95) << seed;
    EXPECT_GT(hold.answered, 0.95) << seed;
  }
}

TEST(SensorHold, AValveThatSticksIsNot) {
  for (const double pole : {0.0, 0.5, 0.95}) {
    test::PiLoop loop;
    loop.pole = pole;
    loop.proportional = 0.3;
    loop.valve = test::sticking(0.5);
    const auto hold = hold_of(test::run(loop, 1500, 1));
    EXPECT_FALSE(hold.sticks) << pole;
    EXPECT_LT(hold.held, 0.05) << pole;
  }
}

// Before a process faster than the sampling y is as flat as its resolution.
TEST(SensorHold, AValveThatSticksBehindACoarseSensorIsNot) {
  for (const double step : {0.02, 0.1, 0.3}) {
    test::PiLoop loop;
    loop.pole = 0;
    loop.proportional = 0.3;
    loop.noise = 0.002;
    loop.load = 0.002;
    loop.valve = test::sticking(0.5);
    loop.sensor = [step](double y) { return step * std::round(y / step); };
    EXPECT_FALSE(hold_of(test::run(loop, 1500, 1)).sticks) << step;
  }
}

TEST(SensorHold, WithoutLoadAndNoiseTheLevelsTellNothing) {
  test::PiLoop loop;
  loop.pole = 0;
  loop.proportional = 0.3;
  loop.noise = 0;
  loop.load = 0;
  loop.valve = test::sticking(0.5);
  const auto hold = hold_of(test::run(loop, 1500, 1));
  EXPECT_GT(hold.held, 0.8);
  EXPECT_FALSE(hold.sticks);
}

// The historian held y, the controller saw it move.
TEST(SensorHold, ExceptionReportingIsNot) {
  test::LoopRecord record = test::run({}, 1500, 1);
  auto report = test::sticking(0.2);
  for (double& v : record.y) v = report(v);
  const auto hold = hold_of(record);
  EXPECT_GT(hold.held, 0.4);
  EXPECT_FALSE(hold.sticks);
}

TEST(SensorHold, AHealthyLoopIsNot) {
  const auto hold = hold_of(test::run({}, 1500, 1));
  EXPECT_FALSE(hold.sticks);
  EXPECT_EQ(hold.holds, 0u);
}

TEST(SensorHold, OffsetScaleAndPrecisionDoNotMatter) {
  test::LoopRecord record = test::run(with_sensor(test::sticking(0.5)), 1500, 1);
  for (double& v : record.u) v = 1e-2 * v + 0.5;
  for (double& v : record.y) v = 3 - 40 * v;
  const Signal u = test::as<double>(test::as<float>(record.u));
  const Signal y = test::as<double>(test::as<float>(record.y));
  EXPECT_TRUE(hold_of(record).sticks);
  EXPECT_TRUE(find_sensor_hold(u, y).sticks);
}

TEST(SensorHold, TooShortOrConstantRecordsSayNothing) {
  const Signal few(10, 1.0);
  const Signal many(200, 1.0);
  EXPECT_FALSE(find_sensor_hold(few, few).sticks);
  EXPECT_FALSE(find_sensor_hold(many, many).sticks);
  EXPECT_FALSE(find_sensor_hold({}, {}).sticks);
}

}  // namespace
}  // namespace ident
