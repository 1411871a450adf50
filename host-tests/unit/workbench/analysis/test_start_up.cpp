// Start-ups before a limit cycle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "workbench/analysis/analysis.hpp"
#include "workbench/analysis/start_up.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench {
namespace {

constexpr std::size_t kRamp = 120;

// A ramp of `far` up to a sine of amplitude 1.
std::vector<double> ramp_then_sine(double far, std::size_t sine) {
  std::vector<double> u;
  for (std::size_t k = 0; k < kRamp; ++k) {
    u.push_back(-far * (1 - static_cast<double>(k) / kRamp));
  }
  for (std::size_t k = 0; k < sine; ++k) {
    u.push_back(std::sin(0.2 * static_cast<double>(k)));
  }
  return u;
}

// Of a loop whose y follows u.
std::size_t end_of(const std::vector<double>& u) {
  return start_up_end(u, u);
}

TEST(StartUp, EndsWhereOnlyTheCycleIsLeft) {
  const std::vector<double> u = ramp_then_sine(20, 800);
  const std::size_t end = end_of(u);
  EXPECT_GT(end, kRamp - 20);
  EXPECT_LE(end, kRamp);
}

TEST(StartUp, IsNoneWhereNothingCyclesAfterwards) {
  std::vector<double> step(400, 0.0);
  step.resize(1000, 50.0);
  EXPECT_EQ(end_of(step), 0U);
  EXPECT_EQ(end_of(ramp_then_sine(4, 800)), 0U) << "a swing or two is no start-up";
  EXPECT_EQ(end_of(ramp_then_sine(20, 100)), 0U) << "longer than half";
  EXPECT_EQ(end_of(ramp_then_sine(0, 880)), 0U);
  EXPECT_EQ(end_of({}), 0U);
}

// A pump that hums while its tank fills.
TEST(StartUp, IsNoneWhereTheOutputRunsOn) {
  const std::vector<double> u = ramp_then_sine(20, 800);
  std::vector<double> y;
  for (std::size_t k = 0; k < u.size(); ++k) y.push_back(static_cast<double>(k) + u[k]);
  EXPECT_EQ(start_up_end(u, y), 0U);
}

TEST(StartUp, HidesNoStickingValve) {
  const SimulatedLoop loop = *simulate("stiction-integrating", 2);
  Recording recording;
  recording.period_s = loop.period_s;
  const auto add = [&recording](double u, double y) {
    recording.t.push_back(static_cast<double>(recording.size()) * recording.period_s);
    recording.u.push_back(u);
    recording.y.push_back(y);
  };
  const auto swing = [](const std::vector<double>& signal) {
    const auto [low, high] = std::minmax_element(signal.begin(), signal.end());
    return *high - *low;
  };
  for (std::size_t k = 0; k < kRamp; ++k) {
    const double left = 1 - static_cast<double>(k) / kRamp;
    add(loop.u[0] - 8 * swing(loop.u) * left,
        loop.y[0] - 8 * swing(loop.y) * left * std::exp(3 * (left - 1)));
  }
  for (std::size_t k = 0; k < loop.u.size(); ++k) add(loop.u[k], loop.y[k]);
  const Analysis all{RecordingView(recording)};
  EXPECT_EQ(all.result().verdict, ident::Verdict::kStiction);
  ASSERT_EQ(all.notes().size(), 1U);
  EXPECT_NE(all.notes()[0].find("start-up"), std::string::npos);
}

}  // namespace
}  // namespace workbench
