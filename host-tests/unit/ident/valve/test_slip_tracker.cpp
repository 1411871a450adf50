// The tracker on valves that stop or restick, with a known process behind them.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#include "ident/valve/slip_tracker.hpp"
#include "support/ident/all_at_once.hpp"

namespace ident {
namespace {

constexpr int kCyclePeriod = 80;

ValveFriction<double> truth(SlipMotion motion) {
  return {0.12, 0.35, 0.2, motion};
}

struct TrackedLoop {
  std::vector<double> u, y;
};

// A wave of slowly changing height through the valve and a process with a lag of 15
// samples (or an integrator), noise a tenth of y.
TrackedLoop loop(SlipMotion motion, bool integrating, double noise = 0.1,
                 unsigned seed = 7) {
  constexpr std::size_t kSamples = 1200;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  StickSlipValve<double> valve(truth(motion), 0.5);
  TrackedLoop l;
  double lagged = 0.5;
  double x = 0.5;  // acts on y one sample later
  for (std::size_t t = 0; t < kSamples; ++t) {
    const double time = static_cast<double>(t);
    const double height = 0.45 + 0.04 * std::sin(time / 170);
    l.u.push_back(0.5 + height * std::sin(2 * M_PI * time / kCyclePeriod) +
                  0.003 * normal(random));
    lagged = integrating ? lagged + 0.05 * (x - 0.5)
                         : std::exp(-1.0 / 15) * lagged + (1 - std::exp(-1.0 / 15)) * x;
    x = valve.step(l.u.back());
    l.y.push_back(lagged);
  }
  const double n = static_cast<double>(kSamples);
  const double mean = std::accumulate(l.y.begin(), l.y.end(), 0.0) / n;
  double variance = 0;
  for (const double value : l.y) {
    variance += (value - mean) * (value - mean) / n;
  }
  for (double& value : l.y) {
    value = (value - mean) / std::sqrt(variance) + noise * normal(random);
  }
  return l;
}

class Tracked {
 public:
  Tracked(const TrackedLoop& l, ValveFriction<double> from,
          const ProcessPoles<double>& poles, std::size_t active)
      : x_(l.y.size()), scratch_(l.y.size()) {
    window_.u = l.u;
    window_.y = l.y;
    window_.period = kCyclePeriod;
    window_.swing = 0.9;
    ValveModel<double> model;
    model.known = true;
    model.friction = from;
    model.poles = poles;
    StickSlipValve<double> valve(from, 0.5);
    for (std::size_t t = 0; t < active; ++t) {
      x_[t] = valve.step(l.u[t]);
    }
    const std::span<const double> x(x_.data(), active);
    model.fit = test::fit(regression_, x, window_.y.first(active), poles, 1, 10, true);
    tracker_->start(window_, model, active, x_, scratch_, *stems_, regression_);
  }
  const SlipTracker<double>::State& rounds(int count, double spread) {
    for (int round = 0; round < count; ++round) {
      tracker_->begin_round(spread);
      while (!tracker_->step()) {
        ++steps;
      }
      spread = std::max(0.75 * spread, 0.01);
    }
    return tracker_->best();
  }
  void resume() {
    const auto state = tracker_->best();
    tracker_->resume(state, false);
  }
  int steps = 0;

