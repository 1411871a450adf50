#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>

#include "ident/base/configurations.hpp"
#include "ident/valve/interval_search.hpp"
#include "support/ident/all_at_once.hpp"
#include "support/ident/problems.hpp"

namespace ident {
namespace {

using Bounds = ValveIntervals<double>::Bounds;

constexpr double kIntervalSwing = 1;
constexpr double kMargin = 0.004;

// A triangle of u through a valve that slides, one lag and noise; the search on that
// window and the true model, its process solved.
class IntervalsOf : public testing::Test {
 protected:
  void make(const ValveFriction<double>& friction, double noise) {
    constexpr int kPeriod = 60;
    test::Random random(1);
    StickSlipValve<double> valve(friction, 0);
    double lag = 0;
    for (int t = 0; t < 600; ++t) {
      const int phase = t % kPeriod;
      u.push_back(2.0 * std::min(phase, kPeriod - phase) / kPeriod);
      y.push_back(lag + noise * test::normal(random));
      lag = 0.9 * lag + 0.1 * valve.step(u.back());
    }
    const double n = static_cast<double>(y.size());
    const double mean = std::accumulate(y.begin(), y.end(), 0.0) / n;
    for (double& value : y) {
      value = (value - mean) / 0.3;
    }
    x.resize(y.size());
    scratch.resize(y.size());
    SearchWindow<double> window;
    window.u = u;
    window.y = y;
    window.period = kPeriod;
    window.warm_up = kPeriod;
    window.drift = false;
    search = std::make_unique<ValveSearch<double>>();
    search->start(window, x, scratch, *stems);
    model.friction = friction;
    model.poles = {0.9, 0};
    model.start_known = true;
    model = evaluate(model, true);
  }

  [[nodiscard]] ValveModel<double> evaluate(const ValveModel<double>& of,
                                            bool all_delays) const {
    search->pass().fit(of, all_delays);
    test::finish(search->pass());
    return search->pass().model();
  }

  void begin(IntervalSearch<double>& intervals, double limit) const {
    intervals.start(model, limit, kIntervalSwing, kMargin);
  }

  [[nodiscard]] ValveIntervals<double> intervals(double share, int slice = 1000) {
    IntervalSearch<double> found;
    begin(found, model.fit.error * (1 + share));
    while (!found.step(*search, slice)) {
    }
    return found.intervals();
  }

  // How far the deadband alone can be moved in one sense, by a slow scan.
  [[nodiscard]] double reach(double sense, double limit) {
    double last = 0;
    for (double step = 0.001; step < 0.5; step += 0.001) {
      ValveModel<double> moved = model;
      moved.friction.deadband += sense * step;
      if (moved.friction.deadband < 0) {
        break;
      }
      if (evaluate(moved, false).fit.error > limit) {
        break;
      }
      last = step;
    }
    return last;
  }

