#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "ident/base/residual_structure.hpp"
#include "support/ident/all_at_once.hpp"

namespace ident {
namespace {

std::vector<double> white(unsigned seed, std::size_t count) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values(count);
  for (double& value : values) value = normal(engine);
  return values;
}

// White noise with a burst every hundred samples, of a share of the squared error.
std::vector<double> with_bursts(unsigned seed, std::size_t length, double share) {
  std::vector<double> values = white(seed, 2000);
  const double height = std::sqrt(100 * share / static_cast<double>(length));
  for (std::size_t t = 0; t < values.size(); ++t) {
    const bool up = t % 200 < 100;
    if (t % 100 < length) values[t] += up ? height : -height;
  }
  return values;
}

double structure(const std::vector<double>& values) {
  const std::vector<double> zero(values.size(), 0.0);
  return test::residual_structure<double>(values, zero);
}

TEST(ResidualStructure, OfWhiteNoiseIsMostlyBelowTwo) {
  int above = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    above += structure(white(seed, 800)) > 2 ? 1 : 0;
  }
  EXPECT_LT(above, 35);
}

TEST(ResidualStructure, SeesATenthOfTheSquaredErrorInBurstsShortAndLong) {
  for (const std::size_t length : {1, 4, 16}) {
    int seen = 0;
    for (unsigned seed = 1; seed <= 50; ++seed) {
      seen += structure(with_bursts(seed, length, 0.1)) > 2 ? 1 : 0;
    }
    EXPECT_GT(seen, 45) << length;
  }
}

TEST(ResidualStructure, OfAlternatingErrorsIsNone) {
  std::vector<double> values(400);
  for (std::size_t t = 0; t < values.size(); ++t) values[t] = t % 2 == 0 ? 1 : -1;
  EXPECT_LE(structure(values), 0.1);
}

TEST(ResidualStructure, DependsOnTheDifferenceOnlyAndHasNoUnit) {
  const std::vector<double> values = with_bursts(3, 10, 0.3);
  std::vector<double> y = values;
  std::vector<double> simulated(y.size());
  for (std::size_t t = 0; t < y.size(); ++t) {
    simulated[t] = static_cast<double>(t % 9);
    y[t] = 1e4 * values[t] + simulated[t];
  }
  EXPECT_NEAR(test::residual_structure<double>(y, simulated), structure(values), 1e-6);
}

TEST(ResidualStructure, OfNoErrorOrTooFewSamplesIsNone) {
  EXPECT_EQ(structure(std::vector<double>(100, 0.0)), 0);
  EXPECT_EQ(structure({}), 0);
  EXPECT_EQ(structure(std::vector<double>(31, 1.0)), 0);
}

}  // namespace
}  // namespace ident
