// The sums against dense least squares with every row written out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "ident/evidence/one_step_sums.hpp"
#include "support/ident/problems.hpp"
#include "support/oracle/prediction.hpp"

namespace ident {
namespace {

using test::Random;
using Signal = std::vector<double>;

// What each column is not believed, as one_step_sums.cpp has it.
constexpr double kDisbelief = 1e-6;

Signal noise(Random& random, std::size_t n) {
  Signal out(n);
  for (double& value : out) {
    value = test::normal(random);
  }
  return out;
}

// Noise through two equal lags.
Signal smoothed(Random& random, std::size_t n, double pole) {
  Signal out(n);
  double first = 0;
  double second = 0;
  for (double& value : out) {
    first = pole * first + (1 - pole) * test::normal(random);
    second = pole * second + (1 - pole) * first;
    value = 5 * second;
  }
  return out;
}

// A lag that z drives, with little noise.
Signal driven(Random& random, const Signal& z, double noise_share) {
  Signal y(z.size());
  double state = 0;
  for (std::size_t t = 0; t < z.size(); ++t) {
    y[t] = state + noise_share * test::normal(random);
    state = 0.9 * state + 0.1 * z[t];
  }
  return y;
}

struct Problem {
  Signal y, z;
};

Problem rough(std::uint64_t seed, std::size_t n) {
  Random random(seed);
  const Signal z = noise(random, n);
  return {driven(random, z, 0.1), z};
}

Problem smooth(std::uint64_t seed, std::size_t n) {
  Random random(seed);
  const Signal z = smoothed(random, n, 0.9);
  return {driven(random, z, 0.01), z};
}

// Rows of y, then of z, `rows` at a time.
template <class Real>
void sum(OneStepSums<Real>& sums, const std::vector<Real>& y, const std::vector<Real>& z,
         std::size_t rows) {
  for (std::size_t t = sums.reach(); t < y.size(); t += rows) {
    sums.add(y, {}, t, std::min(t + rows, y.size()));
  }
  sums.begin_input();
  for (std::size_t t = sums.reach(); t < y.size(); t += rows) {
    sums.add(y, z, t, std::min(t + rows, y.size()));
  }
}

// The first so many: of a dozen, or of many.
std::span<const LagBin> lags(std::size_t bins) {
  return bins <= kCoarseLagBins.size() ? std::span(kCoarseLagBins).first(bins)
                                       : std::span(kFineLagBins).first(bins);
}

template <class Real>
double error_of(const Problem& problem, std::size_t bins, std::size_t rows = 64) {
  OneStepSums<Real> sums;
  sums.start(lags(bins));
  sum(sums, test::as<Real>(problem.y), test::as<Real>(problem.z), rows);
  return static_cast<double>(sums.error());
}

TEST(OneStepSums, GiveTheErrorOfDenseLeastSquares) {
  for (const std::size_t bins : {4u, 9u, 12u, 19u}) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      const Problem of_noise = rough(seed, 900);
      const test::PredictionOracle oracle(of_noise.y, of_noise.z, lags(bins));
      const double found = error_of<double>(of_noise, bins);
      EXPECT_NEAR(found / oracle.error(kDisbelief), 1, 1e-9);
      EXPECT_NEAR(found / oracle.least_error(), 1, 2e-3);
      const Problem slow = smooth(seed, 900);
      const test::PredictionOracle of_slow(slow.y, slow.z, lags(bins));
      EXPECT_NEAR(error_of<double>(slow, bins) / of_slow.error(kDisbelief), 1, 1e-7);
      EXPECT_GE(error_of<double>(slow, bins), of_slow.least_error());
    }
  }
}

// In 1,000 samples 3·10⁻³ of the error are a nat and a half: little against the 10 that
// count.
TEST(OneStepSums, AreNearlyTheSameInFloat) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const Problem of_noise = rough(seed, 1200);
    EXPECT_NEAR(error_of<float>(of_noise, 12) / error_of<double>(of_noise, 12), 1, 1e-4);
    const Problem slow = smooth(seed, 1200);
    EXPECT_NEAR(error_of<float>(slow, 12) / error_of<double>(slow, 12), 1, 3e-3);
  }
}

