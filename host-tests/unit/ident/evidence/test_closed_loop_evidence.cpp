// What the ladder and a single stem say of simulated loops whose valve is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "ident/evidence/closed_loop_evidence.hpp"
#include "ident/window_survey.hpp"
#include "support/ident/loop.hpp"
#include "support/ident/pi_loop.hpp"
#include "support/ident/scene.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

struct Signals {
  Signal u, y;
};

// Hunts across stick bands of 5; u swings by about 6.
constexpr ValveFriction<double> kSticks{1, 4, 4, SlipMotion::kSlides};

Signals sticking(std::uint64_t seed, std::size_t samples = 1800, double noise = 0.02) {
  test::Random random(seed);
  test::LoopSettings settings;
  settings.friction = kSticks;
  settings.noise = noise;
  const test::Window window = test::simulate_loop(settings, samples, random);
  return {window.u, window.y};
}

// A valve that follows u, in a loop moved by a load that wanders.
Signals healthy(std::uint64_t seed, std::size_t samples = 1800, double noise = 0.05) {
  const test::LoopRecord record = test::run({.noise = noise}, samples, seed);
  return {record.u, record.y};
}

// u moved by hand, up and down by 0.2 … 1 in 5 … 24 samples; a lag of 10 samples behind a
// dead time.
Signals by_hand(std::uint64_t seed, std::size_t samples, double noise,
                const ValveFriction<double>& friction = {}, std::size_t dead_time = 0) {
  test::Random random(seed);
  const test::Window window = test::random_window(random, samples);
  StickSlipValve<double> valve(friction, 0.5);
  Signals out{window.u, {}};
  double state = 0.5;
  for (std::size_t t = 0; t < samples; ++t) {
    out.y.push_back(state + noise * test::normal(random));
    state =
        0.9 * state + 0.1 * (t < dead_time ? 0.5 : valve.step(window.u[t - dead_time]));
  }
  return out;
}

// The last `samples` of a recording.
Signals newest(const Signals& signals, std::size_t samples) {
  const auto from = static_cast<std::ptrdiff_t>(signals.u.size() - samples);
  return {{signals.u.begin() + from, signals.u.end()},
          {signals.y.begin() + from, signals.y.end()}};
}

/// A window as the identifier gives it to the evidence, the evidence, and its ladder.
template <class Real>
class Asked {
 public:
  explicit Asked(const Signals& signals)
      : u_(test::as<Real>(signals.u)),
        y_(test::as<Real>(signals.y)),
        scratch_(u_.size()) {
    const auto survey = std::make_unique<WindowSurvey<Real>>();
    std::vector<unsigned char> ascending(u_.size());
    Identification<Real> result;
    survey->start({u_, y_, {}, ascending, scratch_, 1});
    while (!survey->step(result)) {
    }
    EXPECT_EQ(survey->refusal(), Reason::kNone);
    of_u = survey->of_u();
    movement = survey->movement();
  }

  [[nodiscard]] EvidenceWindow<Real> window() {
    EvidenceWindow<Real> out;
    out.u = u_;
    out.y = y_;
    out.scratch = scratch_;
    out.sums = &sums_;
    out.period = movement.period;
    out.swing = movement.swing;
    out.span = movement.swing;
    return out;
  }

  LadderFinding<Real> climb(int budget = 1000) {
    evidence.start(window(), ladder);
    while (!evidence.step(budget)) {
    }
    return evidence.finding();
  }

  /// Nats of the stem of a valve, friction in the unit of the recorded u, that has seen
  /// what was recorded before.
  Real nats_of(const ValveFriction<double>& friction, const Signal& before,
               int parameters) {
    const auto scaled = [&](double value) {
      return static_cast<Real>(value) / of_u.factor;
    };
    const auto place = [&](double value) {
      return (static_cast<Real>(value) - of_u.offset) / of_u.factor;
    };
    StickSlipValve<Real> valve(
        {scaled(friction.deadband), scaled(friction.slip_ascending),
         scaled(friction.slip_descending), friction.motion},
        place(*std::max_element(before.begin(), before.end())));
    for (const double u : before) {
      valve.step(place(u));
    }
    evidence.start_with(window(), valve, parameters);
    while (!evidence.step(1000)) {
    }
    return evidence.nats();
  }

