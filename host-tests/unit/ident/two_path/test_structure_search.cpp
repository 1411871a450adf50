#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ident/two_path/structure_search.hpp"
#include "support/ident/loop.hpp"

namespace ident {
namespace {

using Kind = StructureSearch<double>::ValveKind;

Process<double> process(std::vector<double> a, std::vector<double> b) {
  Process<double> p;
  p.na = std::max<int>(1, static_cast<int>(a.size()));
  p.nb = static_cast<int>(b.size());
  std::copy(a.begin(), a.end(), p.a.begin());
  std::copy(b.begin(), b.end(), p.b.begin());
  return p;
}

TEST(IsProcessLike, TakesLagsAndIntegrators) {
  EXPECT_TRUE(is_process_like(process({-0.9}, {0.1})));
  EXPECT_TRUE(is_process_like(process({-1.5, 0.56}, {0.06})));  // poles 0.7 and 0.8
  EXPECT_TRUE(is_process_like(process({-1}, {0.1})));           // integrator
  EXPECT_TRUE(is_process_like(process({}, {1})));               // no dynamics
  EXPECT_TRUE(is_process_like(process({-1.6, 0.89}, {0.29})));  // rings, poles 0.8 ± 0.5i
}

TEST(IsProcessLike, RefusesNegativeGain) {
  EXPECT_FALSE(is_process_like(process({-0.9}, {-0.1})));
  EXPECT_FALSE(is_process_like(process({-0.9}, {0})));
}

// u = Kc·Δe + Ki·e read from u to e: e answers a step of u at once and then forgets it.
TEST(IsProcessLike, RefusesAPiControllerReadBackwards) {
  const double kc = 2;
  const double ki = 0.2;
  EXPECT_FALSE(
      is_process_like(process({-kc / (kc + ki)}, {1 / (kc + ki), -1 / (kc + ki)})));
}

// Step responses −w, 1, 1, …
TEST(IsProcessLike, ForgivesFivePercentOfTheWrongWay) {
  EXPECT_TRUE(is_process_like(process({}, {-0.049, 1.049})));
  EXPECT_FALSE(is_process_like(process({}, {-0.051, 1.051})));
}

// Step responses 1, k, k, …
TEST(IsProcessLike, WantsFortyPercentOfThePeakKept) {
  EXPECT_TRUE(is_process_like(process({}, {1, -0.59})));
  EXPECT_FALSE(is_process_like(process({}, {1, -0.61})));
}

// To zero mean and unit variance, as the search expects.
void scale(test::Window& w) {
  const double n = static_cast<double>(w.y.size());
  const double mean = std::accumulate(w.y.begin(), w.y.end(), 0.0) / n;
  double square = 0;
  for (double& value : w.y) {
    value -= mean;
    square += value * value / n;
  }
  for (double& value : w.y) {
    value /= std::sqrt(square);
  }
}

struct Found {
  StructureCandidate<double> best;
  int slices = 1;