TEST(OneStepSums, AreTheSameInWhateverPiecesTheRowsCome) {
  const Problem problem = smooth(5, 800);
  const double whole = error_of<double>(problem, 12, 800);
  for (const std::size_t rows : {1u, 7u, 50u}) {
    EXPECT_NEAR(error_of<double>(problem, 12, rows) / whole, 1, 1e-9) << rows;
  }
  // To the bit where the pieces are blocks.
  for (const std::size_t rows : {32u, 64u, 128u}) {
    EXPECT_EQ(error_of<float>(problem, 12, rows), error_of<float>(problem, 12, 800));
  }
}

// What y brings is summed once.
TEST(OneStepSums, ServeOneSignalAfterTheOther) {
  const Problem first = rough(6, 700);
  const Problem other = rough(7, 700);
  OneStepSums<double> sums;
  sums.start(lags(12));
  sum(sums, first.y, first.z, 64);
  const double before = sums.error();
  for (const Signal& z : {other.z, first.z}) {
    sums.begin_input();
    sums.add(first.y, z, sums.reach(), first.y.size());
    const double found = sums.error();
    EXPECT_NEAR(found / test::PredictionOracle(first.y, z, lags(12)).error(kDisbelief), 1,
                1e-9);
    if (z == first.z) {
      EXPECT_NEAR(found / before, 1, 1e-12);
    }
  }
}

TEST(OneStepSums, PutASecondSignalBesideTheFirst) {
  const Problem of_z = rough(6, 700);
  const Problem of_w = rough(7, 700);
  Signal y = of_z.y;
  for (std::size_t t = 0; t < y.size(); ++t) {
    y[t] += of_w.y[t];
  }
  OneStepSums<double> sums;
  sums.start(lags(12));
  sum(sums, y, of_z.z, 64);
  const double alone = sums.error();
  const test::PredictionOracle oracle(y, of_z.z, lags(12));
  sums.begin_input({of_w.z});
  for (std::size_t t = sums.reach(); t < y.size(); t += 50) {
    sums.add(y, of_z.z, t, std::min<std::size_t>(t + 50, y.size()));
  }
  EXPECT_NEAR(sums.error() / oracle.least_error_beside(of_w.z), 1, 2e-3);
  EXPECT_LT(sums.error(), 0.8 * alone);
  sums.begin_input();
  sums.add(y, of_z.z, sums.reach(), y.size());
  EXPECT_NEAR(sums.error() / alone, 1, 1e-12);
}

// By fine lags, too.
TEST(OneStepSums, PutOnlyTheNewestLagsOfASecondSignalBesideTheFirst) {
  if constexpr (!kStemSearch) {
    GTEST_SKIP() << "no second signal in these sizes";
  }
  const Problem of_z = rough(6, 700);
  const Problem of_w = rough(7, 700);
  Signal y = of_z.y;
  for (std::size_t t = 0; t < y.size(); ++t) {
    y[t] += of_w.y[t];
  }
  for (const std::size_t bins : {12u, 19u}) {
    const test::PredictionOracle oracle(y, of_z.z, lags(bins));
    OneStepSums<double> sums;
    sums.start(lags(bins));
    sum(sums, y, of_z.z, 64);
    for (const std::size_t newest : {std::size_t{1}, kNewestBeside}) {
      sums.begin_input({of_w.z}, newest);
      sums.add(y, of_z.z, sums.reach(), y.size());
      EXPECT_NEAR(sums.error() / oracle.least_error_beside(of_w.z, newest), 1, 2e-3);
    }
  }
}