  /// After climb.
  Real nats_beside_u() {
    EXPECT_TRUE(evidence.start_beside_best(window()));
    while (!evidence.step(1000)) {
    }
    return evidence.nats_beside_u();
  }

  /// From the unit of the evidence to that of the recorded u.
  [[nodiscard]] double in_u(Real band) const {
    return static_cast<double>(band * of_u.factor);
  }

  ClosedLoopEvidence<Real> evidence;
  Ladder<Real> ladder{};
  SignalScale<Real> of_u;
  Movement<Real> movement;

 private:
  std::vector<Real> u_, y_, scratch_;
  OneStepSums<Real> sums_;
};

// The rungs beside the best one tell how well the band is known; a rung whose stem starts
// in the middle of a swing that its band all but fills moves late or never, so that the
// best band is a little too small.
TEST(ClosedLoopEvidence, FindsTheBandOfAValveThatSticks) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
    Asked<double> asked(sticking(seed));
    const LadderFinding<double> found = asked.climb();
    EXPECT_GT(found.nats, 100) << seed;
    EXPECT_NEAR(asked.in_u(found.band), 5, 1) << seed;
    EXPECT_LT(found.low, found.band);
    EXPECT_GT(found.high, found.band);
    EXPECT_GT(found.strokes, 10);
  }
}

TEST(ClosedLoopEvidence, HasNoneAgainstAValveThatFollows) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u}) {
    EXPECT_LT(Asked<double>(healthy(seed)).climb().nats, 10) << seed;
  }
}

TEST(ClosedLoopEvidence, HasMoreForTheTrueStemThanForAnyRung) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Signals all = sticking(seed, 2800);
    Asked<double> asked(newest(all, 1800));
    const double ladder = asked.climb().nats;
    const Signal before(all.u.begin(), all.u.begin() + 1000);
    EXPECT_GT(asked.nats_of(kSticks, before, 2), ladder) << seed;
    EXPECT_GT(asked.evidence.strokes(), 10);
  }
}

TEST(ClosedLoopEvidence, HasLessForAnotherStem) {
  const Signals all = sticking(1, 2800);
  const Signal before(all.u.begin(), all.u.begin() + 1000);
  Asked<double> asked(newest(all, 1800));
  const double truly = asked.nats_of(kSticks, before, 2);
  // Of half the band; fine lags make up for a part of what it lacks.
  EXPECT_LT(asked.nats_of({0.5, 2, 2, SlipMotion::kSlides}, before, 2), 0.7 * truly);
  EXPECT_LT(asked.nats_of({1, 1, 1, SlipMotion::kSlides}, before, 2), truly / 2);
  // A stem that follows u has nothing more to say, and one that rests less.
  EXPECT_NEAR(asked.nats_of({}, before, 0), 0, 1e-6);
  EXPECT_LT(asked.nats_of({0, 1000, 1000, SlipMotion::kSlides}, before, 0), 0);
  EXPECT_LE(asked.evidence.strokes(), 1);  // where it stood first
}

// Where the valve follows, no stem tells anything beside u.
TEST(ClosedLoopEvidence, PutsUBesideTheStem) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    Asked<double> asked(sticking(seed));
    asked.climb();
    EXPECT_GT(asked.nats_beside_u(), 100) << seed;
    Asked<double> healthy_asked(healthy(seed));
    healthy_asked.climb();
    EXPECT_LT(healthy_asked.nats_beside_u(), 20) << seed;
  }
}

