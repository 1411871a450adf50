// The response to u beside the past of y: in a closed loop under a load, too.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "workbench/effects/step_response.hpp"

namespace workbench::effects {
namespace {

struct Answered {
  std::vector<double> u;
  std::vector<double> y;
};

// A process that answers u by `answer` (its impulse response), a load that wanders, and a
// controller that answers y.
Answered loop(const std::function<double(std::size_t)>& answer, double feedback,
              double load_std) {
  constexpr std::size_t kSamples = 1500;
  constexpr std::size_t kMemory = 120;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<double> weight(kMemory);
  for (std::size_t i = 1; i < kMemory; ++i) weight[i] = answer(i);
  Answered out;
  double load = 0;
  double setpoint = 0;
  for (std::size_t k = 0; k < kSamples; ++k) {
    load = 0.95 * load + load_std * normal(random);
    if (k % 60 == 0) setpoint = 5 * normal(random);
    double y = load + 0.02 * normal(random);
    for (std::size_t i = 1; i < kMemory && i <= k; ++i) y += weight[i] * out.u[k - i];
    out.y.push_back(y);
    out.u.push_back(feedback * (setpoint - y));
  }
  return out;
}

double lag_weight(std::size_t i) {
  return 0.1 * std::exp(-0.1 * static_cast<double>(i));
}

double wrong_first(std::size_t i) {
  const auto t = static_cast<double>(i);
  return 0.17 * std::exp(-0.1 * t) - 0.35 * std::exp(-0.5 * t);
}

double ringing(std::size_t i) {
  const auto t = static_cast<double>(i);
  return 0.3 * std::exp(-0.05 * t) * std::sin(2 * std::numbers::pi * t / 16);
}

TEST(StepResponse, OfALagGoesStraightWhereItEnds) {
  for (const double load : {0.0, 0.3}) {
    const Answered s = loop(lag_weight, 1, load);
    const StepResponse response = step_response_of(s.u, s.y, 1);
    EXPECT_LT(wrong_way(response), 2.5);
    EXPECT_LT(swing_back(response), 2.5);
  }
}

TEST(StepResponse, SeesTheWrongWayUnderALoadInAClosedLoop) {
  const Answered s = loop(wrong_first, 0.3, 0.1);
  EXPECT_GT(wrong_way(step_response_of(s.u, s.y, 1)), 3);
}

TEST(StepResponse, SeesAProcessRingUnderALoadInAClosedLoop) {
  const Answered s = loop(ringing, 0.2, 0.1);
  EXPECT_GT(swing_back(step_response_of(s.u, s.y, 1)), 3);
}

TEST(StepResponse, OfTooFewSamplesCannotBeTold) {
  const std::vector<double> few(20, 1.0);
  EXPECT_TRUE(step_response_of(few, few, 1).draws.empty());
  EXPECT_EQ(wrong_way({}), 0);
  EXPECT_EQ(swing_back({}), 0);
  EXPECT_EQ(samples_within(1, 80), 10u);
  EXPECT_EQ(samples_within(1, 2), 1u);
}

}  // namespace
}  // namespace workbench::effects
