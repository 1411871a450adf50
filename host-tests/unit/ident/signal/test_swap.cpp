// Exchanged columns of loops whose controller is known.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "ident/signal/swap.hpp"
#include "support/ident/pi_loop.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

TEST(Swap, IsFoundWhereTheColumnsWereExchanged) {
  for (const double pole : {0.3, 0.9, 0.97}) {
    test::PiLoop loop;
    loop.pole = pole;
    const test::LoopRecord record = test::run(loop, 600, 1);
    EXPECT_FALSE(are_swapped(record.u, record.y, {})) << pole;
    EXPECT_TRUE(are_swapped(record.y, record.u, {})) << pole;
  }
}

// A setpoint hides the law from those who do not know it; in which unit it is written
// does not matter.
TEST(Swap, ASetpointIsTakenInAnyUnit) {
  const test::LoopRecord record = test::run({}, 600, 1);
  Signal sp;
  Signal u = record.u;
  test::Random random(3);
  double level = 0;
  for (std::size_t t = 0; t < u.size(); ++t) {
    const double before = level;
    if (t % 50 == 49) level = test::normal(random);
    const double step = t > 0 ? level - before : 0;
    for (std::size_t k = t; step != 0 && k < u.size(); ++k) {
      u[k] += step + 0.1 * step * static_cast<double>(k - t + 1);
    }
    sp.push_back(17 - 40 * level);
  }
  EXPECT_TRUE(are_swapped(record.y, u, sp));
  EXPECT_FALSE(are_swapped(u, record.y, sp));
}

TEST(Swap, StaysSilentWhereNeitherReadingIsALaw) {
  test::Random random(5);
  Signal a;
  Signal b;
  for (int t = 0; t < 500; ++t) {
    a.push_back(test::normal(random));
    b.push_back(test::normal(random));
  }
  EXPECT_FALSE(are_swapped(a, b, {}));
  // u recorded one sample late: its law cannot be seen.
  const test::LoopRecord record = test::run({}, 600, 1);
  const Signal u(record.u.begin(), record.u.end() - 1);
  const Signal y(record.y.begin() + 1, record.y.end());
  EXPECT_FALSE(are_swapped(u, y, {}));
  EXPECT_FALSE(are_swapped(y, u, {}));
}

// A static valve curve without noise: either column is a function of the other.
TEST(Swap, StaysSilentWhereAProcessFollowsAtOnce) {
  const test::LoopRecord record = test::run({}, 600, 1);
  Signal doubled = record.u;
  for (double& v : doubled) v = 2 * v + 1;
  EXPECT_FALSE(are_swapped(record.u, doubled, {}));
}

// Each step of y is one of u at once: a proportional law in both readings.
TEST(Swap, StaysSilentWhereARoundedProcessOutputSteps) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    test::PiLoop loop;
    loop.noise = 0.02;
    loop.load = 0.02;
    loop.integral = 0.02;
    loop.sensor = [](double y) { return 0.25 * std::round(4 * y); };
    test::LoopRecord record = test::run(loop, 1200, seed);
    for (double& u : record.u) u = 0.1 * std::round(10 * u);
    EXPECT_FALSE(are_swapped(record.u, record.y, {})) << seed;
  }
}

TEST(Swap, OffsetScaleAndPrecisionDoNotMatter) {
  test::LoopRecord record = test::run({}, 600, 1);
  for (double& v : record.u) v = 1e-3 * v + 7;
  for (double& v : record.y) v = -40 * v;
  const Signal u = test::as<double>(test::as<float>(record.u));
  const Signal y = test::as<double>(test::as<float>(record.y));
  EXPECT_TRUE(are_swapped(y, u, {}));
  EXPECT_FALSE(are_swapped(u, y, {}));
}

TEST(Swap, TooShortOrConstantRecordsSayNothing) {
  const Signal few(10, 1.0);
  const Signal many(100, 1.0);
  EXPECT_FALSE(are_swapped(few, few, {}));
  EXPECT_FALSE(are_swapped(many, many, {}));
  EXPECT_FALSE(are_swapped({}, {}, {}));
}

}  // namespace
}  // namespace ident
