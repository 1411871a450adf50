#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "firmware/learn/loop_proposal.hpp"

namespace firmware {
namespace {

// u and, a tenth of a cycle later, y, in frames every `interval_s` for ten cycles.
std::vector<SeenSignal> swinging(double interval_s, double cycle_s, double cycles = 10) {
  std::vector<SeenSignal> out(2);
  for (std::size_t k = 0; k < out.size(); ++k) {
    SeenSignal& signal = out[k];
    signal.name = k == 0 ? "OP" : "PV";
    signal.bus = "can0";
    signal.low = -1;
    signal.high = 1;
    signal.interval_s = interval_s;
    signal.moving = 1;
    for (double t = 0; t < cycles * cycle_s; t += interval_s) {
      const double at = t / cycle_s - 0.1 * static_cast<double>(k);
      signal.t_s.push_back(t);
      signal.value.push_back(std::sin(2 * std::numbers::pi * at));
    }
  }
  return out;
}

double period_proposed(const std::vector<SeenSignal>& signals) {
  const std::vector<LoopProposal> loops = propose_loops(signals);
  return loops.empty() ? 0 : loops[0].sample_period_s;
}

TEST(LoopProposal, TakesThePeriodOfTheFramesWhereTheWindowHoldsTenCycles) {
  EXPECT_DOUBLE_EQ(period_proposed(swinging(1, 141)), 1);
  EXPECT_DOUBLE_EQ(period_proposed(swinging(1.0004, 141)), 1);
  EXPECT_DOUBLE_EQ(period_proposed(swinging(0.67, 41)), 0.67);
  EXPECT_DOUBLE_EQ(period_proposed(swinging(3, 141)), 3);
}

TEST(LoopProposal, ThinsWhatIsTooFast) {
  EXPECT_DOUBLE_EQ(period_proposed(swinging(0.1, 141)), 2);
  EXPECT_DOUBLE_EQ(period_proposed(swinging(0.01, 10)), 0.2);
}

TEST(LoopProposal, IsNeverFasterThanTheFrames) {
  // Too few cycles for an oscillation: a second, or what the frames give.
  EXPECT_DOUBLE_EQ(period_proposed(swinging(0.5, 400, 1.5)), 1);
  EXPECT_DOUBLE_EQ(period_proposed(swinging(3, 400, 1.5)), 3);
}

}  // namespace
}  // namespace firmware
