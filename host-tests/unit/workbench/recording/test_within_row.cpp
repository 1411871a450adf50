// A fan that is switched on and off, its pressure read in the same row or one later.
#include <gtest/gtest.h>

#include <cmath>

#include "workbench/model/fit/fit.hpp"
#include "workbench/recording/within_row.hpp"

namespace workbench {
namespace {

Recording fan(std::size_t late, double gain = 0.018) {
  Recording out;
  out.name = "fan";
  out.period_s = 60;
  for (std::size_t k = 0; k < 600; ++k) {
    const double t = static_cast<double>(k);
    out.t.push_back(60 * t);
    out.u.push_back(k / 60 % 2 == 0 ? 0 : 50 + 8 * std::sin(t / 5) + std::sin(t));
    const double moved = k < late ? 0 : out.u[k - late];
    out.y.push_back(gain * moved + 0.004 * std::sin(t * t));
  }
  return out;
}

TEST(WithinRow, TellsTheSignOfWhatJumpsTogether) {
  const auto sign_of = [](const Recording& r) { return sign_of_jumps(r.u, r.y); };
  EXPECT_EQ(sign_of(fan(0)), 1);
  EXPECT_EQ(sign_of(fan(0, -2)), -1);
  EXPECT_EQ(sign_of(fan(1)), 0);
  Recording both_ways = fan(0);
  for (std::size_t k = 300; k < 600; ++k) both_ways.y[k] = -both_ways.y[k];
  EXPECT_EQ(sign_of(both_ways), 0);
  EXPECT_EQ(sign_of_jumps({}, {}), 0);
}

// Jumps of the sensor are answered in their row, too, but they do not stay.
TEST(WithinRow, ASpikeIsNoSwitch) {
  Recording r = fan(1);
  for (std::size_t k = 0; k < r.size(); ++k) r.u[k] = r.y[k] = k % 50 == 30 ? 1 : 0;
  EXPECT_EQ(sign_of_jumps(r.u, r.y), 0);
}

// Nor is a controller switched that answers the jumps of a sensor that sticks.
TEST(WithinRow, ASensorThatSticksSwitchesNothing) {
  Recording r = fan(1);
  for (std::size_t k = 0; k < r.size(); ++k) {
    r.y[k] = k / 40 % 2 == 0 ? 30 : 32;
    r.u[k] = (r.y[k] - 31) * 14 + 20 * std::sin(static_cast<double>(k) / 60);
  }
  EXPECT_EQ(sign_of_jumps(r.u, r.y), 0);
}

// A proportional controller answers a quick swing of y within the row.
TEST(WithinRow, ASwingIsNoSwitch) {
  Recording r = fan(1);
  for (std::size_t k = 0; k < r.size(); ++k) {
    r.y[k] = std::sin(static_cast<double>(k) * 0.6);
    r.u[k] = -1.5 * r.y[k];
  }
  EXPECT_EQ(sign_of_jumps(r.u, r.y), 0);
}

// Moves by hand, answered behind lags of 9 rows and `second`, and read `late` rows later.
Recording by_hand(double second, double late, double noise = 0.05) {
  Recording out;
  const double levels[] = {30, 50, 40, 60, 35};
  const double fine = 20;
  double z1 = 30;
  double z2 = 30;
  for (std::size_t k = 0; k < 300; ++k) {
    for (double part = 0; part < fine; ++part) {
      const double t = static_cast<double>(k) + (part + 1) / fine - 1 - late;
      const double u = levels[static_cast<std::size_t>(std::max(t + 1, 0.0)) / 60 % 5];
      z1 += (u - z1) / (9 * fine);
      z2 = second > 0 ? z2 + (z1 - z2) / (second * fine) : z1;
    }
    const double t = static_cast<double>(k);
    out.t.push_back(t);
    out.u.push_back(levels[k / 60 % 5]);
    out.y.push_back(z2 + noise * std::sin(t * t * 1.3));
  }
  return out;
}

TEST(WithinRow, IsSeenInMovesOutOfRest) {
  const auto seen = [](const Recording& r) { return answers_within_row(r.u, r.y); };
  for (const double second : {0.0, 6.0}) {
    EXPECT_TRUE(seen(by_hand(second, 0, 0.02))) << second;
    EXPECT_FALSE(seen(by_hand(second, 1, 0.02))) << second;
    EXPECT_FALSE(seen(by_hand(second, 3, 0.02))) << second;
  }
  EXPECT_FALSE(seen(by_hand(0, 0, 5))) << "noise hides it";
}

TEST(WithinRow, IsNoted) {
  Recording r = fan(1);
  note_within_row(r);
  EXPECT_TRUE(r.resampling.notes.empty());
  r = fan(0);
  note_within_row(r);
  EXPECT_EQ(r.resampling.notes.size(), 1U);
}

TEST(WithinRow, TheModelTakesUOneRowEarlier) {
  for (const std::size_t late : {0U, 1U}) {
    const Recording r = fan(late);
    const Fitter fitter(r, Column::y);
    EXPECT_LT(fitter.rmse(fitter.start({})), 0.006) << late;
  }
}

}  // namespace
}  // namespace workbench
