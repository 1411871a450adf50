// Loops whose sensor sticks and has noise behind it, or whose valve does.
#include <gtest/gtest.h>

#include <vector>

#include "ident/signal/noisy_hold.hpp"
#include "support/ident/pi_loop.hpp"

namespace ident {
namespace {

NoisyHold noisy_hold_of(const test::LoopRecord& record) {
  return find_noisy_hold(record.u, record.y);
}

// What a transmitter adds behind the part that sticks; the controller sees it.
test::PiLoop with_sensor(std::uint64_t seed) {
  test::PiLoop loop;
  loop.proportional = 0.3;
  loop.noise = 0.01;
  loop.sensor = [held = test::sticking(0.5), random = test::Random(seed)](
                    double y) mutable { return held(y) + 0.02 * test::normal(random); };
  return loop;
}

test::PiLoop with_valve(double pole, double load) {
  test::PiLoop loop;
  loop.pole = pole;
  loop.proportional = 0.1;
  loop.integral = 0.02;
  loop.load = load;
  loop.noise = 0.02;
  loop.valve = test::sticking(0.5);
  return loop;
}

TEST(NoisyHold, ASensorThatHoldsUnderNoiseIsNamed) {
  int named = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto hold = noisy_hold_of(test::run(with_sensor(seed + 100), 1500, seed));
    named += hold.sticks ? 1 : 0;
    EXPECT_NEAR(hold.whiteness, 1, 0.15) << seed;
    EXPECT_LT(hold.tail, 4) << seed;
    EXPECT_GT(hold.driven, 0.8) << seed;
  }
  EXPECT_GE(named, 9);
}

// In a process that has come to rest long before the next slip: y is flat and white, too.
TEST(NoisyHold, AValveThatSticksIsNot) {
  for (const double pole : {0.3, 0.7, 0.95}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const auto hold = noisy_hold_of(test::run(with_valve(pole, 0), 3000, seed));
      EXPECT_FALSE(hold.sticks) << pole << ' ' << seed;
    }
  }
}

TEST(NoisyHold, UnderALoadTheFlatsOfASlowlyStickingValveAreColoured) {
  const auto hold = noisy_hold_of(test::run(with_valve(0, 0.01), 3000, 1));
  EXPECT_GT(hold.whiteness, 1.2);
  EXPECT_FALSE(hold.sticks);
}

TEST(NoisyHold, AHealthyLoopIsNot) {
  EXPECT_FALSE(noisy_hold_of(test::run({}, 1500, 1)).sticks);
}

// Its levels are those of the setpoint, and u is at rest in them.
TEST(NoisyHold, AFastLoopWhoseSetpointIsSteppedIsNot) {
  test::Random random(1);
  test::LoopRecord record;
  for (std::size_t t = 0; t < 2000; ++t) {
    const double sp = static_cast<double>((t / 100) * 7 % 5);
    record.y.push_back(sp + 0.02 * test::normal(random));
    record.u.push_back(0.5 * sp + 0.01 * test::normal(random));
  }
  const auto hold = noisy_hold_of(record);
  EXPECT_GT(hold.held, 0.9);
  EXPECT_FALSE(hold.sticks) << hold.driven;
}

TEST(NoisyHold, OffsetScaleAndPrecisionDoNotMatter) {
  test::LoopRecord record = test::run(with_sensor(101), 1500, 1);
  ASSERT_TRUE(noisy_hold_of(record).sticks);
  for (double& v : record.u) v = 1e-2 * v + 0.5;
  for (double& v : record.y) v = 3 - 40 * v;
  const std::vector<double> u = test::as<double>(test::as<float>(record.u));
  const std::vector<double> y = test::as<double>(test::as<float>(record.y));
  EXPECT_TRUE(noisy_hold_of(record).sticks);
  EXPECT_TRUE(find_noisy_hold(u, y).sticks);
}

TEST(NoisyHold, TooShortOrConstantRecordsSayNothing) {
  const std::vector<double> few(10, 1.0);
  const std::vector<double> many(200, 1.0);
  EXPECT_FALSE(find_noisy_hold(few, few).sticks);
  EXPECT_FALSE(find_noisy_hold(many, many).sticks);
  EXPECT_FALSE(find_noisy_hold({}, {}).sticks);
}

}  // namespace
}  // namespace ident
