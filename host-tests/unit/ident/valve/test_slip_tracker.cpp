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
  int decimation = 1;
  double pole = 0;        // of the process, a sample of u; 1: it integrates
  double middle = 0;      // of the stem, where y is 0
  double gain = 0;        // of y, scaled: steady, or a sample of u where it integrates
  std::vector<double> x;  // the stem, averaged like y
};

struct LoopOptions {
  bool integrating = false;
  double noise = 0.1;
  unsigned seed = 7;
  std::size_t delay = 1;
  int decimation = 1;
  double stem = 0.5;           // before the first sample
  std::size_t samples = 1200;  // of y
};

// Scaled to zero mean and unit variance, then noise.
void scale_output(TrackedLoop& l, double noise, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double n = static_cast<double>(l.y.size());
  const double mean = std::accumulate(l.y.begin(), l.y.end(), 0.0) / n;
  double variance = 0;
  for (const double value : l.y) {
    variance += (value - mean) * (value - mean) / n;
  }
  const double deviation = std::sqrt(variance);
  for (double& value : l.y) {
    value = (value - mean) / deviation + noise * normal(random);
  }
  l.gain /= deviation;
  l.middle = l.pole < 1 ? mean : l.middle;
}

std::vector<double> means(const std::vector<double>& values, int decimation) {
  std::vector<double> of;
  const std::size_t each = static_cast<std::size_t>(decimation);
  for (std::size_t t = 0; t + each <= values.size(); t += each) {
    of.push_back(std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(t),
                                 values.begin() + static_cast<std::ptrdiff_t>(t + each),
                                 0.0) /
                 decimation);
  }
  return of;
}

// A wave of slowly changing height through the valve and a process with a lag of 15
// samples (or an integrator), noise a tenth of y.
TrackedLoop loop(SlipMotion motion, const LoopOptions& options = {}) {
  std::mt19937 random(options.seed);
  std::normal_distribution<double> normal;
  StickSlipValve<double> valve(truth(motion), options.stem);
  TrackedLoop l;
  l.decimation = options.decimation;
  l.pole = options.integrating ? 1 : std::exp(-1.0 / (15 * l.decimation));
  l.middle = 0.5;
  l.gain = options.integrating ? 0.05 / l.decimation : 1;
  double lagged = 0.5;
  std::vector<double> y;
  const std::size_t count = options.samples * static_cast<std::size_t>(l.decimation);
  for (std::size_t t = 0; t < count; ++t) {
    const double time = static_cast<double>(t) / l.decimation;
    const double height = 0.45 + 0.04 * std::sin(time / 170);
    l.u.push_back(0.5 + height * std::sin(2 * M_PI * time / kCyclePeriod) +
                  0.003 * normal(random));
    const double x = t < options.delay ? 0.5 : l.x[t - options.delay];
    lagged = options.integrating ? lagged + l.gain * (x - 0.5)
                                 : l.pole * lagged + (1 - l.pole) * x;
    l.x.push_back(valve.step(l.u.back()));
    y.push_back(lagged);
  }
  l.x = means(l.x, l.decimation);
  l.y = means(y, l.decimation);
  scale_output(l, options.noise, random);
  return l;
}

class Tracked {
 public:
  Tracked(const TrackedLoop& l, ValveFriction<double> from,
          const ProcessPoles<double>& poles, std::size_t active = 170, double stem = 0.5)
      : x_(l.y.size()), scratch_(l.y.size()) {
    window_.u = l.u;
    window_.y = l.y;
    window_.decimation = l.decimation;
    window_.period = kCyclePeriod;
    window_.swing = 0.9;
    ValveModel<double> model;
    model.known = true;
    model.friction = from;
    model.poles = poles;
    StickSlipValve<double> valve(from, stem);
    std::vector<double> x;
    for (const double u : l.u) {
      x.push_back(valve.step(u));
    }
    x = means(x, l.decimation);
    x_ = x;
    const std::span<const double> fitted(x_.data(), active);
    model.fit =
        test::fit(regression_, fitted, window_.y.first(active), poles, 1, 10, true);
    tracker_->start(window_, model, active, x_, scratch_, *stems_, regression_);
  }
  const SlipTracker<double>::State& rounds(int count, double spread) {
    for (int round = 0; round < count; ++round) {
      tracker_->begin_round(spread);
      while (!tracker_->step()) {
        ++steps;
        dearest = std::max(dearest, tracker_->cost());
        cheapest = std::min(cheapest, tracker_->cost());
      }
      spread = std::max(0.75 * spread, 0.01);
    }
    return tracker_->best();
  }
  void resume(bool depart = false) {
    const auto state = tracker_->best();
    tracker_->resume(state, depart);
  }
  // Of a stem with these positions.
  double measured(const std::vector<double>& positions,
                  const ProcessPoles<double>& poles) {
    x_ = positions;
    tracker_->measure(poles);
    while (!tracker_->step()) {
    }
    return tracker_->misfit();
  }
  [[nodiscard]] const SlipTracker<double>::State& best() const {
    return tracker_->best();
  }
  int steps = 0;
  int dearest = 0;
  int cheapest = 1000;

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
  const TrackedLoop l = loop(GetParam());
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
    const TrackedLoop l =
        loop(GetParam(), {.integrating = true, .noise = 0.03, .seed = seed});
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
  const TrackedLoop l = loop(GetParam());
  Tracked tracked(l, truth(GetParam()), {pole_of(15.0), 0}, 170);
  tracked.rounds(1, 0.2);
  // No more samples than there are, then the fits, each a path and its regression.
  const int samples = static_cast<int>(l.y.size());
  const int pieces_of_fit = 2 + samples / 128;
  EXPECT_LE(tracked.steps, samples + (SlipTracker<double>::kFits + 1) * pieces_of_fit);
}

