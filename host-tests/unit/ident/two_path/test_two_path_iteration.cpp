#include <gtest/gtest.h>

#include <cmath>

#include "ident/two_path/two_path_iteration.hpp"
#include "support/ident/all_at_once.hpp"
#include "support/ident/loop.hpp"

namespace ident {
namespace {

using test::Random;

double fit_of(const TwoPathModel<double>& model, const test::Window& w) {
  std::vector<double> x(w.u.size());
  std::vector<double> y(w.u.size());
  test::valve_positions<double>(model, w.u, w.ascending, x);
  test::free_run<double>(model.process, x, {}, y);
  return test::fit_percent<double>(y, w.y);
}

template <class Real>
class Iteration : public testing::Test {
 protected:
  LaggedGram<Real> gram_;
  TwoPathIteration<Real> iteration_;
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Iteration, Reals);

template <class Real>
bool fit(LaggedGram<Real>& gram, TwoPathIteration<Real>& iteration, const test::Window& w,
         int fine_ascending, int fine_descending, const Structure& s,
         TwoPathModel<Real>& model) {
  const auto grid = test::uniform_grid<Real>(fine_ascending, fine_descending);
  if constexpr (std::is_same_v<Real, double>) {
    test::accumulate(gram, grid, w.view());
    return test::fit(iteration, gram, s, model);
  } else {
    const test::FloatWindow window(w);
    test::accumulate(gram, grid, window.view());
    return test::fit(iteration, gram, s, model);
  }
}

// y(t) = 0.8·y(t−1) + x(t−1) + 0.1, x_A = u − 0.2, x_D = u. One segment each.
TYPED_TEST(Iteration, RecoversAFirstOrderProcessBehindTwoLines) {
  using Real = TypeParam;
  Random random(13);
  test::Window w = test::random_window(random, 400);
  TwoPathModel<double> truth;
  truth.process.a = {-0.8};
  truth.process.b = {1};
  truth.process.d = 0.1;
  truth.ascending.knots = truth.descending.knots = {0, 1};
  truth.ascending.x = {-0.2, 0.8};
  truth.descending.x = {0, 1};
  test::simulate(truth, 0, random, w);
  TwoPathModel<Real> model;
  ASSERT_TRUE(fit(this->gram_, this->iteration_, w, 1, 1, {1, 1, 0, 1, 1}, model));
  // Float: the sums' relative error of 10⁻⁵ times a condition number of 10.
  const double tolerance = std::is_same_v<Real, float> ? 5e-3 : 2e-3;
  EXPECT_NEAR(model.process.a[0], -0.8, tolerance);
  EXPECT_NEAR(model.process.b[0], 1, 1e-6);
  EXPECT_NEAR(model.process.d, 0.1, tolerance);
  EXPECT_NEAR(model.ascending.x[0], -0.2, tolerance);
  EXPECT_NEAR(model.ascending.x[1], 0.8, tolerance);
  EXPECT_EQ(model.descending.x[0], 0);
  EXPECT_NEAR(model.descending.x[1], 1, tolerance);
}

// The gauge of the header, whatever the data: x_D(first) = 0, ‖b‖ = 1, Σb > 0, rising
// paths.
TYPED_TEST(Iteration, KeepsItsGauge) {
  using Real = TypeParam;
  Random random(14);
  for (int k = 0; k < 60; ++k) {
    const int nb = 1 + static_cast<int>(random() % kMaxNb);
    const int na = 1 + static_cast<int>(random() % kMaxNa);
    test::Window w = test::random_window(random, 300);
    const auto truth = test::random_model(
        random, 4, 4,
        test::random_process(random, na, nb, static_cast<int>(random() % 6)));
    test::simulate(truth, 0.05, random, w);
    TwoPathModel<Real> model;
    ASSERT_TRUE(fit(this->gram_, this->iteration_, w, 4, 4, {na, nb, 2, 4, 4}, model));
    Real norm = 0;
    Real sum = 0;
    for (int j = 0; j < nb; ++j) {
      norm += model.process.b[j] * model.process.b[j];
      sum += model.process.b[j];
    }
    EXPECT_NEAR(norm, 1, 1e-5);
    EXPECT_GT(sum, 0);
    EXPECT_EQ(model.descending.x[0], 0);
    for (int i = 0; i < 4; ++i) {
      EXPECT_LE(model.ascending.x[i], model.ascending.x[i + 1]) << k;
      EXPECT_LE(model.descending.x[i], model.descending.x[i + 1]) << k;
    }
  }
}

TYPED_TEST(Iteration, GivesACoarsePathFromAFineGrid) {
  using Real = TypeParam;
  Random random(15);
  test::Window w = test::random_window(random, 500);
  const auto truth =
      test::random_model(random, 3, 2, test::random_process(random, 2, 2, 1));
  test::simulate(truth, 0.01, random, w);
  TwoPathModel<Real> coarse;
  TwoPathModel<Real> fine;
  ASSERT_TRUE(fit(this->gram_, this->iteration_, w, 3, 2, {2, 2, 1, 3, 2}, coarse));
  ASSERT_TRUE(fit(this->gram_, this->iteration_, w, 12, 12, {2, 2, 1, 3, 2}, fine));
  EXPECT_EQ(fine.ascending.segments, 12);
  const double tolerance = std::is_same_v<Real, float> ? 5e-3 : 1e-8;
  for (int i = 0; i <= 12; ++i) {
    const Real u = static_cast<Real>(i) / Real(12);
    EXPECT_NEAR(fine.ascending.at(u), coarse.ascending.at(u), tolerance);
    EXPECT_NEAR(fine.descending.at(u), coarse.descending.at(u), tolerance);
  }
  EXPECT_NEAR(fine.process.a[1], coarse.process.a[1], tolerance);
}

// Each half step is exact, but the alternation need not reach the best model.
TEST(TwoPathIteration, FitsNoiseFreeDataOfItsOwnKind) {
  Random random(16);
  static LaggedGram<double> gram;
  static TwoPathIteration<double> iteration;
  int good = 0;
  for (int k = 0; k < 20; ++k) {
    test::Window w = test::random_window(random, 600);
    const auto truth =
        test::random_model(random, 4, 3, test::random_process(random, 2, 2, 3));
    test::simulate(truth, 0, random, w);
    TwoPathModel<double> model;
    ASSERT_TRUE(fit(gram, iteration, w, 4, 3, {2, 2, 3, 4, 3}, model));
    good += fit_of(model, w) > 97 ? 1 : 0;
  }
  EXPECT_GE(good, 18);
}

TEST(TwoPathIteration, OfAConstantInputGivesNoModelOrAFiniteOne) {
  Random random(17);
  test::Window w;
  w.u.assign(100, 0.5);
  w.ascending.assign(100, 1);
  for (int t = 0; t < 100; ++t) {
    w.y.push_back(test::normal(random));
  }
  static LaggedGram<double> gram;
  static TwoPathIteration<double> iteration;
  TwoPathModel<double> model;
  if (fit(gram, iteration, w, 4, 4, {2, 2, 3, 4, 4}, model)) {
    for (int i = 0; i <= 4; ++i) {
      EXPECT_TRUE(std::isfinite(model.ascending.x[i]));
    }
    EXPECT_TRUE(std::isfinite(model.process.a[0]));
  }
}

// y(t) = 0.5·y(t−1) + 2·u(t−3) − 1: x = u, b is not normalised.
TYPED_TEST(Iteration, LinearRecoversTheProcess) {
  using Real = TypeParam;
  Random random(18);
  test::Window w = test::random_window(random, 300);
  for (std::size_t t = 0; t < w.y.size(); ++t) {
    w.y[t] = -1 + (t > 0 ? 0.5 * w.y[t - 1] : 0) + 2 * w.u[t > 3 ? t - 3 : 0];
  }
  const auto grid = test::uniform_grid<Real>(3, 4);
  TwoPathModel<Real> model;
  if constexpr (std::is_same_v<Real, double>) {
    test::accumulate(this->gram_, grid, w.view());
    ASSERT_TRUE(test::fit_linear(this->iteration_, this->gram_, {1, 1, 2, 1, 1}, model));
  } else {
    const test::FloatWindow window(w);
    test::accumulate(this->gram_, grid, window.view());
    ASSERT_TRUE(test::fit_linear(this->iteration_, this->gram_, {1, 1, 2, 1, 1}, model));
  }
  const double tolerance = std::is_same_v<Real, float> ? 2e-3 : 1e-10;
  EXPECT_NEAR(model.process.a[0], -0.5, tolerance);
  EXPECT_NEAR(model.process.b[0], 2, tolerance);
  EXPECT_NEAR(model.process.d, -1, tolerance);
  EXPECT_EQ(model.ascending.at(Real(0.375)), Real(0.375));
}

}  // namespace
}  // namespace ident
