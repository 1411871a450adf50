// What a load that nobody measured has to be like.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "workbench/effects/effects.hpp"

namespace workbench {
namespace {

// What is said against a step by `amplitude` at 30 s, at once or through the process,
// until `end` s or for good, in an output that goes from 0 to 10 in steps of 0.1.
std::string objection(double amplitude, bool through_process, double end = 0,
                      double u_jumps_at = 0, double lag_s = 0) {
  std::vector<double> u(101, 40.0);
  std::vector<double> y(101);
  for (std::size_t k = 0; k < y.size(); ++k) {
    y[k] = 0.1 * static_cast<double>(k);
    const auto t = static_cast<double>(k);
    if (u_jumps_at > 0 && t >= u_jumps_at && t < u_jumps_at + 40) u[k] = 60;
  }
  u.back() = 41;  // moves once more, a little
  Situation s = situation_of(u, y, 1);
  s.first_lag_s = lag_s;
  const std::vector<double> p = {30, through_process ? 1.0 : 0.0, end > 0 ? 1.0 : 0.0,
                                 end};
  return effects::disturbance_step().objection(s, p, std::vector<double>{amplitude});
}

TEST(LoadStep, IsNoLargerThanWhatTheOutputDoes) {
  EXPECT_EQ(objection(9, true), "");
  EXPECT_EQ(objection(-11, true),
            "it would have to be larger than all that the output does");
  EXPECT_EQ(objection(-11, true, 0, 0, 100), "") << "half of it comes within 70 s";
}

// A controller that answers a load through the process does not jump.
TEST(LoadStep, ThroughTheProcessIsDoubtedWhereUJumpsAboutThen) {
  const char* const otherwise =
      "u jumps where it comes and where it goes: the process may answer otherwise there";
  EXPECT_EQ(objection(2, true, 70, 31), otherwise);
  EXPECT_EQ(objection(2, true, 70, 29), otherwise);
  EXPECT_EQ(objection(2, true, 70, 50), "");
  EXPECT_EQ(objection(0.2, false, 70, 29.5), otherwise);
}

TEST(LoadStep, IsDoubtedWhileALoneMoveOfUIsAnswered) {
  const char* const otherwise =
      "u jumps where it comes: the process may answer otherwise there";
  EXPECT_EQ(objection(2, true, 0, 20, 5), otherwise) << "two lags after the move";
  EXPECT_EQ(objection(2, true, 0, 20, 2), "") << "five lags after it";
}

TEST(LoadStep, IsDoubtedWhereItIsOverBeforeTheBeginningIsForgotten) {
  std::vector<double> u(101, 40.0);
  std::vector<double> y(101);
  for (std::size_t k = 0; k < y.size(); ++k) y[k] = 0.1 * static_cast<double>(k);
  Situation s = situation_of(u, y, 1);
  const auto from_to = [&s](double from, double to) {
    return effects::disturbance_step().objection(s, std::vector<double>{from, 1, 1, to},
                                                 std::vector<double>{2});
  };
  s.first_lag_s = 8;
  EXPECT_NE(from_to(0, 20).find("begun otherwise"), std::string::npos);
  EXPECT_EQ(from_to(0, 30), "") << "four lags after it";
  EXPECT_EQ(from_to(5, 20), "") << "it was not there at first";
}

// What is said against a drift from 20 s on, where u is `wave` wide on a sweep.
std::string objection_to_drift(double wave) {
  std::vector<double> u(101);
  for (std::size_t k = 0; k < u.size(); ++k) {
    u[k] = static_cast<double>(k) + wave * (k % 10 < 5 ? 0 : 1);
  }
  const Situation s = situation_of(u, u, 1);
  return effects::disturbance_ramp().objection(s, std::vector<double>{20},
                                               std::vector<double>{0.1});
}

TEST(LoadRamp, IsDoubtedWhereUSweepsOneWay) {
  EXPECT_EQ(objection_to_drift(0),
            "u moves as steadily: a valve or process that answers less of it there looks "
            "the same");
  EXPECT_EQ(objection_to_drift(10), "");
}

TEST(LoadRamp, IsDoubtedWhereALoneMoveOfUIsAnswered) {
  std::vector<double> u(101);
  for (std::size_t k = 10; k < u.size(); ++k) u[k] = 7;
  Situation s = situation_of(u, u, 1);
  s.first_lag_s = 50;
  const auto objection = [&s](double from_s) {
    return effects::disturbance_ramp().objection(s, std::vector<double>{from_s},
                                                 std::vector<double>{0.1});
  };
  EXPECT_EQ(objection(20),
            "it begins behind the one move of u: a late answer to it looks the same");
  EXPECT_EQ(objection(5), "") << "before the move";
  EXPECT_EQ(objection(60), "") << "half the recording later";
}

TEST(Overflow, IsNoneAtTheSetpoint) {
  std::vector<double> u(200);
  std::vector<double> y(200);
  for (std::size_t k = 0; k < u.size(); ++k) {
    u[k] = k / 50 % 2 == 0 ? 0 : 50 + static_cast<double>(k % 7);
    y[k] = u[k] > 0 ? 1 : 0;
  }
  Situation s = situation_of(u, y, 1);
  const auto objection = [&s] {
    return effects::process_overflow().objection(
        s, std::vector<double>{0.999, 1, s.u_high, 1}, std::vector<double>{});
  };
  EXPECT_EQ(objection(), "") << "without one";
  std::vector<double> sp(200, 1.0);
  s.sp = sp;
  EXPECT_NE(objection(), "");
  sp.assign(200, 1.5);
  EXPECT_EQ(objection(), "");
}

// A thermostat goes off at its level; a full tank stays full while the pump runs.
TEST(Overflow, IsNoneWhereASwitchGoesOff) {
  std::vector<double> u(400);
  std::vector<double> y(400);
  for (std::size_t k = 0; k < u.size(); ++k) {
    const double t = static_cast<double>(k % 100);
    u[k] = k % 100 < 50 ? 1 : 0;
    y[k] = t < 50 ? t : 99 - t;
  }
  const std::vector<double> p = {48, 1, 1, 1};
  const Effect& overflow = effects::process_overflow();
  EXPECT_FALSE(overflow.excitation(situation_of(u, y, 1), p).acted);
  for (double& level : y) level = std::min(level, 40.0);
  EXPECT_TRUE(
      overflow.excitation(situation_of(u, y, 1), std::vector<double>{40, 1, 1, 1}).acted);
}

// Friction bends a slow swing of u; its overtones are no load.
TEST(LoadSinusoid, IsDoubtedAtAnOvertoneOfU) {
  std::vector<double> u(600);
  for (std::size_t k = 0; k < u.size(); ++k) {
    u[k] = std::sin(2 * std::numbers::pi * static_cast<double>(k) / 99);
  }
  const Situation s = situation_of(u, u, 1);
  const auto seen = [&s](double period_s) {
    return effects::disturbance_sinusoid().excitation(s, std::vector<double>{period_s});
  };
  EXPECT_FALSE(seen(33).acted);
  EXPECT_TRUE(seen(71).acted);
  EXPECT_EQ(seen(71).events, 8);
}

}  // namespace
}  // namespace workbench
