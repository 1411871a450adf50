#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "workbench/simulate/process.hpp"
#include "workbench/simulate/random.hpp"

namespace workbench {
namespace {

// Response at t = 0, period, 2 period, … to a unit step applied at t = 0.
std::vector<double> step_response(const ProcessModel& model, double period_s,
                                  int samples) {
  Process process(model, period_s);
  std::vector<double> y;
  for (int t = 0; t < samples; ++t) {
    y.push_back(process.output());
    process.advance(1);
  }
  return y;
}

void expect_step(const ProcessModel& model, double period_s,
                 const std::function<double(double)>& without_dead_time) {
  const std::vector<double> y = step_response(model, period_s, 400);
  for (int t = 0; t < 400; ++t) {
    const double since = t * period_s - model.dead_time_s;
    const double expected = since > 1e-9 ? model.gain * without_dead_time(since) : 0;
    EXPECT_NEAR(y[t], expected, 1e-12 * (1 + std::abs(expected))) << "sample " << t;
  }
}

TEST(SimulateProcess, FirstOrder) {
  expect_step({1.25, 80, 0, 0, false}, 0.5,
              [](double t) { return 1 - std::exp(-t / 80); });
}

TEST(SimulateProcess, WholeDeadTimeOfThePaper) {
  expect_step({1.25, 80, 0, 2, false}, 0.5,
              [](double t) { return 1 - std::exp(-t / 80); });
}

TEST(SimulateProcess, DeadTimeBetweenSamples) {
  for (const double dead_time : {0.1, 0.25, 0.9, 1.3, 3.999}) {
    expect_step({-2, 1.7, 0, dead_time, false}, 0.5,
                [](double t) { return 1 - std::exp(-t / 1.7); });
  }
}

TEST(SimulateProcess, WholeDeadTimeThatDoesNotDivideExactly) {
  // 0.3 / 0.1 is a little below 3 in binary.
  expect_step({1, 1, 0, 0.3, false}, 0.1, [](double t) { return 1 - std::exp(-t); });
}

TEST(SimulateProcess, TwoUnequalLags) {
  expect_step({3, 10, 4, 1.5, false}, 1, [](double t) {
    return 1 - (10 * std::exp(-t / 10) - 4 * std::exp(-t / 4)) / 6;
  });
}

TEST(SimulateProcess, TwoEqualLags) {
  expect_step({1, 5, 5, 0, false}, 1,
              [](double t) { return 1 - (1 + t / 5) * std::exp(-t / 5); });
}

TEST(SimulateProcess, LagMuchShorterThanThePeriod) {
  expect_step({1, 0.01, 0, 0.4, false}, 1,
              [](double t) { return 1 - std::exp(-t / 0.01); });
}

TEST(SimulateProcess, PureIntegrator) {
  expect_step({0.02, 0, 0, 2.5, true}, 1, [](double t) { return t; });
}

TEST(SimulateProcess, IntegratorWithLag) {
  expect_step({0.02, 3, 0, 0.7, true}, 1,
              [](double t) { return t - 3 * (1 - std::exp(-t / 3)); });
}

TEST(SimulateProcess, StaticGainAnswersOneSampleLater) {
  const std::vector<double> y = step_response({4, 0, 0, 0, false}, 1, 3);
  EXPECT_EQ(y, (std::vector<double>{0, 4, 4}));
}

TEST(SimulateProcess, AnyInputIsASumOfSteps) {
  const ProcessModel model{1.5, 4, 1.5, 2.3, false};
  Random random("superposition", 1);
  std::vector<double> input;
  for (int t = 0; t < 120; ++t) input.push_back(random.normal());
  const std::vector<double> step = step_response(model, 1, 121);

  Process process(model, 1);
  for (int t = 0; t < 120; ++t) {
    double expected = 0;
    double last = 0;
    for (int k = 0; k < t; ++k) {
      expected += (input[k] - last) * step[t - k];
      last = input[k];
    }
    EXPECT_NEAR(process.output(), expected, 1e-11);
    process.advance(input[t]);
  }
}

}  // namespace
}  // namespace workbench
