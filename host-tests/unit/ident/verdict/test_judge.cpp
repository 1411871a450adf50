// The judge on what the free simulation says, in windows too short for closed-loop
// evidence: every branch and every threshold from both sides, with evidence made by hand.
#include <gtest/gtest.h>

#include "ident/verdict/judge.hpp"
#include "support/ident/judge_evidence.hpp"

namespace ident {
namespace {

using test::Change;
using test::expect;
using test::judge;
using test::sticking;

Reason judged(Change change, bool oscillates = true) {
  Evidence<double> e = sticking();
  change(e);
  return judge(e, oscillates);
}

TEST(Judge, NamesTheStrokesThatStick) {
  expect(judged([](auto&) {}), Reason::kSticksBothStrokes);
  expect(judged([](auto& e) { e.form = ValveForm::kMixed; }), Reason::kSticksBothStrokes);
  expect(judged([](auto& e) { e.form = ValveForm::kAscending; }),
         Reason::kSticksAscending);
  expect(judged([](auto& e) { e.form = ValveForm::kDescending; }),
         Reason::kSticksDescending);
}

TEST(Judge, NeedsNoOscillationForAValveThatSlips) {
  expect(judged([](auto&) {}, false), Reason::kSticksBothStrokes);
}

TEST(Judge, SaysNothingOfAValveThatNeverTurnsOrTurnsOnce) {
  for (const bool oscillates : {false, true}) {
    expect(judged([](auto& e) { e.reversals = 0; }, oscillates), Reason::kOneStroke);
    expect(judged([](auto& e) { e.reversals = 1; }, oscillates), Reason::kTooFewCycles);
    expect(judged([](auto& e) { e.reversals = 2; }, oscillates),
           Reason::kSticksBothStrokes);
  }
}

// Whatever else the evidence says.
TEST(Judge, NeverFindsAFaultWithoutAReversal) {
  for (int bits = 0; bits < 256; ++bits) {
    Evidence<double> e = sticking();
    e.reversals = 0;
    e.form = static_cast<ValveForm>((bits & 7) % kValveForms);
    e.error_ratio = bits & 8 ? 100 : 1.2;
    e.score = bits & 16 ? 1000 : 5;
    e.band_over_swing = bits & 32 ? 1 : 0.1;
    e.slip_over_band = bits & 64 ? 1 : 0;
    const Verdict verdict = verdict_of(judge(e, (bits & 128) != 0));
    EXPECT_EQ(name(verdict), name(Verdict::kUndecided));
  }
}

// A model that explains little of y says so only where no valve is found.
TEST(Judge, LooksElsewhereWhereNoValveExplainsY) {
  const auto poor = [](double fit) {
    Evidence<double> e = sticking();
    e.form = ValveForm::kLinear;
    e.fit_percent = fit;
    return e;
  };
  for (const double fit : {24.9, -300.0}) {
    expect(judge(poor(fit), true), Reason::kNotTheValve);
    expect(judge(poor(fit), false), Reason::kModelTooPoor);
  }
  expect(judge(poor(25), true), Reason::kLinearExplains);
  expect(judge(poor(25), false), Reason::kLinearExplains);
  // A weak suspicion is none either.
  Evidence<double> weak = sticking();
  weak.score = 5;
  weak.fit_percent = 24.9;
  expect(judge(weak, true), Reason::kNotTheValve);
  weak.fit_percent = 25;
  expect(judge(weak, true), Reason::kEvidenceTooWeak);
}

TEST(Judge, ALinearValveIsEnough) {
  expect(judged([](auto& e) { e.form = ValveForm::kLinear; }), Reason::kLinearExplains);
  expect(judged([](auto& e) { e.score = 2.99; }), Reason::kLinearExplains);
  expect(judged([](auto& e) { e.score = 3; }), Reason::kEvidenceTooWeak);
  expect(judged([](auto& e) { e.error_ratio = 1.09; }), Reason::kLinearExplains);
  expect(judged([](auto& e) { e.error_ratio = 1.11; }), Reason::kEvidenceTooWeak);
}

// No closed-loop evidence says how small a band would have shown.
TEST(Judge, ALinearValveThatLeavesMuchOpenIsNotEnough) {
  expect(judged([](auto& e) {
           e.form = ValveForm::kLinear;
           e.fit_linear_percent = 79.9;
         }),
         Reason::kBandWouldNotShow);
}

TEST(Judge, ALargeGainInAFewTurnsHasToBeSteady) {
  const auto few = [](double consistency, int reversals) {
    Evidence<double> e = sticking();
    e.error_ratio = 20;
    e.consistency = consistency;
    e.reversals = reversals;
    return judge(e, false);
  };
  expect(few(2.4, 9), Reason::kSticksBothStrokes);
  expect(few(2.3, 9), Reason::kTooFewCycles);
  expect(few(1, 10), Reason::kSticksBothStrokes);
}

// Found by nothing in four turns of u, which somebody made.
Evidence<double> following_by_hand() {
  Evidence<double> e = sticking();
  e.form = ValveForm::kLinear;
  e.error_ratio = 1;
  e.score = e.consistency = e.band_over_swing = e.slip_over_band = 0;
  e.cycles_better = 0;
  e.reversals = 4;
  e.by_hand = true;
  e.ladder.predicted = 500;
  e.ladder.nats = -5;
  e.ladder.detectable_band = 0.2;
  return e;
}

TEST(Judge, AFewStepsByHandSayWhatWouldHaveShown) {
  if (!kStemSearch) GTEST_SKIP() << "no stems are searched in this size";
  Evidence<double> e = following_by_hand();
  expect(judge(e, false), Reason::kLinearExplains);
  e.ladder.detectable_band = 0.4;
  expect(judge(e, false), Reason::kBandWouldNotShow);
  e.ladder.detectable_band = 0;
  expect(judge(e, false), Reason::kBandWouldNotShow);
  e = following_by_hand();
  e.reversals = 1;
  expect(judge(e, false), Reason::kTooFewCycles);
  e = following_by_hand();
  e.by_hand = false;
  expect(judge(e, false), Reason::kTooFewCycles);
}

// What swings on a drift of u does not come back to where a band is hoped to show.
TEST(Judge, OnADriftTheDetectableBandDecides) {
  if (!kStemSearch) GTEST_SKIP() << "no stems are searched in this size";
  Evidence<double> e = following_by_hand();
  e.by_hand = false;
  e.reversals = 20;
  e.ladder.hoped_band = 0.2;
  e.ladder.detectable_band = 0;
  expect(judge(e, false), Reason::kLinearExplains);
  e.drifts = true;
  expect(judge(e, false), Reason::kBandWouldNotShow);
  e.ladder.detectable_band = 0.3;
  expect(judge(e, false), Reason::kLinearExplains);
}

TEST(Judge, OfFewSamplesUnderALoadTheDetectableBandDecides) {
  if (!kStemSearch) GTEST_SKIP() << "no stems are searched in this size";
  Evidence<double> e = following_by_hand();
  e.by_hand = false;
  e.reversals = 20;
  e.ladder.hoped_band = 0.2;
  e.ladder.detectable_band = 0;
  e.fit_linear_percent = 79;
  e.ladder.predicted = 300;
  expect(judge(e, false), Reason::kLinearExplains);
  e.ladder.predicted = 299;
  expect(judge(e, false), Reason::kBandWouldNotShow);
  e.fit_linear_percent = 80;
  expect(judge(e, false), Reason::kLinearExplains);
  e.fit_linear_percent = 79;
  e.ladder.detectable_band = 0.3;
  expect(judge(e, false), Reason::kLinearExplains);
}

TEST(Judge, AMovedSetpointSaysWhatWouldHaveShown) {
  if (!kStemSearch) GTEST_SKIP() << "no stems are searched in this size";
  LoopEvidence<double> loop;
  loop.setpoint_share = 1;
  const auto judged_so = [&loop](Evidence<double> e, auto change) {
    e.by_hand = false;
    change(e);
    return judge(e, loop);
  };
  const Evidence<double> few = following_by_hand();
  expect(judged_so(few, [](auto&) {}), Reason::kLinearExplains);
  expect(judged_so(few, [](auto& e) { e.ladder.detectable_band = 0.36; }),
         Reason::kSetpointMoves);
  expect(judged_so(few, [](auto& e) { e.ladder.nats = 0.1; }), Reason::kSetpointMoves);
  expect(judged_so(few, [](auto& e) { e.form = ValveForm::kSymmetric; }),
         Reason::kSetpointMoves);
}

TEST(Judge, TheEndsOfAStepTestByHandAreNoLimits) {
  Evidence<double> e = sticking();
  LoopEvidence<double> loop;
  loop.limit_share = 0.6;
  expect(judge(e, loop), Reason::kAtLimit);
  e.by_hand = true;
  expect(judge(e, loop), Reason::kSticksBothStrokes);
  loop.limit_share = 0.81;
  expect(judge(e, loop), Reason::kAtLimit);
}

// Of four stretches none can be so steady; but a curve foretells nothing.
TEST(Judge, AFewTurnsAreEnoughForAStemThatForetellsThem) {
  const auto few = [](double nats) {
    Evidence<double> e = sticking();
    e.error_ratio = 20;
    e.consistency = 1.5;
    e.reversals = 4;
    e.stem_weighed = true;
    e.stem_nats = nats;
    e.ladder.nats = 5;
    e.ladder.predicted = 1000;
    return e;
  };
  expect(judge(few(20.1), false), Reason::kSticksBothStrokes);
  expect(judge(few(19.9), false), Reason::kTooFewCycles);
  Evidence<double> one = few(100);
  one.reversals = 1;
  one.stem_strokes = 4;
  expect(judge(one, false), Reason::kSticksBothStrokes);
  one.stem_strokes = 3;
  expect(judge(one, false), Reason::kTooFewCycles);
  Evidence<double> curve = few(100);
  curve.error_ratio = 2.5;
  expect(judge(curve, false), Reason::kTooFewCycles);
}

TEST(Judge, AFewTurnsAreEnoughWhereNoCurveDoesWhatTheStemDoes) {
  if (!kStemSearch) GTEST_SKIP() << "no stems are searched in this size";
  const auto few = [](auto change) {
    Evidence<double> e = sticking();
    e.error_ratio = 1.8;
    e.consistency = 1;
    e.score = 11;
    e.reversals = 2;
    e.stem_weighed = true;
    e.stem_nats = -5;
    e.ladder.predicted = 1000;
    e.curved = {true, 11, 0, e.band_over_swing * 0.6, e.band_over_swing * 1.9};
    change(e);
    return judge(e, false);
  };
  expect(few([](auto&) {}), Reason::kSticksBothStrokes);
  expect(few([](auto& e) { e.reversals = 9; }), Reason::kSticksBothStrokes);
  expect(few([](auto& e) { e.curved.nats = 10; }), Reason::kTooFewCycles);
  expect(few([](auto& e) { e.curved.narrower_band = e.band_over_swing / 2; }),
         Reason::kTooFewCycles);
  expect(few([](auto& e) { e.curved.wider_band = e.band_over_swing * 2; }),
         Reason::kTooFewCycles);
  expect(few([](auto& e) { e.error_ratio = 1.75; }), Reason::kTooFewCycles);
  expect(few([](auto& e) { e.consistency = 0; }), Reason::kTooFewCycles);
  expect(few([](auto& e) { e.score = 10; }), Reason::kTooFewCycles);
  expect(few([](auto& e) { e.reversals = 1; }), Reason::kTooFewCycles);
}

TEST(Judge, ABandBelowFivePercentOfTheSwingDoesNotMatter) {
  expect(judged([](auto& e) { e.band_over_swing = 0.049; }), Reason::kBandDoesNotMatter);
  expect(judged([](auto& e) { e.band_over_swing = 0.05; }), Reason::kSticksBothStrokes);
}

TEST(Judge, NeedsTenNats) {
  expect(judged([](auto& e) { e.score = 9.99; }), Reason::kEvidenceTooWeak);
  expect(judged([](auto& e) { e.score = 10.01; }), Reason::kSticksBothStrokes);
  // However large the error of the linear valve.
  expect(judged([](auto& e) {
           e.score = 9.99;
           e.error_ratio = 50;
         }),
         Reason::kEvidenceTooWeak);
}

TEST(Judge, AGainMustBeSteadyUnlessItIsOverwhelming) {
  expect(judged([](auto& e) { e.error_ratio = 1.75; }), Reason::kEvidenceTooWeak);
  expect(judged([](auto& e) { e.error_ratio = 1.76; }), Reason::kSticksBothStrokes);
  expect(judged([](auto& e) { e.consistency = 2.3; }), Reason::kEvidenceTooWeak);
  expect(judged([](auto& e) { e.consistency = 2.31; }), Reason::kSticksBothStrokes);
  const auto unsteady = [](double ratio) {
    Evidence<double> e = sticking();
    e.cycles_better = 0;
    e.consistency = 0.1;
    e.error_ratio = ratio;
    return judge(e, true);
  };
  expect(unsteady(2.5), Reason::kEvidenceTooWeak);
  expect(unsteady(2.51), Reason::kSticksBothStrokes);
  // Even an overwhelming gain must not come with a loss in the mean of the cycles.
  Evidence<double> losing = sticking();
  losing.consistency = 0;
  losing.error_ratio = 100;
  expect(judge(losing, true), Reason::kEvidenceTooWeak);
}

TEST(Judge, ASlipBelowEightPercentOfTheBandIsPlay) {
  expect(judged([](auto& e) { e.slip_over_band = 0.079; }), Reason::kDeadbandOnly);
  expect(judged([](auto& e) { e.slip_over_band = 0.08; }), Reason::kSticksBothStrokes);
}

TEST(Judge, PlayCannotKeepASelfRegulatingLoopHunting) {
  const auto hunting = [](double time_constant, double band, bool oscillates) {
    Evidence<double> e = sticking();
    e.form = ValveForm::kBacklash;
    e.slip_over_band = 0;
    e.time_constant = time_constant;
    e.band_over_swing = band;
    return judge(e, oscillates);
  };
  expect(hunting(0.49, 0.451, true), Reason::kSlipUnresolved);
  expect(hunting(0.50, 0.451, true), Reason::kDeadbandOnly);
  expect(hunting(0.49, 0.45, true), Reason::kDeadbandOnly);
  expect(hunting(0.49, 0.451, false), Reason::kDeadbandOnly);
}

TEST(Judge, ReadsFloatAlike) {
  Evidence<float> e;
  e.form = ValveForm::kDescending;
  e.error_ratio = 3;
  e.score = 20;
  e.band_over_swing = 0.3f;
  e.slip_over_band = 1;
  e.consistency = 3;
  e.fit_percent = 60;
  e.reversals = 2;
  EXPECT_EQ(judge(e, false), Reason::kSticksDescending);
  e.reversals = 0;
  EXPECT_EQ(judge(e, false), Reason::kOneStroke);
}

Reason with_loop(Change change, void (*change_loop)(LoopEvidence<double>&)) {
  Evidence<double> e = sticking();
  change(e);
  LoopEvidence<double> loop;
  loop.oscillates = true;
  change_loop(loop);
  return judge(e, loop);
}

const Change kNoChange = [](auto&) {};
const Change kWeak = [](auto& e) { e.score = 5; };
const Change kLinear = [](auto& e) { e.form = ValveForm::kLinear; };

TEST(Judge, ABandOfAtMostTwoStepsOfUIsNotClaimed) {
  expect(with_loop(kNoChange, [](auto& loop) { loop.u_step = 0.26; }),
         Reason::kBandBelowResolution);
  expect(with_loop(kNoChange, [](auto& loop) { loop.u_step = 0.24; }),
         Reason::kSticksBothStrokes);
  expect(with_loop([](auto& e) { e.slip_over_band = 0; },
                   [](auto& loop) { loop.u_step = 0.26; }),
         Reason::kBandBelowResolution);
}

// A controller hunts between them whatever the valve does.
TEST(Judge, NoFaultIsClaimedWhereYTakesThreeLevels) {
  expect(with_loop(kNoChange, [](auto& loop) { loop.y_step = 0.31; }),
         Reason::kBandBelowResolution);
  expect(with_loop(kNoChange, [](auto& loop) { loop.y_step = 0.29; }),
         Reason::kSticksBothStrokes);
}

TEST(Judge, FewerThanTwoStepsASwingAreNoProofOfAGoodValve) {
  expect(with_loop(kLinear, [](auto& loop) { loop.y_step = 0.51; }),
         Reason::kBandBelowResolution);
  expect(with_loop(kLinear, [](auto& loop) { loop.u_step = 0.51; }),
         Reason::kBandBelowResolution);
  expect(with_loop(kLinear, [](auto& loop) { loop.u_step = loop.y_step = 0.49; }),
         Reason::kLinearExplains);
}

TEST(Judge, TellsWhyTheDataCannotTell) {
  expect(with_loop(kWeak, [](auto& loop) { loop.y_step = 0.21; }),
         Reason::kBandBelowResolution);
  expect(with_loop(kWeak, [](auto& loop) { loop.y_step = 0.19; }),
         Reason::kEvidenceTooWeak);
  expect(with_loop(kWeak, [](auto& loop) { loop.limit_share = 0.26; }), Reason::kAtLimit);
  expect(with_loop(kWeak, [](auto& loop) { loop.limit_share = 0.24; }),
         Reason::kEvidenceTooWeak);
  expect(with_loop(kWeak, [](auto& loop) { loop.setpoint_share = 0.71; }),
         Reason::kSetpointMoves);
  expect(with_loop(kWeak, [](auto& loop) { loop.setpoint_share = 0.69; }),
         Reason::kEvidenceTooWeak);
  expect(judged([](auto& e) {
           e.score = 5;
           e.reversals = 9;
         }),
         Reason::kTooFewCycles);
  expect(judged([](auto& e) {
           e.score = 5;
           e.reversals = 10;
         }),
         Reason::kEvidenceTooWeak);
}

// A u that is flat between its limits looks like a stem that sticks.
TEST(Judge, ClaimsNoFaultWhereURestsAtALimit) {
  const auto limited = [](LoopEvidence<double>& loop) { loop.limit_share = 0.26; };
  expect(with_loop(kNoChange, limited), Reason::kAtLimit);
  expect(with_loop([](auto& e) { e.slip_over_band = 0; }, limited), Reason::kAtLimit);
  expect(with_loop([](auto& e) { e.fit_percent = 5; }, limited), Reason::kAtLimit);
  const auto shows = [](auto& e) {
    kLinear(e);
    e.ladder.detectable_band = 0.1;
  };
  expect(with_loop(shows, limited), Reason::kLinearExplains);
  expect(with_loop(kLinear, limited), Reason::kAtLimit);
  expect(with_loop(kNoChange, [](auto& loop) { loop.limit_share = 0.24; }),
         Reason::kSticksBothStrokes);
}

// What decides is not taken back by a setpoint or few cycles.
TEST(Judge, KeepsWhatTheEvidenceDecides) {
  const auto harsh = [](LoopEvidence<double>& loop) {
    loop.limit_share = 0.7;
    loop.setpoint_share = 0.9;
    loop.u_step = loop.y_step = 0.24;
  };
  const Change few = [](auto& e) { e.reversals = 3; };
  expect(with_loop(few, harsh), Reason::kSticksBothStrokes);
  expect(with_loop(kLinear, harsh), Reason::kLinearExplains);
  expect(with_loop([](auto& e) { e.reversals = 0; }, harsh), Reason::kOneStroke);
}

// Nothing measured yet: undecided.
TEST(Judge, TakesNoEvidenceForNoAnswer) {
  expect(judge(Evidence<double>{}, false), Reason::kOneStroke);
  expect(judge(Evidence<double>{}, true), Reason::kOneStroke);
}

// Bands of 4 with the given lower ends; upper ends of 5, or as told.
Reason strokes(Reason reason, double ascending_low, double descending_low,
               double descending_high = 5) {
  const PerStroke<double> band{
      {true, 4, ascending_low, 5},
      {true, descending_high - 1, descending_low, descending_high}};
  return strokes_that_stick(reason, band);
}

TEST(StrokesThatStick, AreThoseWhoseIntervalsDoNotReachNothing) {
  for (const Reason fitted : {Reason::kSticksBothStrokes, Reason::kSticksAscending,
                              Reason::kSticksDescending}) {
    EXPECT_EQ(strokes(fitted, 3, 3), Reason::kSticksBothStrokes);
    EXPECT_EQ(strokes(fitted, 0, 0), Reason::kStrokesUnresolved);
  }
}

TEST(StrokesThatStick, IsOneAloneOnlyWhereTheOthersIntervalLiesBelowItsOwn) {
  EXPECT_EQ(strokes(Reason::kSticksBothStrokes, 3, 0, 5), Reason::kStrokesUnresolved);
  EXPECT_EQ(strokes(Reason::kSticksAscending, 3, 0, 1), Reason::kSticksAscending);
  EXPECT_EQ(strokes(Reason::kSticksAscending, 3, 0, 2.9), Reason::kSticksAscending);
  EXPECT_EQ(strokes(Reason::kSticksAscending, 3, 0, 3), Reason::kStrokesUnresolved);
  EXPECT_EQ(strokes(Reason::kSticksAscending, 3, 0, 5), Reason::kStrokesUnresolved);
}

TEST(StrokesThatStick, AreNotAskedOfPlay) {
  EXPECT_EQ(strokes(Reason::kDeadbandOnly, 3, 0), Reason::kDeadbandOnly);
}

TEST(Judge, TakesNoBandWiderThanTheSwingForOne) {
  Evidence<double> e = sticking();
  EXPECT_EQ(verdict_of(judge(e, true)), Verdict::kStiction);
  e.band_over_swing = 1.1;
  EXPECT_NE(verdict_of(judge(e, true)), Verdict::kStiction);
}

TEST(Judge, LetsWindowsSpeakTogetherOnlyOfABandThatUSwingsBeyond) {
  Evidence<double> e = sticking();
  e.ladder.band = 1.04;
  EXPECT_TRUE(may_stick_together(e));
  e.ladder.band = 1.06;
  EXPECT_FALSE(may_stick_together(e));
  e.ladder.band = 0.5;
  e.fit_percent = 5;
  EXPECT_FALSE(may_stick_together(e));
}

}  // namespace
}  // namespace ident
