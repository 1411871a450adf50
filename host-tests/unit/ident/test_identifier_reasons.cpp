// Every reason and every cause that the identifier gives, from a loop that deserves it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"
#include "support/ident/expect_verdict.hpp"
#include "support/ident/problems.hpp"
#include "support/ident/scene.hpp"

namespace ident {
namespace {

using test::expect_verdict;

Identification<double> identify(const test::Scened& s) {
  const auto identifier = std::make_unique<Identifier<double, kStandardWindow>>();
  return identifier->run(s.u, s.y, s.sp);
}

constexpr ValveFriction<double> kReasonSticks{1, 4, 4, SlipMotion::kSlides};

void expect(const test::Scene& scene, Reason reason, Cause cause) {
  const test::Scened s = test::play(scene);
  const auto result = identify(s);
  expect_verdict(result, reason);
  EXPECT_EQ(name(result.cause), name(cause));
}

TEST(IdentifierReasons, WhichStrokeSticks) {
  expect({.friction = kReasonSticks}, Reason::kSticksBothStrokes, Cause::kValve);
  expect({.friction = {0, 4, 0, SlipMotion::kSlides}, .setpoint = test::steps(2, 150)},
         Reason::kSticksAscending, Cause::kValve);
  expect({.friction = {0, 0, 4, SlipMotion::kSlides}, .setpoint = test::steps(2, 150)},
         Reason::kSticksDescending, Cause::kValve);
}

TEST(IdentifierReasons, ThatAValveHasPlay) {
  const ValveFriction<double> play{2, 0, 0, SlipMotion::kSlides};
  expect({.friction = play, .noise = 0.005, .setpoint = test::steps(3, 100)},
         Reason::kDeadbandOnly, Cause::kValve);
  // A self-regulating loop that hunts across its band.
  expect({.friction = play,
          .time_constant = 3,
          .proportional = 0.2,
          .integral = 0.1,
          .setpoint = test::wave(1, 150)},
         Reason::kSlipUnresolved, Cause::kValve);
  expect({.friction = {0.2, 0, 0, SlipMotion::kSlides},
          .noise = 0.01,
          .setpoint = test::steps(4, 150)},
         Reason::kBandDoesNotMatter, Cause::kSetpoint);
}

TEST(IdentifierReasons, WhatElseMovesTheLoop) {
  // Too few turns for a firm no.
  expect({.noise = 0.005, .setpoint = test::steps(1, 150)}, Reason::kSetpointMoves,
         Cause::kSetpoint);
  expect({.noise = 0.1, .load = test::wave(2, 100)}, Reason::kLinearExplains,
         Cause::kExternalPeriodic);
  expect({.proportional = 24, .integral = 0.3, .low = -1, .high = 2, .noise = 0.002},
         Reason::kLinearExplains, Cause::kTightTuning);
}

// A load so large that u rests at its limits looks like an unstable loop there.
TEST(IdentifierReasons, NothingOfTheTuningWhereALoadDrivesUToItsLimits) {
  for (const double period : {60, 100}) {
    const test::Scened s = test::play(
        {.low = -2.14, .high = 3.76, .noise = 0.1, .load = test::wave(2, period)});
    const auto result = identify(s);
    EXPECT_GT(result.loop.limit_share, 0.03);
    EXPECT_NE(name(result.cause), name(Cause::kTightTuning)) << period;
  }
}

TEST(IdentifierReasons, ThatNoValveExplainsTheLoop) {
  expect({.proportional = 0, .noise = 0.4, .load = test::wave(0.6, 40)},
         Reason::kNotTheValve, Cause::kUnknown);
  expect({.proportional = 0, .noise = 0.5, .samples = 100}, Reason::kModelTooPoor,
         Cause::kUnknown);
}

TEST(IdentifierReasons, ThatUTurnsWithTheNoise) {
  expect({.noise = 0.5, .samples = 100}, Reason::kTurnsTooFast, Cause::kUnknown);
}

TEST(IdentifierReasons, WhyTheDataCannotTell) {
  expect({.friction = kReasonSticks, .noise = 0.4, .samples = 600},
         Reason::kEvidenceTooWeak, Cause::kUnknown);
  expect({.friction = kReasonSticks, .noise = 0.3, .samples = 220}, Reason::kTooFewCycles,
         Cause::kUnknown);
  expect({.friction = kReasonSticks, .high = 0.4}, Reason::kAtLimit, Cause::kUnknown);
  expect({.friction = {1.4, 0, 0, SlipMotion::kSlides},
          .noise = 0.05,
          .setpoint = test::steps(3, 100)},
         Reason::kSetpointMoves, Cause::kSetpoint);
}

// A setpoint that moves u does not move the stem's evidence: with a little more noise
// than above, neither play that is found running free is confirmed, nor its absence
// shown.
TEST(IdentifierReasons, ThatTheSetpointMovesTheLoop) {
  expect({.setpoint = test::steps(1, 150)}, Reason::kSetpointMoves, Cause::kSetpoint);
}

// Whether the setpoint is told or not.
TEST(IdentifierReasons, ThatPlayShowsAtTheStepsOfTheSetpoint) {
  const ValveFriction<double> play{2, 0, 0, SlipMotion::kSlides};
  test::Scened s = test::play({.friction = play, .setpoint = test::steps(3, 100)});
  expect_verdict(identify(s), Reason::kDeadbandOnly);
  s.sp.clear();
  expect_verdict(identify(s), Reason::kDeadbandOnly);
}

TEST(IdentifierReasons, ThatABandWouldNotShow) {
  expect({.proportional = 0, .noise = 1, .load = test::wave(0.6, 40), .samples = 500},
         Reason::kBandWouldNotShow, Cause::kUnknown);
}

TEST(IdentifierReasons, ThatABandIsLostInTheResolution) {
  test::Scened s = test::play({.friction = kReasonSticks});
  for (double& u : s.u) {
    u = 6 * std::round(u / 6);
  }
  expect_verdict(identify(s), Reason::kBandBelowResolution);
}

// u moved by hand, far up and down and a little back each time; behind a lag of 20
// samples, with noise.
test::Scened step_test(double play) {
  const double levels[] = {50, 60, 57, 45, 48, 58, 55, 40, 43, 58};
  test::Scened s;
  test::Random random(5);
  std::normal_distribution<double> noise(0, 0.2);
  double stem = levels[0];
  double y = stem;
  for (const double level : levels) {
    stem = std::clamp(stem, level - play / 2, level + play / 2);
    for (int k = 0; k < 100; ++k) {
      y += (stem - y) / 20;
      s.u.push_back(level);
      s.y.push_back(y + noise(random));
    }
  }
  return s;
}

TEST(IdentifierReasons, WhichBandAStepTestExcludes) {
  const auto healthy = identify(step_test(0));
  expect_verdict(healthy, Reason::kLinearExplains);
  EXPECT_GT(healthy.detectable_band, 0.2);
  EXPECT_LT(healthy.detectable_band, 6);
  EXPECT_NE(verdict_of(identify(step_test(6)).reason), Verdict::kNoStiction);
}

TEST(IdentifierReasons, ALoopThatDoesNotOscillateIsNotToldSo) {
  expect({.noise = 0.5}, Reason::kModelTooPoor, Cause::kUnknown);
}

}  // namespace
}  // namespace ident