TEST(OneStepSums, PutTheSquareOfASignalBesideIt) {
  const Problem problem = rough(6, 700);
  Signal square = problem.z;
  for (double& value : square) {
    value = (value - 0.7) * (value - 0.7);
  }
  OneStepSums<double> sums;
  sums.start(lags(12));
  sum(sums, problem.y, problem.z, 64);
  const double alone = sums.error();
  sums.begin_bent_input(0.7);
  sums.add(problem.y, problem.z, sums.reach(), problem.y.size());
  const double bent = sums.error();
  EXPECT_LT(bent, alone);
  sums.begin_input({square});
  sums.add(problem.y, problem.z, sums.reach(), problem.y.size());
  EXPECT_NEAR(bent / sums.error(), 1, 1e-12);
  sums.begin_input();
  sums.add(problem.y, problem.z, sums.reach(), problem.y.size());
  EXPECT_NEAR(sums.error() / alone, 1, 1e-12);
}

TEST(OneStepSums, TakeTheSignalThatDrivesYForTheBetterOne) {
  const Problem problem = rough(8, 800);
  Problem foreign = problem;
  foreign.z = rough(9, 800).z;
  EXPECT_LT(2 * error_of<double>(problem, 12), error_of<double>(foreign, 12));
}

// What a signal w beside z would leave of its part in y.
template <class Real>
double planted(const Problem& problem, const Signal& w, std::size_t thinning,
               std::size_t bins) {
  const std::vector<Real> y = test::as<Real>(problem.y);
  const std::vector<Real> added = test::as<Real>(w);
  std::vector<Real> raw;  // each of z's values `thinning` times, around it
  for (const double value : problem.z) {
    for (std::size_t k = 0; k < thinning; ++k) {
      const double off = static_cast<double>(k) - static_cast<double>(thinning - 1) / 2;
      raw.push_back(static_cast<Real>(value + off / 16));
    }
  }
  OneStepSums<Real> sums;
  sums.start(lags(bins));
  sum(sums, y, test::as<Real>(problem.z), 64);
  EXPECT_GT(sums.error(), 0);
  sums.solve_weights();
  sums.begin_planted();
  for (std::size_t t = sums.reach(); t < y.size(); t += 96) {
    sums.add_planted(y, {raw, thinning}, added, t,
                     std::min<std::size_t>(t + 96, y.size()));
  }
  return static_cast<double>(sums.planted());
}

TEST(OneStepSums, TellWhatAPlantedStemWouldLeave) {
  for (const std::uint64_t seed : {11u, 12u, 13u}) {
    Random random(seed);
    const Signal w = smoothed(random, 900, 0.7);
    for (const Problem& problem : {rough(seed, 900), smooth(seed, 900)}) {
      for (const std::size_t bins : {5u, 12u}) {
        const test::PredictionOracle oracle(problem.y, problem.z, lags(bins));
        const double expected = oracle.planted(w, kDisbelief);
        EXPECT_GT(expected, 0);
        EXPECT_NEAR(planted<double>(problem, w, 1, bins) / expected, 1, 1e-6);
        EXPECT_NEAR(planted<double>(problem, w, 3, bins) / expected, 1, 1e-6);
        EXPECT_NEAR(planted<float>(problem, w, 1, bins) / expected, 1, 0.05);
      }
    }
  }
}

// A part that z itself has leaves nothing but the disbelief.
TEST(OneStepSums, AStemThatIsAMultipleOfZLeavesNothing) {
  const Problem problem = rough(14, 900);
  const Signal doubled = [&] {
    Signal out = problem.z;
    for (double& value : out) {
      value *= 2;
    }
    return out;
  }();
  Random random(15);
  const double foreign = planted<double>(problem, noise(random, 900), 1, 12);
  EXPECT_LT(planted<double>(problem, doubled, 1, 12), 1e-3 * foreign);
  EXPECT_EQ(planted<double>(problem, Signal(900, 0.0), 1, 12), 0);
}