// Half the logarithm of the predicted samples for each parameter.
TEST(ClosedLoopEvidence, ChargesForTheParameters) {
  const Signals signals = sticking(2);
  Asked<double> asked(signals);
  const double free = asked.nats_of(kSticks, signals.u, 0);
  const auto predicted = static_cast<double>(asked.evidence.predicted());
  EXPECT_NEAR(free - asked.nats_of(kSticks, signals.u, 3), 1.5 * std::log(predicted),
              1e-9);
  const LadderFinding<double> found = asked.climb();
  const auto best = std::max_element(asked.ladder.begin(), asked.ladder.end());
  const auto index = static_cast<int>(best - asked.ladder.begin());
  ValveFriction<double> rung =
      rung_valve<double>(index % kRungs, index / kRungs, asked.movement.swing);
  rung.deadband = asked.in_u(rung.deadband);
  rung.slip_ascending = asked.in_u(rung.slip_ascending);
  rung.slip_descending = asked.in_u(rung.slip_descending);
  const double by_fine_lags = asked.nats_of(rung, {signals.u[0]}, 0);
  EXPECT_NEAR(found.nats, std::min(*best, by_fine_lags) - std::log(predicted), 1e-6);
}

// Bands below 4 % of the swing have 0, those too wide to be tried what a stem at rest
// has.
TEST(ClosedLoopEvidence, FillsInTheWholeLadder) {
  Asked<double> asked(sticking(3));
  asked.climb();
  const double swing = asked.movement.swing;
  const auto nats = [&](int rung, int slip) {
    return asked.ladder[static_cast<std::size_t>(slip * kRungs + rung)];
  };
  int tried = 0;
  for (int rung = 0; rung < kRungs; ++rung) {
    for (int slip = 0; slip < kSlips; ++slip) {
      if (rung_band<double>(rung, swing) < 0.04 * swing) {
        EXPECT_EQ(nats(rung, slip), 0);
      } else {
        EXPECT_NE(nats(rung, slip), 0);
        ++tried;
      }
    }
  }
  EXPECT_GT(tried, 40);
}

TEST(ClosedLoopEvidence, KnowsNoUnits) {
  for (const Signals& signals : {sticking(4), healthy(4)}) {
    Asked<double> plain(signals);
    const LadderFinding<double> expected = plain.climb();
    for (const double factor : {1e-3, 40.0}) {
      Signals other = signals;
      for (std::size_t t = 0; t < other.u.size(); ++t) {
        other.u[t] = 7 + factor * signals.u[t];
        other.y[t] = factor * signals.y[t] - 3;
      }
      Asked<double> asked(other);
      const LadderFinding<double> found = asked.climb();
      EXPECT_NEAR(found.nats, expected.nats, 0.01);
      EXPECT_NEAR(found.band, expected.band, 1e-9);
      EXPECT_NEAR(found.detectable_band, expected.detectable_band, 1e-9);
    }
  }
}

Signals every_second(const Signals& signals) {
  Signals out;
  for (std::size_t t = 0; t < signals.u.size(); t += 2) {
    out.u.push_back(signals.u[t]);
    out.y.push_back(signals.y[t]);
  }
  return out;
}

TEST(ClosedLoopEvidence, BearsEverySecondSample) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Asked<double> asked(every_second(sticking(seed, 3600)));
    const LadderFinding<double> found = asked.climb();
    EXPECT_GT(found.nats, 40) << seed;
    EXPECT_NEAR(asked.in_u(found.band), 5, 1) << seed;
    EXPECT_LT(Asked<double>(every_second(healthy(seed, 3600))).climb().nats, 10) << seed;
  }
}

TEST(ClosedLoopEvidence, ThinsOutALongWindow) {
  Asked<double> asked(sticking(6, 8000));
  asked.movement.period *= 2;  // of some hundred samples few are more than are needed
  const LadderFinding<double> found = asked.climb();
  const auto thinning =
      static_cast<std::size_t>(asked.movement.period / kEvidencePerCycle);
  EXPECT_GT(thinning, 1u);
  EXPECT_LE(found.predicted, 8000 / thinning);
  EXPECT_GE(found.predicted, 8000 / thinning - 60);
  EXPECT_GT(found.nats, 100);
  EXPECT_NEAR(asked.in_u(found.band), 5, 1);
}