TEST_P(SlipTrackerOn, IsRepeatable) {
  const TrackedLoop l = loop(GetParam());
  Tracked one(l, truth(GetParam()), {pole_of(15.0), 0}, 170);
  Tracked other(l, truth(GetParam()), {pole_of(15.0), 0}, 170);
  EXPECT_EQ(one.rounds(2, 0.2).misfit, other.rounds(2, 0.2).misfit);
}

// Every rate, process and dead time; x is the stem of the loop.
std::vector<LoopOptions> quiet_loops(double noise) {
  std::vector<LoopOptions> all;
  for (const int decimation : {1, 3}) {
    for (const bool integrating : {false, true}) {
      for (const std::size_t delay : {1, 7}) {
        all.push_back({.integrating = integrating,
                       .noise = noise,
                       .delay = delay * static_cast<std::size_t>(decimation),
                       .decimation = decimation,
                       .stem = delay > 1 ? 0.6 : 0.5});
      }
    }
  }
  return all;
}

ProcessPoles<double> poles_of(const TrackedLoop& l) {
  return {std::pow(l.pole, l.decimation), 0};
}

// Of the slow pole's input, as a State has it, for a sample of y.
double gain_of(const TrackedLoop& l) {
  return l.pole < 1 ? l.gain * (1 - poles_of(l).slow) : l.gain * l.decimation;
}

// From the fit of a free simulation to the recursion of the tracker, which has no drift.
TEST_P(SlipTrackerOn, StartsWithTheGainAndTheOriginOfTheProcess) {
  for (const double noise : {0.0, 0.1}) {
    for (const LoopOptions& options : quiet_loops(noise)) {
      const TrackedLoop l = loop(GetParam(), options);
      const Tracked tracked(l, truth(GetParam()), poles_of(l), 400, options.stem);
      const auto& start = tracked.best();
      EXPECT_FALSE(start.followed);
      EXPECT_NEAR(start.gain, gain_of(l), (0.02 + noise) * gain_of(l));
      EXPECT_NEAR(start.origin, l.middle, 0.003 + 0.1 * noise);
      // Half as much again as the fit left, and no less than a twentieth.
      EXPECT_NEAR(start.misfit, noise > 0 ? 1.5 * noise : 0.05, 0.12 * noise);
    }
  }
}

// No valve at all: what it starts from is no worse than half of y.
TEST_P(SlipTrackerOn, StartsWithAMisfitOfHalfAtMost) {
  const TrackedLoop l = loop(GetParam(), {.noise = 2});
  EXPECT_EQ(Tracked(l, truth(GetParam()), poles_of(l)).best().misfit, 0.5);
}

// Where nothing disturbs y the stem is found to a few thousandths, with where it started,
// the dead time and what the observer needs to go on.
TEST_P(SlipTrackerOn, FindsAllOfAQuietLoop) {
  for (const LoopOptions& options : quiet_loops(0)) {
    if (options.integrating && options.decimation > 1) {
      continue;  // what it sums of means tells less of a band that resticks
    }
    const TrackedLoop l = loop(GetParam(), options);
    Tracked tracked(l, off_by(0.02, GetParam()), poles_of(l), 170, options.stem);
    const auto& found = tracked.rounds(4, 0.1);
    EXPECT_TRUE(found.followed);
    EXPECT_LT(found.misfit, 0.012);
    EXPECT_NEAR(found.gain, gain_of(l), 0.03 * gain_of(l));
    EXPECT_NEAR(found.origin, l.middle, 0.005);
    EXPECT_NEAR(found.start, options.stem, 0.03);
    EXPECT_NEAR(found.model.poles.slow, poles_of(l).slow, 0.002);
    expect_bands_near(found.model.friction, 0.012);
    EXPECT_NEAR(found.model.friction.deadband, truth(GetParam()).deadband, 0.012);
    // The mean of several samples is later than the last of them.
    const ProcessFit<double>& fit = found.model.fit;
    const double late = static_cast<double>(options.delay) / l.decimation;
    EXPECT_NEAR(fit.delay + fit.gain_b / (fit.gain_a + fit.gain_b), late, 0.6);
  }
}

