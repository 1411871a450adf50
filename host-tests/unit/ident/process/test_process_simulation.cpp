#include <gtest/gtest.h>

#include <vector>

#include "ident/process/process_simulation.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using Values = std::vector<double>;

Values noise(std::size_t count) {
  test::Random random(3);
  Values x;
  while (x.size() < count) {
    x.push_back(test::uniform(random, -1, 1));
  }
  return x;
}

// Pole ½: z(t) = ½·z(t−1) + ½·(x − x(0)), from rest.
TEST(UnitGain, MakesTheSteadyGainOneOrARampOfOrderOne) {
  EXPECT_DOUBLE_EQ(unit_gain(ProcessPoles<double>{0.9, 0.5}, 100.0), 0.05);
  EXPECT_DOUBLE_EQ(unit_gain(ProcessPoles<double>{1, 0.5}, 100.0), 0.08);
}

TEST(PoleFilter, StartsInTheSteadyStateOfItsFirstSample) {
  const Values x{3, 5, 5, 3};
  PoleFilter<double> filter({0.5, 0}, x);
  Values z;
  for (const double value : x) {
    z.push_back(filter.step(value));
  }
  EXPECT_EQ(z, (Values{0, 1, 1.5, 0.75}));
}

// 8 samples of a pole that loses a hundredth in each: counted from their mean. Before
// them x stood at 4, 3 above the mean, and led to 0.
TEST(PoleFilter, OfALongMemoryIsCountedFromTheMean) {
  const std::vector<double> x{4, 0, 0, 0, 4, 0, 0, 0};
  PoleFilter<double> filter({0.99, 0}, x);
  EXPECT_DOUBLE_EQ(filter.origin(), 1);
  const auto before = filter.before();
  EXPECT_TRUE(filter.moved_before());
  EXPECT_EQ(before[0], 0);
  EXPECT_NEAR(before[1], -0.01 * 3 / 0.99, 1e-15);
  EXPECT_NEAR(before[2], (before[1] - 0.01 * 3) / 0.99, 1e-15);
  EXPECT_NEAR(filter.step(x[0]), 0.01 * 3, 1e-15);
  EXPECT_NEAR(filter.step(x[1]), 0.01 * (0.99 * 3 - 1), 1e-15);
  const PoleFilter<double> quick({0.5, 0}, x);
  EXPECT_DOUBLE_EQ(quick.origin(), 4);
  EXPECT_FALSE(quick.moved_before());
}

// Both poles go on as they did before, however alike they are.
TEST(PoleFilter, LeadsIntoTheWindowAsItGoesOn) {
  const std::vector<double> x{4, 4, 0, 0, 0, 0, 0, 0};
  for (const ProcessPoles<double>& poles :
       {ProcessPoles<double>{0.99, 0.5}, {0.99, 0.98}, {1, 0.8}, {0.999, 0.999}}) {
    PoleFilter<double> filter(poles, x);
    const auto before = filter.before();
    const double unit =
        poles.slow < 1 ? (1 - poles.slow) * (1 - poles.fast) : (1 - poles.fast) * 16 / 8;
    // (1 − slow·q)(1 − fast·q) z = unit·(x − 1)
    double older = before[1];
    double old = before[0];
    for (int t = 0; t < 2; ++t) {
      const double z = filter.step(4);
      EXPECT_NEAR(z - (poles.slow + poles.fast) * old + poles.slow * poles.fast * older,
                  unit * 3, 1e-12)
          << poles.slow << " " << poles.fast;
      older = old;
      old = z;
    }
    for (std::size_t k = 0; k + 2 < before.size(); ++k) {
      EXPECT_NEAR(before[k] - (poles.slow + poles.fast) * before[k + 1] +
                      poles.slow * poles.fast * before[k + 2],
                  unit * 3, 1e-10);
    }
  }
}

// x less its mean 2 is −1 1 1 −1; running sums −1 0 1 0, times 16/4.
TEST(PoleFilter, IntegratesWhatIsBesideTheMean) {
  const Values x{1, 3, 3, 1};
  PoleFilter<double> filter({1, 0}, x);
  Values z;
  for (const double value : x) {
    z.push_back(filter.step(value));
  }
  EXPECT_EQ(z, (Values{-4, 0, 4, 0}));
}

ProcessFit<double> fit() {
  ProcessFit<double> fit;
  fit.delay = 2;
  fit.gain_a = 1.5;
  fit.gain_b = 0.5;
  fit.offset = -0.3;
  fit.drift = 0.2;
  fit.start_slow = 0.7;
  fit.start_fast = -0.4;
  fit.drifts = true;
  return fit;
}

TEST(ProcessSimulation, GivesTheSameInPieces) {
  const Values x = noise(301);
  Values whole(x.size());
  Values pieces(x.size());
  ProcessSimulation<double> simulation;
  simulation.start(x, {0.95, 0.5}, fit(), whole);
  EXPECT_TRUE(simulation.step(x.size()));
  simulation.start(x, {0.95, 0.5}, fit(), pieces);
  std::size_t size = 1;
  while (!simulation.step(size)) {
    size = size % 7 + 1;
  }
  EXPECT_EQ(simulation.simulated(), x.size());
  EXPECT_EQ(whole, pieces);
}

TEST(ProcessSimulation, MayWriteOverItsInput) {
  const Values x = noise(100);
  Values beside(x.size());
  Values over = x;
  ProcessSimulation<double> simulation;
  simulation.start(x, {0.9, 0.3}, fit(), beside);
  simulation.step(x.size());
  simulation.start(over, {0.9, 0.3}, fit(), over);
  simulation.step(over.size());
  EXPECT_EQ(beside, over);
}

// Gains on a dead time of one sample, nothing else: y(t) = 2·(x(t−1) − x(0)) + offset.
TEST(ProcessSimulation, OfAPureDelay) {
  const Values x{1, 2, 4, 1};
  Values y(x.size());
  ProcessFit<double> delay;
  delay.delay = 1;
  delay.gain_a = 2;
  delay.offset = 5;
  ProcessSimulation<double> simulation;
  simulation.start(x, {0, 0}, delay, y);
  simulation.step(x.size());
  EXPECT_EQ(y, (Values{5, 5, 7, 11}));
}

}  // namespace
}  // namespace ident
