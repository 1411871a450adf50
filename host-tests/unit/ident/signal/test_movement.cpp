#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <vector>

#include "ident/signal/movement.hpp"

namespace ident {
namespace {

// 0, 1/10, … 1, 9/10, … : a triangle of period 20 and swing 1.
std::vector<double> triangle(std::size_t n, int period, double height = 1) {
  std::vector<double> u;
  for (std::size_t t = 0; t < n; ++t) {
    const int phase = static_cast<int>(t) % period;
    u.push_back(height * (phase <= period / 2 ? phase : period - phase) / (period / 2));
  }
  return u;
}

OscillationReport<double> oscillating(double period, double amplitude) {
  OscillationReport<double> report;
  report.detected = true;
  report.period_samples = period;
  report.amplitude = amplitude;
  return report;
}

Movement<double> measured(const std::vector<double>& u,
                          const OscillationReport<double>& oscillation,
                          std::vector<unsigned char>& ascending, double u_range = 1) {
  ascending.assign(u.size(), 2);
  return measure_movement<double>(u, oscillation, u_range, ascending);
}

Movement<double> measured(const std::vector<double>& u,
                          const OscillationReport<double>& oscillation = {}) {
  std::vector<unsigned char> ascending;
  return measured(u, oscillation, ascending);
}

// Turning points at 10, 20, … 190.
TEST(Movement, MeasuresATriangle) {
  std::vector<unsigned char> ascending;
  const auto movement = measured(triangle(200, 20), {}, ascending);
  EXPECT_EQ(movement.reversals, 19);
  EXPECT_DOUBLE_EQ(movement.swing, 1);
  EXPECT_DOUBLE_EQ(movement.period, 20);
  EXPECT_DOUBLE_EQ(movement.cycles, 9.5);
  for (std::size_t t = 1; t < 185; ++t) {
    EXPECT_EQ(ascending[t], (t - 1) / 10 % 2 == 0 ? 1 : 0) << t;
  }
}

TEST(Movement, KnowsAStaircaseFromCycles) {
  OscillationReport<double> nine;
  nine.cycles = 9;
  EXPECT_TRUE(turns_in_cycles<double>(triangle(200, 20), nine, 0.4));
  std::vector<double> stairs(200);
  for (std::size_t t = 0; t < stairs.size(); ++t) {
    stairs[t] = static_cast<double>(t / 20);
  }
  EXPECT_FALSE(turns_in_cycles<double>(stairs, nine, 0.4));
  // Small cycles on a drift turn back by their own size.
  std::vector<double> drifting = triangle(200, 20);
  for (std::size_t t = 0; t < drifting.size(); ++t) {
    drifting[t] += 0.04 * static_cast<double>(t);
  }
  EXPECT_TRUE(turns_in_cycles<double>(drifting, nine, 0.4));
}

TEST(Movement, TakesTheDetectedPeriod) {
  const auto movement = measured(triangle(200, 20), oscillating(25, 0.4));
  EXPECT_DOUBLE_EQ(movement.period, 25);
  EXPECT_DOUBLE_EQ(movement.cycles, 8);
  EXPECT_DOUBLE_EQ(movement.swing, 1);
}

TEST(Movement, KeepsThePeriodBetweenFourSamplesAndTwoThirdsOfTheWindow) {
  EXPECT_DOUBLE_EQ(measured(triangle(200, 20), oscillating(2, 0.4)).period, 4);
  EXPECT_DOUBLE_EQ(measured(triangle(200, 20), oscillating(1600, 0.4)).period, 200 / 1.5);
}

// Retreats of 20 % of the range are no turning points: the swing is the usual one.
TEST(Movement, OverlooksSmallRetreats) {
  std::vector<double> u = triangle(200, 20);
  for (std::size_t t = 4; t < 200; t += 10) {
    u[t] -= 0.15;  // in the middle of a stroke
  }
  const auto movement = measured(u);
  EXPECT_EQ(movement.reversals, 19);
  EXPECT_DOUBLE_EQ(movement.swing, 1);
  EXPECT_DOUBLE_EQ(movement.period, 20);
}

// A triangle of height 0.1 on a ramp from 0 to 0.9: no retreat of 0.3, but the detector
// knows the oscillation, with the amplitude 0.05·8/π² of its fundamental wave.
TEST(Movement, FindsTurningPointsOnADrift) {
  std::vector<double> u = triangle(400, 40, 0.1);
  for (std::size_t t = 0; t < u.size(); ++t) {
    u[t] += 0.9 * static_cast<double>(t) / 400;
  }
  EXPECT_EQ(measured(u).reversals, 0);
  const auto movement = measured(u, oscillating(40, 0.05 * 8 / (M_PI * M_PI)));
  // At 20, 40, … 380; the window begins at one, which nothing shows.
  EXPECT_EQ(movement.reversals, 19);
  // Down strokes lose what the ramp gains in 20 samples, up strokes win it.
  EXPECT_GT(movement.swing, 0.1 - 0.045 - 1e-9);
  EXPECT_LT(movement.swing, 0.1 + 0.045 + 1e-9);
  EXPECT_DOUBLE_EQ(movement.cycles, 10);
}

// The same of one that is nearly regular, unless it would turn too often in a cycle.
TEST(Movement, FindsTurningPointsOfANearlyRegularOscillation) {
  std::vector<double> u = triangle(400, 40, 0.1);
  for (std::size_t t = 0; t < u.size(); ++t) {
    u[t] += 0.9 * static_cast<double>(t) / 400;
  }
  OscillationReport<double> report = oscillating(40, 0.05 * 8 / (M_PI * M_PI));
  report.detected = false;
  report.regularity = 0.9;
  EXPECT_EQ(measured(u, report).reversals, 19);
  report.regularity = 0.8;
  EXPECT_EQ(measured(u, report).reversals, 0);
  report.regularity = 0.9;
  report.period_samples = 130;  // six turns in a cycle
  EXPECT_EQ(measured(u, report).reversals, 0);
}

// What swings by a fifth of the range on a drift turns as often as on the level; what
// turns at every fourth sample is noise.
TEST(Movement, FindsTurningPointsThatFollowNoPeriodOnADrift) {
  const auto drifting = [](int period) {
    std::vector<double> u = triangle(400, period, 0.2);
    for (std::size_t t = 0; t < u.size(); ++t) {
      u[t] += 0.8 * static_cast<double>(t) / 400;
    }
    return u;
  };
  const auto movement = measured(drifting(40));
  EXPECT_EQ(movement.reversals, 19);
  EXPECT_NEAR(movement.swing, 0.2, 0.05);
  EXPECT_EQ(measured(drifting(8)).reversals, 0);
}

// The amplitude is in the unit of u_range: 1000 times both is the same.
TEST(Movement, ReadsTheAmplitudeInItsUnit) {
  std::vector<double> u = triangle(400, 40, 0.1);
  for (std::size_t t = 0; t < u.size(); ++t) {
    u[t] += 0.9 * static_cast<double>(t) / 400;
  }
  std::vector<unsigned char> ascending;
  EXPECT_EQ(measured(u, oscillating(40, 0.04), ascending).reversals,
            measured(u, oscillating(40, 40), ascending, 1000).reversals);
}

TEST(Movement, SeesNoneInAConstantOrARamp) {
  std::vector<unsigned char> ascending;
  const auto constant = measured(std::vector<double>(100, 0.5), {}, ascending);
  EXPECT_EQ(constant.reversals, 0);
  EXPECT_EQ(constant.cycles, 0);
  EXPECT_DOUBLE_EQ(constant.swing, 1);
  EXPECT_DOUBLE_EQ(constant.period, 25);
  std::vector<double> ramp;
  for (int t = 0; t < 100; ++t) {
    ramp.push_back(t / 99.0);
  }
  const auto rising = measured(ramp, {}, ascending);
  EXPECT_EQ(rising.reversals, 0);
  for (std::size_t t = 1; t < ramp.size(); ++t) {
    EXPECT_EQ(ascending[t], 1) << t;
  }
}

// 500 turning points: all counted, the first 256 measured.
TEST(Movement, CountsMoreTurningPointsThanItKeeps) {
  const auto movement = measured(triangle(2004, 8));
  EXPECT_EQ(movement.reversals, 500);
  EXPECT_DOUBLE_EQ(movement.swing, 1);
  EXPECT_DOUBLE_EQ(movement.period, 8);
}

TEST(FirstReturn, IsOnePeriodOn) {
  for (const int period : {10, 20, 50}) {
    const std::vector<double> u = triangle(200, period);
    std::vector<unsigned char> ascending;
    measured(u, {}, ascending);
    EXPECT_EQ(first_return<double>(u, ascending, period),
              static_cast<std::size_t>(period));
  }
}

// From the middle of a falling stroke: where it falls through the same value, not where
// it rises through it.
TEST(FirstReturn, MovesTheSameWay) {
  std::vector<double> u = triangle(220, 20);
  u.erase(u.begin(), u.begin() + 14);
  std::vector<unsigned char> ascending;
  for (std::size_t t = 0; t < u.size(); ++t) {
    ascending.push_back((t + 14) % 20 < 10 ? 1 : 0);
  }
  EXPECT_EQ(first_return<double>(u, ascending, 20), 20u);
}

// The period of the cycle at hand may differ from the usual one.
TEST(FirstReturn, FindsACycleThatIsShorter) {
  const std::vector<double> u = triangle(200, 18);
  std::vector<unsigned char> ascending;
  measured(u, {}, ascending);
  EXPECT_EQ(first_return<double>(u, ascending, 20), 18u);
}

TEST(FirstReturn, NeedsThreePeriods) {
  const std::vector<double> u = triangle(60, 20);
  std::vector<unsigned char> ascending;
  measured(u, {}, ascending);
  EXPECT_EQ(first_return<double>(u, ascending, 20), 0u);
  EXPECT_EQ(first_return<double>(u, ascending, 19.9), 20u);
}

TEST(FirstReturn, IsUnknownWhereUNeverMovesThatWayAgain) {
  std::vector<double> u(100, 0);
  std::vector<unsigned char> ascending(100, 0);
  ascending[0] = ascending[1] = 1;
  EXPECT_EQ(first_return<double>(u, ascending, 20), 0u);
}

// Strokes of 1, 0.5, 0.9, 0.6, 0.8, …: the usual swing is the median of them.
TEST(Movement, TheSwingIsTheMedianStroke) {
  std::vector<double> u;
  const double turns[] = {0, 1, 0.5, 0.95, 0.35, 1, 0.2, 0.9};  // 1 .5 .45 .6 .65 .8 .7
  for (std::size_t k = 0; k + 1 < std::size(turns); ++k) {
    for (int t = 0; t < 20; ++t) {
      u.push_back(turns[k] + (turns[k + 1] - turns[k]) * t / 20);
    }
  }
  u.push_back(turns[7]);
  for (int t = 1; t < 15; ++t) u.push_back(0.9 - 0.05 * t);
  // Between the first turning point and the last: .5 .45 .6 .65 .8 .7.
  const double swing = measured(u).swing;
  EXPECT_GE(swing, 0.6 - 1e-9);
  EXPECT_LE(swing, 0.65 + 1e-9);
}

}  // namespace
}  // namespace ident
