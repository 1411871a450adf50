// u against laws known in advance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "workbench/model/base/controller_law.hpp"

namespace workbench {
namespace {

constexpr std::size_t kSamples = 600;

// An output that is pushed about.
std::vector<double> pushed() {
  std::vector<double> y;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const auto t = static_cast<double>(k);
    y.push_back(50 + 3 * std::sin(t / 17) + 2 * std::sin(t / 5.3 + 1));
  }
  return y;
}

// What a PID controller makes of it, with a setpoint of its own in each piece.
std::vector<double> answer(const std::vector<double>& y,
                           const std::vector<Piece>& pieces) {
  std::vector<double> u(y.size());
  double setpoint = 50;
  for (const Piece& piece : pieces) {
    double sum = 0;
    for (std::size_t k = piece.first; k < piece.last; ++k) {
      const double error = setpoint - y[k];
      sum += error;
      const double change = k > piece.first ? y[k] - y[k - 1] : 0;
      u[k] = 30 + 0.8 * error + 0.04 * sum - 1.5 * change;
    }
    setpoint += 4;
  }
  return u;
}

TEST(ControllerLaw, FindsTheLawWhereNothingElseMovesU) {
  const std::vector<Piece> whole = {{.first = 0, .last = kSamples}};
  const std::vector<double> y = pushed();
  const LawShare share = law_share(answer(y, whole), y, whole);
  EXPECT_NEAR(share.of_level, 1, 1e-9);
  EXPECT_NEAR(share.of_changes, 1, 1e-4) << "the first sample has no change before it";
  EXPECT_TRUE(follows_law(share));
}

TEST(ControllerLaw, KnowsWhichWayItActs) {
  const std::vector<Piece> whole = {{.first = 0, .last = kSamples}};
  const std::vector<double> y = pushed();
  std::vector<double> u;
  double sum = 0;
  for (const double value : y) u.push_back(30 - 0.8 * value - 0.05 * (sum += value - 50));
  EXPECT_NEAR(law_share(u, y, whole).slope, -0.8, 1e-9);
  for (double& value : u) value = 60 - value;
  EXPECT_NEAR(law_share(u, y, whole).slope, 0.8, 1e-9);
  for (std::size_t k = 0; k < kSamples; ++k) u[k] = 0.5 * y[k];
  EXPECT_EQ(law_share(u, y, whole).slope, 0) << "y may follow u";
  for (std::size_t k = 0; k < kSamples; ++k) u[k] = sum += 50 - y[k];
  EXPECT_EQ(law_share(u, y, whole).slope, 0) << "integral action alone";
}

TEST(ControllerLaw, GivesEachPieceASetpointOfItsOwn) {
  const std::vector<Piece> two = {{.first = 0, .last = 250},
                                  {.first = 250, .last = kSamples}};
  const std::vector<double> y = pushed();
  EXPECT_NEAR(law_share(answer(y, two), y, two).of_level, 1, 1e-9);
}

TEST(ControllerLaw, BeginsAnewWhereAControllerStoppedAtALimit) {
  const std::vector<Piece> whole = {{.first = 0, .last = kSamples}};
  const std::vector<double> y = pushed();
  std::vector<double> u;
  double sum = 30;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const double error = 50 - y[k];
    sum = std::clamp(sum + 0.04 * error, 28.0, 32.0);
    u.push_back(std::clamp(sum + 0.8 * error, 28.0, 32.0));
  }
  EXPECT_TRUE(follows_law(law_share(u, y, whole)));
}

TEST(ControllerLaw, SeesWhatElseMovesU) {
  const std::vector<Piece> whole = {{.first = 0, .last = kSamples}};
  const std::vector<double> y = pushed();
  std::vector<double> moved = answer(y, whole);
  for (std::size_t k = 300; k < kSamples; ++k) moved[k] += 20;
  EXPECT_FALSE(follows_law(law_share(moved, y, whole))) << "a hand";
  std::vector<double> by_hand(kSamples);
  for (std::size_t k = 0; k < kSamples; ++k) by_hand[k] = k / 100 % 2 == 0 ? 40 : 50;
  EXPECT_FALSE(follows_law(law_share(by_hand, y, whole)));
  LawShare relay{
      .of_level = 0.98, .of_changes = 0.8, .integrates = true, .switches = true};
  EXPECT_FALSE(follows_law(relay));
  relay.of_level = 0.995;
  EXPECT_TRUE(follows_law(relay)) << "u is rounded";
  const std::vector<double> still(kSamples, 50.0);
  EXPECT_EQ(law_share(still, y, whole).of_level, 0);
}

TEST(ControllerLaw, KnowsOneWhoseGainGrowsWithTheError) {
  const std::vector<Piece> whole = {{.first = 0, .last = kSamples}};
  const std::vector<double> y = pushed();
  std::vector<double> u;
  double sum = 30;
  for (const double value : y) {
    const double error = 50 - value;
    sum += 0.03 * error;
    u.push_back(sum + 0.1 * error * std::abs(error));
  }
  const LawShare share = law_share(u, y, whole);
  EXPECT_LT(share.of_level, 0.99);
  EXPECT_TRUE(share.integrates);
  EXPECT_FALSE(share.switches);
  EXPECT_TRUE(follows_law(share));
}

// What a process of the first order makes of u.
std::vector<double> followed(const std::vector<double>& u) {
  std::vector<double> y;
  double level = 50;
  for (const double value : u) {
    y.push_back(level);
    level += (value - level) / 15;
  }
  return y;
}

// A process that follows ramps makes y of u nearly as a controller makes u of y.
TEST(ControllerLaw, TellsAHandThatMovesUInRampsByWhatItDoesNotSum) {
  const std::vector<Piece> whole = {{.first = 0, .last = kSamples}};
  std::vector<double> u;
  double at = 50;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const double wanted = k / 100 % 2 == 0 ? 40 : 60;
    at += std::clamp(wanted - at, -0.3, 0.3);
    u.push_back(at);
  }
  const LawShare share = law_share(u, followed(u), whole);
  EXPECT_GT(share.of_level, 0.9);
  EXPECT_GT(share.of_changes, 0.2);
  EXPECT_FALSE(share.integrates);
  EXPECT_FALSE(follows_law(share));
}

TEST(ControllerLaw, TellsAProcessThatFollowsSmoothlyByTheNextChangeOfY) {
  const std::vector<Piece> whole = {{.first = 0, .last = kSamples}};
  const std::vector<double> u = pushed();
  const LawShare share = law_share(u, followed(u), whole);
  EXPECT_GT(share.of_changes, 0.9);
  EXPECT_TRUE(share.leads);
  EXPECT_FALSE(follows_law(share));
}

TEST(ControllerLaw, KnowsOneThatFloatsByItsMoves) {
  const std::vector<Piece> whole = {{.first = 0, .last = kSamples}};
  const std::vector<double> y = pushed();
  std::vector<double> u;
  double at = 30;
  for (const double value : y) {
    if (std::abs(value - 50) > 1) at += value > 50 ? -0.25 : 0.25;
    u.push_back(at);
  }
  EXPECT_TRUE(law_share(u, y, whole).switches);
  EXPECT_FALSE(law_share(answer(y, whole), y, whole).switches);
}

}  // namespace
}  // namespace workbench
