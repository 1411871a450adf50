// The sign of the gain, from the controller's law.
#include <gtest/gtest.h>

#include <cmath>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/fit/gain_sign.hpp"

namespace workbench {
namespace {

std::vector<Piece> one_piece(const Recording& recording) {
  return {{0, recording.size(), "", 0, false}};
}

TEST(GainSign, IsThatOfTheLaw) {
  Recording recording = test::simulated({});
  EXPECT_EQ(gain_sign_of(recording, one_piece(recording)), 1);
  for (double& u : recording.u) u = -u;
  EXPECT_EQ(gain_sign_of(recording, one_piece(recording)), -1);
}

TEST(GainSign, IsUnknownWhereNoLawIsSeen) {
  Recording recording = test::simulated({});
  for (std::size_t k = 0; k < recording.size(); ++k) {
    recording.u[k] += 20 * std::cos(0.7 * static_cast<double>(k * k % 997));
  }
  EXPECT_EQ(gain_sign_of(recording, one_piece(recording)), 0);
}

// A log that writes y after u has acted: y that follows u is no law of a controller.
TEST(GainSign, IsUnknownWhereYStandsInTheRowOfTheUThatMovedIt) {
  Recording recording = test::simulated({});
  const std::vector<double> noise = recording.y;
  for (std::size_t k = 0; k < recording.size(); ++k) {
    recording.u[k] = 50 + 10 * std::cos(0.7 * static_cast<double>(k / 8 * k / 8 % 997));
    if (k % 8 != 0) recording.u[k] = recording.u[k - 1];
    recording.y[k] = 0.8 * recording.u[k] + 0.02 * std::sin(1.7 * noise[k]);
  }
  recording.sp.clear();
  EXPECT_EQ(gain_sign_of(recording, one_piece(recording)), 0);
}

// A fan whose pressure follows within the row looks like a controller of the other sign
// while its speed wanders. It does not where it is switched on and off.
TEST(GainSign, IsUnknownWhereYJumpsWithUThatIsSwitched) {
  const auto sign_of = [](bool switched) {
    Recording fan = test::simulated({});
    fan.sp.clear();
    for (std::size_t k = 0; k < fan.size(); ++k) {
      const double t = static_cast<double>(k);
      const bool on = !switched || k / 100 % 2 == 1;
      fan.u[k] = on ? 50 + 5 * std::sin(t / 7) + std::sin(t / 3) : 0;
      fan.y[k] = 0.018 * fan.u[k] + 0.001 * std::cos(1.7 * t * t);
    }
    return gain_sign_of(fan, one_piece(fan));
  };
  EXPECT_EQ(sign_of(false), -1);
  EXPECT_EQ(sign_of(true), 0);
}

TEST(GainSign, IsUnknownWhereTwoPiecesDisagree) {
  Recording recording = test::simulated({});
  for (std::size_t k = 600; k < recording.size(); ++k) recording.u[k] = -recording.u[k];
  const std::vector<Piece> both = {{0, 600, "", 0, false},
                                   {600, recording.size(), "", 0, false}};
  EXPECT_EQ(gain_sign_of(recording, {both.begin(), 1}), 1);
  EXPECT_EQ(gain_sign_of(recording, {both.begin() + 1, 1}), -1);
  EXPECT_EQ(gain_sign_of(recording, both), 0);
}

}  // namespace
}  // namespace workbench
