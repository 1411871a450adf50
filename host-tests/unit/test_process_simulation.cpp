#include <gtest/gtest.h>

#include <vector>

#include "ident/process_simulation.hpp"
#include "support/ident_problems.hpp"

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
TEST(PoleFilter, StartsInTheSteadyStateOfItsFirstSample) {
  const Values x{3, 5, 5, 3};
  PoleFilter<double> filter({0.5, 0}, x);
  Values z;
  for (const double value : x) {
    z.push_back(filter.step(value));
  }
  EXPECT_EQ(z, (Values{0, 1, 1.5, 0.75}));
}

// x less its mean 2 is −1 1 1 −1; running sums −1 0 1 0, times 16/4.
// 8 samples of a pole that loses a hundredth in each: counted from their mean.
TEST(PoleFilter, OfALongMemoryIsCountedFromTheMean) {
  const std::vector<double> x{4, 0, 0, 0, 4, 0, 0, 0};
  PoleFilter<double> filter({0.99, 0}, x);
  EXPECT_DOUBLE_EQ(filter.origin(), 1);
  EXPECT_NEAR(filter.step(x[0]), 0.01 * 3, 1e-15);
  EXPECT_NEAR(filter.step(x[1]), 0.01 * (0.99 * 3 - 1), 1e-15);
  EXPECT_DOUBLE_EQ(PoleFilter<double>({0.5, 0}, x).origin(), 4);
}

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
