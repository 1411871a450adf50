#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "ident/valve/valve_pass.hpp"
#include "support/ident/all_at_once.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using Values = std::vector<double>;

// Every motion averaged over two samples for each one of y.
TEST(ValvePass, AveragesPositionsWhenDecimated) {
  const Values u{0, 1, 2, 3, 4, 5};
  const Values y{0, 0, 0};
  Values x(3);
  Values scratch(3);
  SearchWindow<double> window;
  window.u = u;
  window.y = y;
  window.decimation = 2;
  window.period = 3;
  ValvePass<double> pass;
  pass.start(window, x, scratch);
  pass.place({});
  test::finish(pass);
  EXPECT_EQ(x, (Values{0.5, 2.5, 4.5}));
  ValveModel<double> backlash;
  backlash.friction.deadband = 2;
  backlash.start_known = true;
  pass.place(backlash);  // x: 0 0 1 2 3 4
  test::finish(pass);
  EXPECT_EQ(x, (Values{0, 1.5, 3.5}));
}

// A triangle of u through a valve that slides, one lag, noise; long enough for several
// pieces of everything.
class PassOver : public testing::Test {
 protected:
  static constexpr int kPeriod = 80;
  static constexpr int kSamples = 3000;

  PassOver() {
    model.friction = {0.1, 0.05, 0.05, SlipMotion::kSlides};
    model.poles = {0.9, 0};
    test::Random random(1);
    StickSlipValve<double> valve(model.friction, 0);
    double lag = 0;
    for (int t = 0; t < kSamples; ++t) {
      const int phase = t % kPeriod;
      u.push_back(2.0 * std::min(phase, kPeriod - phase) / kPeriod);
      y.push_back(4 * lag + 0.05 * test::normal(random));
      lag = 0.9 * lag + 0.1 * (valve.step(u.back()) - 0.5);
    }
    x.resize(y.size());
    scratch.resize(y.size());
    window.u = u;
    window.y = y;
    window.period = kPeriod;
    window.warm_up = kPeriod;
    pass->start(window, x, scratch);
  }
  // Steps to the end; the dearest piece.
  int dearest() {
    int most = 0;
    pieces = 0;
    while (!pass->done()) {
      most = std::max(most, pass->step());
      ++pieces;
    }
    return most;
  }

  Values u, y, x, scratch;
  SearchWindow<double> window;
  ValveModel<double> model;
  std::unique_ptr<ValvePass<double>> pass = std::make_unique<ValvePass<double>>();
  int pieces = 0;
};

TEST_F(PassOver, FitsAsTheRegressionDoesAtOnce) {
  pass->fit(model, true);
  EXPECT_LE(dearest(), 100);
  EXPECT_GT(pieces, 4);
  const ProcessFit<double> found = pass->model().fit;
  ProcessRegression<double> regression;
  const DelayRange delays = every_delay(window);
  const auto at_once = test::fit(regression, pass->positions(), y, model.poles,
                                 delays.first, delays.last, window.drift);
  EXPECT_EQ(found.error, at_once.error);
  EXPECT_EQ(found.gain_a, at_once.gain_a);
  EXPECT_EQ(found.offset, at_once.offset);
  EXPECT_LT(found.error, 0.003 * kSamples);
}

// With another process only: no piece of the placing is done again.
TEST_F(PassOver, FitsNextAsItWouldAnew) {
  pass->fit(model, true);
  test::finish(*pass);
  const ValveModel<double> before = pass->model();
  for (const bool other_valve : {false, true}) {
    ValveModel<double> next = before;
    next.poles.slow = 0.93;
    next.friction.deadband *= other_valve ? 2 : 1;
    pass->fit(next, false);
    dearest();
    const int anew = pieces;
    const double error = pass->model().fit.error;
    pass->fit(before, false);
    test::finish(*pass);
    pass->fit_next(next);
    dearest();
    EXPECT_EQ(pieces < anew, !other_valve);
    EXPECT_EQ(pass->model().fit.error, error);
  }
}

TEST_F(PassOver, ScreensBehindThePositionsThatAreThere) {
  pass->place(model);
  test::finish(*pass);
  pass->screen({0.9, 0});
  EXPECT_LE(dearest(), 100);
  ProcessRegression<double> regression;
  EXPECT_EQ(pass->model().fit.error,
            test::screen(regression, pass->positions(), y, {0.9, 0}).error);
  EXPECT_EQ(pass->model().friction.deadband, model.friction.deadband);
}

// What least squares estimates and what the simulation has agree on so few unknowns.
TEST_F(PassOver, SimulatesTheErrorThatItFitted) {
  pass->fit(model, true);
  test::finish(*pass);
  const ValveModel<double> fitted = pass->model();
  pass->simulate(fitted);
  EXPECT_LE(dearest(), 100);
  EXPECT_NEAR(pass->model().fit.error, fitted.fit.error, 1e-6 * fitted.fit.error);
  double error = 0;
  for (std::size_t t = 0; t < y.size(); ++t) {
    const double e = y[t] - pass->simulated()[t];
    error += e * e;
  }
  EXPECT_EQ(pass->model().fit.error, error);
}

TEST_F(PassOver, TellsTheRightValveFromAnother) {
  pass->fit(model, true);
  test::finish(*pass);
  pass->explain(pass->model());
  EXPECT_LE(dearest(), 100);
  EXPECT_LT(pass->structure(), kWhiteResidual);
  EXPECT_EQ(pass->structure(), test::residual_structure<double>(y, pass->simulated()));
  ValveModel<double> other = model;
  other.friction.slip_ascending = 0.5;
  pass->fit(other, true);
  test::finish(*pass);
  pass->explain(pass->model());
  test::finish(*pass);
  EXPECT_GT(pass->structure(), 10);
}

TEST_F(PassOver, UsesTheFirstSamplesOnly) {
  x.assign(x.size(), 7);
  pass->use(500);
  pass->simulate(model);
  test::finish(*pass);
  EXPECT_EQ(pass->simulated().size(), 500U);
  EXPECT_NE(x[499], 7);
  EXPECT_EQ(x[500], 7);
}

TEST_F(PassOver, StopsWhereItsBudgetEnds) {
  pass->fit(model, true);
  int left = 50;
  EXPECT_FALSE(pass->run(left));
  EXPECT_LE(left, 0);
  EXPECT_GT(left, -100);
  left = 10'000;
  EXPECT_TRUE(pass->run(left));
  EXPECT_GT(left, 0);
}

}  // namespace
}  // namespace ident