  [[nodiscard]] double fit(const test::Window& w) const {
    return 100 * (1 - std::sqrt(best.error / static_cast<double>(w.y.size())));
  }
};

// Samples after which x first acts on y: leading b that are nearly zero are dead time
// too.
int first_action(const Process<double>& p) {
  const double most = *std::max_element(p.b.begin(), p.b.begin() + p.nb);
  int j = 0;
  while (std::abs(p.b[j]) < 0.01 * most) {
    ++j;
  }
  return p.nk + 1 + j;
}

Found search(const test::Window& w, Kind kind, int budget = 1 << 20) {
  std::vector<double> scratch(w.u.size());
  StructureSearch<double> structure;
  structure.start(w.view(), kind, scratch);
  Found found;
  while (!structure.step(budget)) {
    ++found.slices;
  }
  EXPECT_TRUE(structure.done());
  found.best = structure.best();
  return found;
}

// Two paths that differ, one lag, a dead time of four samples.
test::Window two_path_window(double noise, std::uint64_t seed) {
  test::Random random(seed);
  test::Window w = test::random_window(random, 800);
  Process<double> p;
  p.nk = 3;
  p.a[0] = -0.85;
  p.b[0] = 1;
  TwoPathModel<double> model;
  model.process = p;
  model.ascending.segments = 2;
  model.ascending.knots = {0, 0.5, 1};
  model.ascending.x = {-0.3, -0.2, 0.7};
  model.descending.segments = 2;
  model.descending.knots = {0, 0.5, 1};
  model.descending.x = {0, 0.8, 0.9};
  test::simulate(model, noise, random, w);
  scale(w);
  return w;
}

TEST(StructureSearch, FindsATwoPathModelWithoutNoise) {
  const test::Window w = two_path_window(0, 1);
  const Found found = search(w, Kind::kTwoPath);
  ASSERT_TRUE(found.best.known);
  EXPECT_GT(found.fit(w), 99.9);
  EXPECT_EQ(first_action(found.best.model.process), 4);
  EXPECT_TRUE(is_stable(found.best.model.process));
  EXPECT_TRUE(is_process_like(found.best.model.process));
  // The step between the paths, in the units of x: 1 / Σb·(1 − 0.85) of the scale of y.
  const TwoPathModel<double>& model = found.best.model;
  const double rise = model.ascending.at(1) - model.ascending.at(0);
  const auto share = [&](double x) { return x / rise; };
  // The ascending path rises by 1 in all: 0.1 to the middle. The descending one lies 0.3
  // above it at 0, 1 above it at 0.5, 0.2 above it at 1.
  EXPECT_NEAR(share(model.ascending.at(0.5) - model.ascending.at(0)), 0.1, 0.02);
  EXPECT_NEAR(share(model.descending.at(0) - model.ascending.at(0)), 0.3, 0.05);
  EXPECT_NEAR(share(model.descending.at(0.5) - model.ascending.at(0.5)), 1, 0.05);
  EXPECT_NEAR(share(model.descending.at(1) - model.ascending.at(1)), 0.2, 0.05);
}

TEST(StructureSearch, ReachesTheCeilingOfTheNoise) {
  test::Window w = two_path_window(0, 2);
  test::Random random(3);
  for (double& y : w.y) {
    y += 0.1 * test::normal(random);
  }
  scale(w);
  // The noise alone caps the fit at about 100·(1 − 0.1/√1.01) = 90.05 %.
  const Found found = search(w, Kind::kTwoPath);
  EXPECT_GT(found.fit(w), 89);
  EXPECT_LT(found.fit(w), 91.5);
}

TEST(StructureSearch, OfALinearValveFindsALinearOne) {
  test::Random random(4);
  test::Window w = test::random_window(random, 800);
  Process<double> p;
  p.na = 2;
  p.nk = 2;
  p.a = {-1.5, 0.56};
  p.b[0] = 1;
  test::free_run<double>(p, w.u, {}, w.y);
  scale(w);
  const Found linear = search(w, Kind::kLinear);
  ASSERT_TRUE(linear.best.known);
  EXPECT_GT(linear.fit(w), 99.9);
  EXPECT_EQ(first_action(linear.best.model.process), 3);
  EXPECT_EQ(linear.best.model.process.na, 2);
  EXPECT_NEAR(linear.best.model.process.a[0], -1.5, 0.01);
  EXPECT_NEAR(linear.best.model.process.a[1], 0.56, 0.01);
}

TEST(StructureSearch, OfALinearValveIsWorseWhereThereAreTwoPaths) {
  const test::Window w = two_path_window(0, 5);
  const Found two = search(w, Kind::kTwoPath);
  const Found linear = search(w, Kind::kLinear);
  EXPECT_LT(10 * two.best.error, linear.best.error);
  EXPECT_LT(two.best.aic, linear.best.aic);
}

// Equation (8) by hand: N·log(error) + 2·(na + nb + 1 + pA + pD + 2).
TEST(StructureSearch, GivesTheAicOfItsError) {
  test::Window w = two_path_window(0.3, 6);
  const double n = static_cast<double>(w.y.size());
  const auto two = search(w, Kind::kTwoPath).best;
  const auto linear = search(w, Kind::kLinear).best;
  const auto& m = two.model;
  EXPECT_NEAR(
      two.aic,
      n * std::log(two.error) + 2 * (m.process.na + m.process.nb + 1 +
                                     m.ascending.segments + m.descending.segments + 2),
      1e-6);
  EXPECT_NEAR(linear.aic,
              n * std::log(linear.error) +
                  2 * (linear.model.process.na + linear.model.process.nb + 1),
              1e-6);
}

TEST(StructureSearch, GivesTheSameInSlices) {
  const test::Window w = two_path_window(0.2, 7);
  for (const Kind kind : {Kind::kTwoPath, Kind::kLinear}) {
    const Found whole = search(w, kind);
    for (const int budget : {1, 7}) {
      const Found sliced = search(w, kind, budget);
      EXPECT_GT(sliced.slices, 10);
      EXPECT_EQ(whole.best.error, sliced.best.error);
      EXPECT_EQ(whole.best.aic, sliced.best.aic);
      EXPECT_EQ(whole.best.model.process.a, sliced.best.model.process.a);
      EXPECT_EQ(whole.best.model.ascending.x, sliced.best.model.ascending.x);
    }
  }
}

// y has nothing to do with u: whatever comes out is stable and process-like.
TEST(StructureSearch, NeverTakesAnUnstableModel) {
  for (std::uint64_t seed = 20; seed < 25; ++seed) {
    test::Random random(seed);
    test::Window w = test::random_window(random, 300);
    scale(w);
    const Found found = search(w, Kind::kTwoPath);
    if (found.best.known) {
      EXPECT_TRUE(is_stable(found.best.model.process)) << seed;
      EXPECT_TRUE(is_process_like(found.best.model.process)) << seed;
    }
  }
}

}  // namespace
}  // namespace ident
