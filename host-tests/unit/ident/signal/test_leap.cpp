#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "ident/signal/leap.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

double leap_of(const Signal& signal, std::size_t count) {
  return leap<double>(signal, count);
}

Signal leap_noise(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Signal signal(4000);
  for (double& value : signal) value = normal(random);
  return signal;
}

TEST(Leap, IsOneForARampAndForAConstant) {
  Signal ramp(100);
  for (std::size_t t = 0; t < ramp.size(); ++t) ramp[t] = 0.5 * static_cast<double>(t);
  EXPECT_NEAR(leap_of(ramp, 4), 1, 1e-12);
  EXPECT_EQ(leap_of(Signal(100, 7.0), 4), 1);
  EXPECT_EQ(leap_of({1, 2}, 4), 1) << "no whole block";
}

// One block of 25 travels ten times as far as the others.
TEST(Leap, IsAsManyTimesTheMean) {
  for (const std::size_t at : {50U, 52U}) {
    Signal step(101);
    for (std::size_t t = 0; t < step.size(); ++t) {
      step[t] = static_cast<double>(t) + (t >= at ? 36 : 0);
    }
    EXPECT_NEAR(leap_of(step, 4), 10 / (34.0 / 25), 1e-9)
        << at << ": between two, within";
  }
}

// As of a historian that stores changes alone: the rests in between tell nothing.
TEST(Leap, RestsDoNotCount) {
  Signal held(1000);
  for (std::size_t t = 0; t < held.size(); ++t) held[t] = static_cast<double>(t / 50);
  EXPECT_EQ(leap_of(held, 4), 1);
}

TEST(Leap, OscillationsAndNoiseMayBeThinned) {
  Signal wave(4000);
  for (std::size_t t = 0; t < wave.size(); ++t) {
    wave[t] = std::sin(0.01 * static_cast<double>(t));
  }
  EXPECT_EQ(thinning_for<double>(wave, 8), 8U);
  EXPECT_EQ(thinning_for<double>(leap_noise(1), 8), 8U);
}

// As a controller kicks after a setpoint step: 4 samples in an hour of leap_noise.
TEST(Leap, AKickForbidsIt) {
  Signal kick = leap_noise(2);
  for (std::size_t t = 2000; t < 2004; ++t) kick[t] += 60;
  EXPECT_EQ(thinning_for<double>(kick, 8), 1U);
  EXPECT_EQ(thinning_for<double>(kick, 1), 1U);
}

TEST(Leap, FloatDecidesAlike) {
  std::vector<float> kick(4000);
  for (std::size_t t = 0; t < kick.size(); ++t) {
    kick[t] = std::sin(0.01f * static_cast<float>(t));
  }
  EXPECT_EQ(thinning_for<float>(kick, 8), 8U);
  kick[1001] += 5;
  EXPECT_EQ(thinning_for<float>(kick, 8), 1U);
}

}  // namespace
}  // namespace ident
