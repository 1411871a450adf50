// Float functions against the double ones of the C library, and their odd arguments.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "ident/base/elementary.hpp"

namespace ident::elementary {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

TEST(Elementary, ExpAndLogAreRight) {
  for (float x = -86.99999F; x < 88.7F; x += 0.0137F) {
    const double exact = std::exp(static_cast<double>(x));
    ASSERT_NEAR(static_cast<double>(exp(x)) / exact, 1, 3e-7) << x;
  }
  for (float x = 1e-37F; x < 1e37F; x *= 1.0137F) {
    const double exact = std::log(static_cast<double>(x));
    ASSERT_NEAR(log(x), exact, 3e-7 * std::abs(exact)) << x;
  }
  // Poles of slow processes.
  for (float left = 0.3F; left > 1e-6F; left *= 0.97F) {
    const float pole = 1 - left;
    const double exact = std::log(static_cast<double>(pole));
    ASSERT_NEAR(static_cast<double>(log(pole)) / exact, 1, 3e-7) << pole;
  }
  EXPECT_EQ(exp(0.0F), 1);
  EXPECT_EQ(log(1.0F), 0);
}

TEST(Elementary, ManyExponentialsAreThoseOfOne) {
  std::array<float, 7> x{0, -0.5F, -16.1F, -15.9F, -3, -kInfinity, -1e-9F};
  std::array<float, 7> out;
  exp_of_negative(x, out);
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_EQ(out[i], x[i] > -16 ? exp(x[i]) : 0) << x[i];
  }
  std::array<double, 2> y{-1, -17};
  exp_of_negative(y, y);
  EXPECT_EQ(y[0], exp(-1.0));
  EXPECT_EQ(y[1], 0);
}

TEST(Elementary, PowIsRight) {
  for (const float base : {0.01F, 0.7F, 0.9995F, 1.1F, 20.0F}) {
    for (const float exponent : {0.0F, 0.33333334F, 1.0F, 17.0F, -3.5F}) {
      const double exact =
          std::pow(static_cast<double>(base), static_cast<double>(exponent));
      ASSERT_NEAR(static_cast<double>(pow(base, exponent)) / exact, 1,
                  3e-7 * (1 + std::abs(std::log(exact))));
    }
  }
}

TEST(Elementary, AnglesAreRight) {
  for (float x = -1000; x < 1000; x += 0.0711F) {
    const double of = static_cast<double>(x);
    ASSERT_NEAR(sin(x), std::sin(of), 3e-7) << x;
    ASSERT_NEAR(cos(x), std::cos(of), 3e-7) << x;
    const double slope = std::tan(of);
    ASSERT_NEAR(tan(x), slope, 3e-7 * (1 + slope * slope)) << x;
    for (const float radius : {1e-6F, 1.0F, 3e7F}) {
      const float a = radius * sin(x);
      const float b = radius * cos(x);
      ASSERT_NEAR(atan2(a, b), std::atan2(static_cast<double>(a), static_cast<double>(b)),
                  5e-7);
    }
  }
  EXPECT_EQ(atan2(0.0F, 0.0F), 0);
  EXPECT_EQ(atan2(0.0F, 1.0F), 0);
  EXPECT_NEAR(atan2(0.0F, -1.0F), 3.1415927F, 5e-7);
  EXPECT_NEAR(atan2(-1.0F, 0.0F), -1.5707963F, 5e-7);
  EXPECT_FLOAT_EQ(hypot(3.0F, -4.0F), 5);
}

TEST(Elementary, OddArgumentsGiveWhatTheLibraryGives) {
  EXPECT_EQ(exp(kInfinity), kInfinity);
  EXPECT_EQ(exp(100.0F), kInfinity);
  EXPECT_EQ(exp(-kInfinity), 0);
  EXPECT_EQ(exp(-100.0F), 0);
  EXPECT_TRUE(std::isnan(exp(kNaN)));
  EXPECT_EQ(log(0.0F), -kInfinity);
  EXPECT_EQ(log(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(log(-1.0F)));
  EXPECT_TRUE(std::isnan(log(kNaN)));
}

// A hash of many results, the same on every target that runs the tests.
TEST(Elementary, BitsAreTheSameOnEveryTarget) {
  std::uint32_t hash = 2166136261U;
  const auto take = [&hash](float value) {
    hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 16777619U;
  };
  for (float x = 0.001F; x < 80; x *= 1.003F) {
    take(exp(x));
    take(exp(-x));
    take(log(x));
    take(pow(x, 0.3F));
    take(sin(x));
    take(cos(x));
    take(tan(x));
    take(atan2(x, 2.0F));
    take(hypot(x, 2.0F));
  }
  EXPECT_EQ(hash, 1979100856U);
}

TEST(Elementary, DoubleIsTheLibrarys) {
  EXPECT_EQ(exp(1.5), std::exp(1.5));
  EXPECT_EQ(log(1.5), std::log(1.5));
  EXPECT_EQ(pow(1.5, 2.5), std::pow(1.5, 2.5));
  EXPECT_EQ(sin(1.5), std::sin(1.5));
  EXPECT_EQ(cos(1.5), std::cos(1.5));
  EXPECT_EQ(tan(1.5), std::tan(1.5));
  EXPECT_EQ(atan2(1.5, 2.5), std::atan2(1.5, 2.5));
  EXPECT_EQ(hypot(1.5, 2.5), std::hypot(1.5, 2.5));
}

}  // namespace
}  // namespace ident::elementary