// 60 predicted samples, behind the 7 … 9 that are the past of the first.
TEST(ClosedLoopEvidence, SaysNothingOfATooShortWindow) {
  for (const std::size_t samples : {60u, 67u}) {
    const Signals signals = by_hand(1, samples, 0.02);
    Asked<double> asked(signals);
    const LadderFinding<double> found = asked.climb();
    EXPECT_EQ(found.predicted, 0u);
    EXPECT_EQ(asked.evidence.predicted(), 0u);
    EXPECT_EQ(found.nats, 0);
    EXPECT_EQ(found.band, 0);
    EXPECT_EQ(found.detectable_band, 0);
    EXPECT_EQ(asked.ladder, Ladder<double>{});
    EXPECT_EQ(asked.nats_of(kSticks, signals.u, 0), 0);
  }
  Asked<double> enough(by_hand(1, 69, 0.02));
  EXPECT_EQ(enough.climb().predicted, 60u);
}

TEST(ClosedLoopEvidence, ForgetsTheWindowBefore) {
  const Signals signals = sticking(5, 700);
  Asked<double> anew(signals);
  const LadderFinding<double> expected = anew.climb();
  Asked<double> again(sticking(2, 900));
  (void)again.climb();
  (void)again.nats_beside_u();
  Asked<double> next(signals);
  next.evidence = again.evidence;
  const LadderFinding<double> found = next.climb();
  EXPECT_EQ(next.ladder, anew.ladder);
  EXPECT_EQ(found.nats, expected.nats);
  EXPECT_EQ(found.strokes, expected.strokes);
  EXPECT_EQ(found.detectable_band, expected.detectable_band);
  EXPECT_EQ(found.hoped_band, expected.hoped_band);
}

TEST(ClosedLoopEvidence, IsTheSameWhateverTheBudget) {
  const Signals signals = sticking(5);
  Asked<float> whole(signals);
  const LadderFinding<float> expected = whole.climb(100000);
  for (const int budget : {1, 3, 100}) {
    Asked<float> asked(signals);
    const LadderFinding<float> found = asked.climb(budget);
    EXPECT_EQ(found.nats, expected.nats);
    EXPECT_EQ(found.band, expected.band);
    EXPECT_EQ(found.low, expected.low);
    EXPECT_EQ(found.high, expected.high);
    EXPECT_EQ(found.strokes, expected.strokes);
    EXPECT_EQ(found.detectable_band, expected.detectable_band);
    EXPECT_EQ(asked.ladder, whole.ladder);
  }
}

TEST(ClosedLoopEvidence, NeedsNoDoublePrecision) {
  for (const Signals& signals : {sticking(7), healthy(7)}) {
    Asked<double> fine(signals);
    Asked<float> coarse(signals);
    const LadderFinding<double> expected = fine.climb();
    const LadderFinding<float> found = coarse.climb();
    EXPECT_NEAR(static_cast<double>(found.nats), expected.nats,
                1 + 0.02 * std::abs(expected.nats));
    EXPECT_NEAR(static_cast<double>(found.detectable_band), expected.detectable_band,
                0.16 * expected.detectable_band);
  }
}

/// Longer than the lags of u that may be a record of y (E25).
constexpr std::size_t kDeadTime = 10;

/// Detectable band in the unit of u, mean of four recordings.
double detectable_band(std::size_t samples, double noise) {
  double sum = 0;
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    Asked<double> asked(by_hand(seed, samples, noise, {}, kDeadTime));
    const double band = asked.in_u(asked.climb().detectable_band);
    EXPECT_GT(band, 0) << samples << " samples, noise " << noise;
    sum += band / 4;
  }
  return sum;
}

TEST(ClosedLoopEvidence, ShowsANarrowerBandInALongerWindow) {
  const double first = detectable_band(700, 0.05);
  double before = first;
  for (const std::size_t samples : {1400u, 2800u, 5600u}) {
    const double longer = detectable_band(samples, 0.05);
    EXPECT_LT(longer, before) << samples;
    before = longer;
  }
  EXPECT_LT(before, 0.6 * first);
}