// A column that is a copy, constant or all zero is left out, and tells nothing.
TEST(OneStepSums, BearColumnsThatDependOnEachOther) {
  for (const Problem& problem : {rough(16, 800), smooth(16, 800)}) {
    const Problem rests{problem.y, Signal(800, 0.0)};
    const Problem constant{problem.y, Signal(800, 3.0)};
    const Problem copied{problem.y, problem.y};
    const double alone = error_of<double>(rests, 12);
    EXPECT_TRUE(std::isfinite(alone));
    EXPECT_GT(alone, 0);
    for (const Problem& none : {constant, copied}) {
      EXPECT_NEAR(error_of<double>(none, 12) / alone, 1, 1e-4);
      EXPECT_NEAR(error_of<float>(none, 12) / alone, 1, 1e-3);
    }
    EXPECT_LT(error_of<double>(problem, 12), alone);
  }
}

// Above 0 even where nothing is left to predict.
TEST(OneStepSums, GiveAnErrorAboveZero) {
  Signal line(600), rest(600, 0.0);
  for (std::size_t t = 0; t < line.size(); ++t) {
    line[t] = std::sin(0.1 * static_cast<double>(t));
  }
  for (const Problem& problem : {Problem{line, line}, Problem{rest, rest},
                                 Problem{rest, line}, Problem{line, rest}}) {
    for (const double found :
         {error_of<double>(problem, 12), error_of<float>(problem, 12)}) {
      EXPECT_GT(found, 0);
      EXPECT_LT(found, 1);
    }
  }
}

TEST(OneStepSums, LookBackAsFarAsTheirBins) {
  OneStepSums<double> sums;
  for (const auto& [bins, reach] : {std::pair<std::size_t, std::size_t>{1, 1},
                                    {4, 4},
                                    {9, 15},
                                    {12, 60},
                                    {16, 16},
                                    {19, 60}}) {
    sums.start(lags(bins));
    EXPECT_EQ(sums.reach(), reach) << bins;
  }
}

// `start` forgets the window before.
TEST(OneStepSums, BeginAnew) {
  const Problem problem = rough(17, 700);
  OneStepSums<double> sums;
  sums.start(lags(12));
  sum(sums, problem.z, problem.y, 64);
  EXPECT_GT(sums.error(), 0);
  sums.start(lags(9));
  sum(sums, problem.y, problem.z, 64);
  EXPECT_EQ(sums.error(), error_of<double>(problem, 9));
}

// What a setpoint makes of y, no z has to: beside it neither z foretells anything.
TEST(OneStepSums, ASetpointStandsBesideEverySignal) {
  if (!kStemSearch) GTEST_SKIP() << "no stems are searched in this size";
  Random random(7);
  const std::size_t n = 900;
  Signal sp(n);
  for (std::size_t t = 1; t < n; ++t) {
    sp[t] = t % 90 == 0 ? 20 * test::normal(random) : sp[t - 1];
  }
  const Signal y = driven(random, sp, 0.3);
  for (double& value : sp) {
    value += 200;
  }
  const Signal z = noise(random, n);
  OneStepSums<double> sums;
  const auto error_with = [&](const ThinnedSignal<double>& setpoint, const Signal& of) {
    sums.start(kLagBins);
    if (!setpoint.values.empty()) sums.stand_beside(setpoint);
    sums.add(y, {}, sums.reach(), n);
    sums.begin_input();
    sums.add(y, of, sums.reach(), n);
    return sums.error();
  };
  const ThinnedSignal<double> known{sp};
  EXPECT_GT(error_with(known, sp), 0.7 * error_with(known, z)) << "in coarser lags";
  const double without = error_with({}, z);
  const double with = error_with(known, z);
  EXPECT_LT(with, 0.8 * without);
  sums.solve_weights();
  const std::size_t middle = (sums.reach() + n) / 2;
  EXPECT_NEAR(
      (sums.error_of(y, z, sums.reach(), middle) + sums.error_of(y, z, middle, n)) / with,
      1, 1e-2)
      << "the parts are the whole, but for what is not believed";
}

}  // namespace
}  // namespace ident