 private:
  SearchWindow<double> window_;
  std::vector<double> x_;
  std::vector<double> scratch_;
  ProcessRegression<double> regression_;
  std::unique_ptr<SlipTracker<double>::Stems> stems_ =
      std::make_unique<SlipTracker<double>::Stems>();
  std::unique_ptr<SlipTracker<double>> tracker_ = std::make_unique<SlipTracker<double>>();
};

ValveFriction<double> off_by(double share, SlipMotion motion) {
  ValveFriction<double> friction = truth(motion);
  friction.slip_ascending *= 1 + share;
  friction.slip_descending *= 1 - share;
  return friction;
}

void expect_bands_near(const ValveFriction<double>& found, double apart) {
  const ValveFriction<double> true_friction = truth(found.motion);
  EXPECT_NEAR(found.stick_ascending(), true_friction.stick_ascending(), apart);
  EXPECT_NEAR(found.stick_descending(), true_friction.stick_descending(), apart);
}

double farthest_band(const ValveFriction<double>& found) {
  const ValveFriction<double> true_friction = truth(found.motion);
  return std::max(std::abs(found.stick_ascending() - true_friction.stick_ascending()),
                  std::abs(found.stick_descending() - true_friction.stick_descending()));
}

class SlipTrackerOn : public testing::TestWithParam<SlipMotion> {};

// A free simulation with slips 8 % off loses step within three cycles.
TEST_P(SlipTrackerOn, FindsTheSlipsFromNearby) {
  const TrackedLoop l = loop(GetParam(), false);
  Tracked tracked(l, off_by(0.08, GetParam()), {pole_of(20.0), 0}, 170);
  tracked.rounds(3, 0.2);
  tracked.resume();
  const auto& best = tracked.rounds(10, 0.1);
  // Fewer slips tell less.
  expect_bands_near(best.model.friction, GetParam() == SlipMotion::kStops ? 0.04 : 0.02);
  EXPECT_EQ(best.model.friction.motion, GetParam());
  EXPECT_LT(best.misfit, 0.2);
}

TEST_P(SlipTrackerOn, FollowsAnIntegratingProcess) {
  constexpr int kDraws = 20;
  int near = 0;
  for (unsigned seed = 1; seed <= kDraws; ++seed) {
    const TrackedLoop l = loop(GetParam(), true, 0.03, seed);
    Tracked tracked(l, off_by(0.05, GetParam()), {1, 0}, 170);
    tracked.rounds(3, 0.2);
    tracked.resume();
    const auto& best = tracked.rounds(10, 0.1);
    EXPECT_EQ(best.model.poles.slow, 1);
    near += farthest_band(best.model.friction) < 0.03 ? 1 : 0;
  }
  // A few end in step with another valve.
  EXPECT_GE(near, kDraws * 7 / 10);
}

TEST_P(SlipTrackerOn, ARoundHasABoundedNumberOfSteps) {
  const TrackedLoop l = loop(GetParam(), false);
  Tracked tracked(l, truth(GetParam()), {pole_of(15.0), 0}, 170);
  tracked.rounds(1, 0.2);
  // No more samples than there are, then the fits, each a path and its regression.
  const int samples = static_cast<int>(l.y.size());
  const int pieces_of_fit = 2 + samples / 128;
  EXPECT_LE(tracked.steps, samples + (SlipTracker<double>::kFits + 1) * pieces_of_fit);
}

TEST_P(SlipTrackerOn, IsRepeatable) {
  const TrackedLoop l = loop(GetParam(), false);
  Tracked one(l, truth(GetParam()), {pole_of(15.0), 0}, 170);
  Tracked other(l, truth(GetParam()), {pole_of(15.0), 0}, 170);
  EXPECT_EQ(one.rounds(2, 0.2).misfit, other.rounds(2, 0.2).misfit);
}

INSTANTIATE_TEST_SUITE_P(Motions, SlipTrackerOn,
                         testing::Values(SlipMotion::kStops, SlipMotion::kResticks));

// Bands far below the noise of u: every stem slips at almost every sample, and no round
// can be kept.
TEST(SlipTracker, KeepsItsStartWhereTheSlipsDoNotFit) {
  const TrackedLoop l = loop(SlipMotion::kResticks, false);
  const ValveFriction<double> tiny{0, 1e-5, 1e-5, SlipMotion::kResticks};
  Tracked tracked(l, tiny, {pole_of(15.0), 0}, 170);
  const auto& best = tracked.rounds(2, 0.2);
  EXPECT_EQ(best.model.friction.slip_ascending, 1e-5);
}

}  // namespace
}  // namespace ident