  std::vector<double> u, y, x, scratch;
  std::unique_ptr<ValveSearch<double>::Stems> stems =
      std::make_unique<ValveSearch<double>::Stems>();
  std::unique_ptr<ValveSearch<double>> search;
  ValveModel<double> model;
};

const ValveFriction<double> kValve{0.2, 0.2, 0.3, SlipMotion::kSlides};

void expect_inside(const Bounds& inner, const Bounds& outer) {
  EXPECT_GE(inner.low, outer.low - 1e-12);
  EXPECT_LE(inner.high, outer.high + 1e-12);
}

void expect_around(const ValveIntervals<double>& b, const ValveFriction<double>& f) {
  const auto encloses = [](const Bounds& bounds, double value) {
    EXPECT_LE(bounds.low, value);
    EXPECT_GE(bounds.high, value);
    EXPECT_GE(bounds.low, 0);
  };
  encloses(b.stick_ascending, f.stick_ascending());
  encloses(b.stick_descending, f.stick_descending());
  encloses(b.slip_ascending, f.slip_ascending);
  encloses(b.slip_descending, f.slip_descending);
}

TEST_F(IntervalsOf, AValveEncloseIt) {
  make(kValve, 0.02);
  for (const double share : {0.001, 0.02, 0.1, 0.5}) {
    expect_around(intervals(share), kValve);
  }
}

// Before any step: the margin to both sides, none of what is zero.
TEST_F(IntervalsOf, NoStepYetAreTheLeastMargin) {
  make({0.2, 0, 0.3, SlipMotion::kSlides}, 0.02);
  IntervalSearch<double> found;
  begin(found, 2 * model.fit.error);
  const auto& b = found.intervals();
  EXPECT_DOUBLE_EQ(b.stick_ascending.low, 0.196);
  EXPECT_DOUBLE_EQ(b.stick_ascending.high, 0.204);
  EXPECT_DOUBLE_EQ(b.stick_descending.low, 0.496);
  EXPECT_DOUBLE_EQ(b.stick_descending.high, 0.504);
  EXPECT_EQ(b.slip_ascending.low, 0);
  EXPECT_EQ(b.slip_ascending.high, 0);
}

// Single-parameter moves are among the directions: what a slow scan of the deadband
// reaches is reached to the last bisection, 7 evaluations a direction.
TEST_F(IntervalsOf, ADeadbandReachWhatAScanReaches) {
  make(kValve, 0.05);
  for (const double share : {0.05, 0.2, 0.5}) {
    const double limit = model.fit.error * (1 + share);
    const double up = reach(1, limit);
    const double down = reach(-1, limit);
    ASSERT_GT(up, 0.004);
    ASSERT_GT(down, 0.004);
    const Bounds& band = intervals(share).stick_ascending;
    EXPECT_GE(band.high, kValve.stick_ascending() + 0.7 * up) << share;
    EXPECT_LE(band.low, kValve.stick_ascending() - 0.7 * down) << share;
  }
}

TEST_F(IntervalsOf, AHigherLimitAreNotNarrower) {
  make(kValve, 0.05);
  const auto narrow = intervals(0.02);
  const auto wide = intervals(1);
  expect_inside(narrow.stick_ascending, wide.stick_ascending);
  expect_inside(narrow.stick_descending, wide.stick_descending);
  expect_inside(narrow.slip_ascending, wide.slip_ascending);
  expect_inside(narrow.slip_descending, wide.slip_descending);
  EXPECT_GT(wide.stick_ascending.high - wide.stick_ascending.low,
            narrow.stick_ascending.high - narrow.stick_ascending.low);
}

TEST_F(IntervalsOf, ATinyValveNeverGoBelowZero) {
  make({0.01, 0.002, 0.003, SlipMotion::kSlides}, 0.05);
  for (const double share : {0.1, 1.0, 1000.0}) {
    expect_around(intervals(share), model.friction);
  }
}

// However high the limit, no direction is followed beyond twice the swing.
TEST_F(IntervalsOf, DataThatNeverObjectAreFinite) {
  make(kValve, 0.02);
  const auto b = intervals(1e9);
  for (const Bounds& bounds :
       {b.stick_ascending, b.stick_descending, b.slip_ascending, b.slip_descending}) {
    EXPECT_GE(bounds.low, 0);
    EXPECT_LE(bounds.high, 0.5 + 2 * 2);
  }
}

TEST_F(IntervalsOf, OtherModelsAreTakenInBelowTheLimitOnly) {
  make(kValve, 0.02);
  IntervalSearch<double> found;
  const double limit = 1.1 * model.fit.error;
  begin(found, limit);
  ValveModel<double> other;
  other.known = true;
  other.friction = {0, 0.9, 0.1, SlipMotion::kResticks};
  other.fit.error = 1.01 * limit;
  found.include(other);
  EXPECT_LT(found.intervals().stick_ascending.high, 0.5);
  other.fit.error = limit;
  other.known = false;
  found.include(other);
  EXPECT_LT(found.intervals().stick_ascending.high, 0.5);
  other.known = true;
  found.include(other);
  EXPECT_DOUBLE_EQ(found.intervals().stick_ascending.high, 0.9);
  EXPECT_DOUBLE_EQ(found.intervals().slip_ascending.high, 0.9);
  EXPECT_DOUBLE_EQ(found.intervals().stick_descending.low, 0.1);
  EXPECT_DOUBLE_EQ(found.intervals().slip_descending.low, 0.1);
}

TEST_F(IntervalsOf, SlicesAreTheSame) {
  make(kValve, 0.05);
  const auto whole = intervals(0.2);
  const auto sliced = intervals(0.2, 1);
  EXPECT_EQ(whole.stick_ascending.low, sliced.stick_ascending.low);
  EXPECT_EQ(whole.stick_ascending.high, sliced.stick_ascending.high);
  EXPECT_EQ(whole.slip_descending.low, sliced.slip_descending.low);
  EXPECT_EQ(whole.slip_descending.high, sliced.slip_descending.high);
}

// Two senses of nine directions, seven evaluations each.
TEST_F(IntervalsOf, AWindowCostAtMost126Passes) {
  make(kValve, 0.05);
  IntervalSearch<double> found;
  begin(found, 1.2 * model.fit.error);
  constexpr int kPasses =
      IntervalSearch<double>::kDirections * 2 * IntervalSearch<double>::kHalvings;
  EXPECT_EQ(kPasses, 126);
  ValvePass<double>& pass = search->pass();
  int cost = 0;
  pass.fit(model, false);
  while (!pass.done()) {
    cost += pass.step();
  }
  const int units = kPasses * cost / kUnit + 1;
  int steps = 1;
  while (!found.step(*search, 1)) {
    ++steps;
  }
  EXPECT_LE(steps, units);
  EXPECT_GE(steps, units / 2);  // a slice is longer than its budget by less than a piece
  const double high = found.intervals().stick_ascending.high;
  EXPECT_TRUE(found.step(*search, 100));
  EXPECT_EQ(found.intervals().stick_ascending.high, high);
}

}  // namespace
}  // namespace ident