TEST(ClosedLoopEvidence, ShowsOnlyAWiderBandUnderNoise) {
  double before = detectable_band(2000, 0.02);
  for (const double noise : {0.04, 0.08}) {
    const double noisier = detectable_band(2000, noise);
    EXPECT_GT(noisier, 1.2 * before) << noise;
    before = noisier;
  }
}

// What would not show whatever its width has no detectable band.
TEST(ClosedLoopEvidence, ShowsNoBandWhereUTellsNothingOfY) {
  test::Random random(1);
  Signals signals = healthy(1);
  for (double& y : signals.y) {
    y = test::normal(random);
  }
  EXPECT_EQ(Asked<double>(signals).climb().detectable_band, 0);
}

// Where u does not answer y, a valve with such a band is found.
TEST(ClosedLoopEvidence, FindsABandTwiceAsWideAsTheDetectableOne) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    Asked<double> asked(by_hand(seed, 2000, 0.05, {}, kDeadTime));
    const double band = 2 * asked.in_u(asked.climb().detectable_band);
    ASSERT_GT(band, 0);
    const ValveFriction<double> friction{0.4 * band, 0.6 * band, 0.6 * band,
                                         SlipMotion::kSlides};
    Asked<double> sticks(by_hand(seed, 2000, 0.05, friction, kDeadTime));
    const LadderFinding<double> found = sticks.climb();
    EXPECT_GT(found.nats, 40) << seed << ", band " << band;
    EXPECT_NEAR(sticks.in_u(found.band), band, 0.2 * band);
  }
}

// A loop that sticks under a load that wanders.
Signals sticking_under_load(std::uint64_t seed) {
  test::Random random(seed);
  auto load = std::make_shared<Signal>();
  double value = 0;
  for (int t = 0; t < 4000; ++t) {
    value = 0.995 * value + 0.05 * test::normal(random);
    load->push_back(value);
  }
  const test::Scened scene =
      test::play({.friction = kSticks,
                  .load = [load](int t) { return (*load)[static_cast<std::size_t>(t)]; },
                  .samples = 2000});
  return {scene.u, scene.y};
}

TEST(ClosedLoopEvidence, SeesAValveThroughALoadWhereEverySampleIsPredicted) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Asked<double> asked(sticking_under_load(seed));
    asked.movement.period = 60;
    const LadderFinding<double> found = asked.climb();
    EXPECT_GT(found.nats, 40) << seed;
    EXPECT_NEAR(asked.in_u(found.band), 5, 1) << seed;
  }
}

// A loop under a load that wanders, whose controller reads y four times between two
// samples of the recording.
Signals read_faster(std::uint64_t seed, const std::function<double(double)>& valve) {
  test::PiLoop loop;
  loop.pole = 0.985;
  loop.proportional = 2;
  loop.integral = 0.02;
  loop.load = 0.1;
  loop.valve = valve;
  const test::LoopRecord record = test::run(loop, 4 * 2500, seed);
  Signals out;
  for (std::size_t t = 0; t < record.u.size(); t += 4) {
    out.u.push_back(record.u[t]);
    out.y.push_back(record.y[t]);
  }
  return out;
}

// u is a record of y between the samples there: no stem alone foretells as much, and the
// weights of u are not the valve's.
TEST(ClosedLoopEvidence, SeesAStemBesideAUThatKnowsYBetweenTheSamples) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Asked<double> asked(read_faster(seed, test::sticking(1.5)));
    const LadderFinding<double> found = asked.climb();
    EXPECT_LT(found.nats, 0) << seed;
    EXPECT_EQ(found.detectable_band, 0) << seed;
    EXPECT_LT(asked.in_u(found.hoped_band), 0.5) << seed;
    EXPECT_GT(asked.nats_beside_u(), 20) << seed;
    Asked<double> follows(read_faster(seed, [](double u) { return u; }));
    follows.climb();
    EXPECT_LT(follows.nats_beside_u(), 20) << seed;
  }
}

}  // namespace
}  // namespace ident
