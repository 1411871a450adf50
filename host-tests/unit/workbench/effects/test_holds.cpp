// Who holds a reading: the sensor, the historian, or nobody.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "support/workbench/historian.hpp"
#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/holds.hpp"

namespace workbench::effects {
namespace {

// A load that wanders, so that the readings never come back to the same value.
test::SetpointLoop wandering() {
  test::SetpointLoop loop;
  loop.load = [random = std::mt19937_64(5), at = 0.0](std::size_t) mutable {
    at += std::normal_distribution<double>(0, 0.15)(random);
    return at;
  };
  return loop;
}

std::function<double(double)> sticking(double band) {
  return [band, reading = 0.0](double y) mutable {
    if (std::abs(y - reading) > band) reading = y;
    return reading;
  };
}

TEST(WhoHolds, ASensorWhoseJumpsTheControllerAnswers) {
  test::SetpointLoop loop = wandering();
  loop.sensor = sticking(1.5);
  const Recording recording = test::simulated(loop);
  EXPECT_EQ(who_holds(recording.u, recording.y), Holder::kSensor);
}

TEST(WhoHolds, AHistorianWhoseHoldsTheControllerNeverSaw) {
  const Recording recording = test::simulated(wandering());
  const auto y = test::boxcar(recording.y, 1.5, 200);
  EXPECT_EQ(who_holds(recording.u, y), Holder::kHistorian);
  EXPECT_EQ(who_holds(test::boxcar(recording.u, 1, 200), y), Holder::kHistorian);
}

TEST(WhoHolds, EitherWhereUIsMovedByHand) {
  const Recording recording = test::simulated(wandering());
  const auto y = test::boxcar(recording.y, 1.5, 200);
  std::vector<double> u(y.size());
  for (std::size_t k = 0; k < u.size(); ++k) u[k] = k / 300 % 2 == 0 ? 40 : 60;
  EXPECT_EQ(who_holds(u, y), Holder::kEither);
}

TEST(WhoHolds, NobodyWhereYIsAsItWasOrCoarse) {
  const Recording recording = test::simulated(wandering());
  EXPECT_EQ(who_holds(recording.u, recording.y), Holder::kNobody);
  EXPECT_EQ(who_holds(recording.u, test::quantise(recording.y, 2)), Holder::kNobody);
}

TEST(HoldLike, StandsStillWhereTheReadingDoes) {
  const std::vector<double> reading = {1, 1, 2, 2, 2, 3};
  std::vector<double> signal = {10, 11, 12, 13, 14, 15};
  hold_like(reading, same_reading(1, 3), signal);
  EXPECT_EQ(signal, (std::vector<double>{10, 10, 12, 12, 12, 15}));
  const Held held = held_in(reading, same_reading(1, 3));
  EXPECT_EQ(held.jumps, 2u);
  EXPECT_DOUBLE_EQ(held.least_jump, 1);
}

}  // namespace
}  // namespace workbench::effects
