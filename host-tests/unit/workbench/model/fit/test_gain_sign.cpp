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
