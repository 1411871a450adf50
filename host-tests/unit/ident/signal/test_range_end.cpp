// Readings that are cut off, and what looks like them: peaks, what settles, switches.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "ident/signal/range_end.hpp"
#include "support/ident/pi_loop.hpp"

namespace ident {
namespace {

constexpr std::size_t kReadings = 1500;

std::vector<double> over_time(const std::function<double(double)>& of_time) {
  std::vector<double> y;
  for (std::size_t k = 0; k < kReadings; ++k)
    y.push_back(of_time(static_cast<double>(k)));
  return y;
}

double swell(double t) {
  return std::sin(2 * std::numbers::pi * t / 97.3);
}

std::size_t stays_of(const std::vector<double>& y, bool upper = true) {
  return find_range_end(y, upper).stays;
}

TEST(RangeEnd, IsFoundWhereAWaveIsCutOff) {
  const auto y = over_time([](double t) { return 40 + 3 * std::min(swell(t), 0.8); });
  const RangeEnd upper = find_range_end(y, true);
  EXPECT_NEAR(upper.level, 42.4, 1e-12);
  EXPECT_EQ(upper.stays, 16u);
  EXPECT_NEAR(upper.share, std::acos(0.8) / std::numbers::pi, 0.01);
  EXPECT_EQ(stays_of(y, false), 0u);
}

TEST(RangeEnd, IsFoundAtTheLowerEndOfANoisyLoop) {
  test::PiLoop loop;
  loop.sensor = [](double y) { return std::max(y, 0.2); };
  const auto y = test::run(loop, kReadings, 1).y;
  EXPECT_GT(stays_of(y, false), 10u);
  EXPECT_EQ(find_range_end(y, false).level, 0.2);
  EXPECT_EQ(stays_of(y, true), 0u);
}

// Noise elsewhere says that a reading that only settles would not repeat.
TEST(RangeEnd, OneStayTellsWhereNoiseMovesTheReadingElsewhere) {
  test::Random random(3);
  const auto one = [&](double noise) {
    return over_time([&](double t) {
      const double rest = t < 700 || t > 800 ? 0 : 5;
      return std::min(swell(t) + rest + noise * test::normal(random), 2.0);
    });
  };
  EXPECT_EQ(stays_of(one(0.1)), 1u);
  EXPECT_EQ(stays_of(one(0)), 0u);
}

TEST(RangeEnd, IsNotAPeak) {
  EXPECT_EQ(stays_of(over_time(swell)), 0u);
  EXPECT_EQ(stays_of(over_time([](double t) { return std::round(50 * swell(t)); })), 0u);
}

// Every 200 samples to the same level, and back at once.
TEST(RangeEnd, IsNotWhereAProcessSettles) {
  const auto y = over_time([](double t) {
    const double since = std::fmod(t, 200);
    return since < 150 ? 1 - std::exp(-since / 8) : std::exp(-(since - 150) / 8);
  });
  EXPECT_EQ(stays_of(y), 0u);
}

TEST(RangeEnd, IsNotASwitch) {
  const auto y = over_time([](double t) { return swell(t) > 0.2 ? 1 : 0; });
  EXPECT_EQ(stays_of(y, true), 0u);
  EXPECT_EQ(stays_of(y, false), 0u);
}

TEST(RangeEnd, IsNotWhereAReadingRestsAnywhere) {
  const auto held =
      over_time([](double t) { return std::min(swell(t - std::fmod(t, 6)), 0.8); });
  EXPECT_EQ(stays_of(held), 0u);
  EXPECT_EQ(stays_of({}), 0u);
  EXPECT_EQ(stays_of({1, 1, 1, 1}), 0u);
}

TEST(RangeEnd, IsNotAFewReadingsAtOneLevel) {
  auto y = over_time([](double t) { return std::min(swell(t), 0.999); });
  EXPECT_EQ(stays_of(y), 0u);
}

// Of a loop whose valve sticks before a sensor with noise.
TEST(RangeEnd, IsNotAValveThatSticks) {
  test::PiLoop loop;
  loop.proportional = 0.3;
  loop.valve = test::sticking(0.5);
  const auto y = test::run(loop, kReadings, 1).y;
  EXPECT_EQ(stays_of(y, true), 0u);
  EXPECT_EQ(stays_of(y, false), 0u);
}

}  // namespace
}  // namespace ident
