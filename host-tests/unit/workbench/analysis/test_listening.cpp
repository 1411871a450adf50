#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>

#include "workbench/analysis/listening.hpp"

namespace workbench {
namespace {

std::vector<double> heard_sine(std::size_t samples, double period) {
  std::vector<double> out(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    out[i] = std::sin(2 * std::numbers::pi * static_cast<double>(i) / period);
  }
  return out;
}

TEST(Listening, MeansDropWhatIsLeftOver) {
  EXPECT_EQ(means(std::vector<double>{1, 2, 3, 5, 9}, 2), (std::vector<double>{1.5, 4}));
  EXPECT_EQ(means(std::vector<double>{1, 2}, 1), (std::vector<double>{1, 2}));
}

TEST(Listening, HearsAFastAndASlowOscillation) {
  const Heard fast = listen(heard_sine(3000, 40));
  EXPECT_EQ(fast.thinned, 1U);
  EXPECT_NEAR(fast.period, 40, 2);
  const Heard slow = listen(heard_sine(60'000, 4000));
  EXPECT_GT(slow.thinned, 1U);
  EXPECT_NEAR(slow.period, 4000, 200);
}

// A loop that hunts while a programme moves its setpoint, and one with a ripple.
TEST(Listening, TellsTheFastestThatMatters) {
  std::vector<double> both = heard_sine(60'000, 4000);
  const std::vector<double> hunting = heard_sine(60'000, 45);
  for (std::size_t i = 0; i < both.size(); ++i) both[i] = 2 * both[i] + hunting[i];
  EXPECT_NEAR(listen(both).fastest, 45, 2);
  EXPECT_NEAR(listen(both).period, 4000, 200);
  for (std::size_t i = 0; i < both.size(); ++i) both[i] -= 0.9 * hunting[i];
  EXPECT_NEAR(listen(both).fastest, 4000, 200);
}

// A valve that was repaired at noon.
TEST(Listening, HearsWhatLastedForATenth) {
  std::vector<double> ended = heard_sine(60'000, 45);
  std::uint32_t random = 1;
  for (std::size_t i = 20'000; i < ended.size(); ++i) {
    random = random * 1'664'525 + 1'013'904'223;
    ended[i] = 0.02 * static_cast<double>(random >> 16) / 65'536;
  }
  EXPECT_NEAR(listen(ended).fastest, 45, 3);
}

TEST(Listening, TakesNoThreeWavesForAnOscillation) {
  EXPECT_EQ(listen(heard_sine(60'000, 20'000)).period, 0);
}

TEST(Listening, HearsNothingInARamp) {
  std::vector<double> ramp(2000);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<double>(i);
  EXPECT_EQ(listen(ramp).period, 0);
}

}  // namespace
}  // namespace workbench