// The observer's misfit of the true stem is the noise; that of a valve that follows u is
// another.
TEST_P(SlipTrackerOn, MeasuresTheMisfitOfAStem) {
  for (const double noise : {0.0, 0.1}) {
    for (const LoopOptions& options : quiet_loops(noise)) {
      const TrackedLoop l = loop(GetParam(), options);
      Tracked tracked(l, truth(GetParam()), poles_of(l), 170, options.stem);
      EXPECT_NEAR(tracked.measured(l.x, poles_of(l)), noise, noise > 0 ? 0.006 : 0.012);
      EXPECT_GT(tracked.measured(means(l.u, l.decimation), poles_of(l)),
                noise > 0 ? noise : 0.025);
      // And then of a round, as that is.
      EXPECT_NEAR(tracked.rounds(3, 0.1).misfit, noise, noise > 0 ? 0.006 : 0.012);
    }
  }
}

// One sample of y in forty is wrong by three standard deviations.
TEST_P(SlipTrackerOn, IsNotLedAstrayBySpikes) {
  TrackedLoop l = loop(GetParam(), {.noise = 0.03});
  for (std::size_t t = 5; t < l.y.size(); t += 40) {
    l.y[t] += t % 80 == 5 ? 3 : -3;
  }
  Tracked tracked(l, off_by(0.03, GetParam()), poles_of(l));
  expect_bands_near(tracked.rounds(6, 0.1).model.friction, 0.04);
}

// Many short windows, so that a bundle that finds its valve less often is seen.
TEST_P(SlipTrackerOn, FindsMostValvesOfShortWindows) {
  constexpr int kDraws = 30;
  int near = 0;
  for (unsigned seed = 1; seed <= kDraws; ++seed) {
    const TrackedLoop l = loop(GetParam(), {.noise = 0.05, .seed = seed, .samples = 480});
    Tracked tracked(l, off_by(0.07, GetParam()), poles_of(l), 120);
    near += farthest_band(tracked.rounds(4, 0.2).model.friction) < 0.02 ? 1 : 0;
  }
  EXPECT_GE(near, kDraws / 2);
}

// A round is taken if it is better than the best before; the first one after a departure
// in any case.
TEST_P(SlipTrackerOn, LeavesItsBestRoundOnlyToDepart) {
  const TrackedLoop l = loop(GetParam());
  Tracked tracked(l, truth(GetParam()), poles_of(l));
  double best = tracked.rounds(4, 0.1).misfit;
  for (const bool depart : {false, true}) {
    tracked.resume(depart);
    double before = best;
    double least = best;
    for (int round = 0; round < 4; ++round) {
      const double now = tracked.rounds(1, 0.5).misfit;
      if (round == 0 && depart) {
        EXPECT_NE(now, before);
      } else {
        EXPECT_LE(now, before);
      }
      before = now;
      least = std::min(least, now);
    }
    best = before;
  }
}

TEST_P(SlipTrackerOn, TakesNoPieceThatIsTooLong) {
  for (const LoopOptions& options : quiet_loops(0.1)) {
    const TrackedLoop l = loop(GetParam(), options);
    Tracked tracked(l, truth(GetParam()), poles_of(l), 170, options.stem);
    tracked.rounds(2, 0.3);
    EXPECT_LE(tracked.dearest, 100);
    EXPECT_GE(tracked.cheapest, 1);
  }
}

// 128 slips are remembered: what comes later has no part in the round, and a round that
// has seen less than half is none.
TEST(SlipTracker, TellsOfAsManySlipsAsItRemembers) {
  constexpr auto kMotion = SlipMotion::kResticks;
  for (const bool half : {true, false}) {
    const TrackedLoop l =
        loop(kMotion,
             {.noise = 0.03, .samples = static_cast<std::size_t>(half ? 3'600 : 7'000)});
    Tracked tracked(l, truth(kMotion), poles_of(l));
    const auto& found = tracked.rounds(1, 0.05);
    EXPECT_EQ(found.followed, half);
    expect_bands_near(found.model.friction, 0.02);
    if (half) {
      EXPECT_NEAR(found.misfit, 0.03, 0.01);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, SlipTrackerOn,
                         testing::Values(SlipMotion::kStops, SlipMotion::kResticks));

// Bands far below the noise of u: every stem slips at almost every sample, and no round
// can be kept.
TEST(SlipTracker, KeepsItsStartWhereTheSlipsDoNotFit) {
  const TrackedLoop l = loop(SlipMotion::kResticks);
  const ValveFriction<double> tiny{0, 1e-5, 1e-5, SlipMotion::kResticks};
  Tracked tracked(l, tiny, {pole_of(15.0), 0}, 170);
  const auto& best = tracked.rounds(2, 0.2);
  EXPECT_EQ(best.model.friction.slip_ascending, 1e-5);
}

}  // namespace
}  // namespace ident
