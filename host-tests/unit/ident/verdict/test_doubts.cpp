// What makes a judgement doubtful, with evidence made by hand.
#include <gtest/gtest.h>

#include "ident/verdict/doubts.hpp"
#include "support/ident/judge_evidence.hpp"

namespace ident {
namespace {

using test::sticking;

TEST(Doubts, LeavesNoStictionOpenWhereStoredPointsAreFarApart) {
  const Reason none = Reason::kLinearExplains;
  const Evidence<double> e;
  RecordHealth<double> health;
  EXPECT_EQ(verdict_of(doubt_compressed(none, e, health)), Verdict::kNoStiction);
  health.compressed = true;
  health.points_apart = 2;
  EXPECT_EQ(verdict_of(doubt_compressed(none, e, health)), Verdict::kNoStiction);
  health.points_apart = 4;
  EXPECT_EQ(verdict_of(doubt_compressed(none, e, health)), Verdict::kUndecided);
  EXPECT_EQ(doubt_compressed(none, e, health), Reason::kCompressed);
}

TEST(Doubts, LeavesAllOpenWhereAHistorianHeldYForLong) {
  const Evidence<double> e = sticking();
  RecordHealth<double> health;
  for (const Reason found :
       {Reason::kSticksBothStrokes, Reason::kDeadbandOnly, Reason::kLinearExplains}) {
    health.held_apart = 6;
    EXPECT_EQ(doubt_compressed(found, e, health), found);
    health.held_apart = 6.1;
    EXPECT_EQ(verdict_of(doubt_compressed(found, e, health)), Verdict::kUndecided);
    EXPECT_EQ(doubt_compressed(found, e, health), Reason::kCompressed);
  }
  const Reason open = Reason::kTooFewCycles;
  EXPECT_EQ(doubt_compressed(open, e, health), Reason::kTooFewCycles);
}

TEST(Doubts, AsksOfLinesBetweenStoredPointsThatTheValveConvincesRunningFree) {
  const Reason sticks = Reason::kSticksBothStrokes;
  RecordHealth<double> health;
  health.compressed = true;
  health.points_apart = 2;
  Evidence<double> e = sticking();
  e.stem_strokes = 8;
  e.reversals = 6;
  EXPECT_EQ(verdict_of(doubt_compressed(sticks, e, health)), Verdict::kStiction);
  e.reversals = 5;
  EXPECT_EQ(doubt_compressed(sticks, e, health), Reason::kCompressed);
  e.reversals = 6;
  e.stem_strokes = 7;
  EXPECT_EQ(doubt_compressed(sticks, e, health), Reason::kCompressed);
  e.stem_strokes = 8;
  e.error_ratio = 1.51;
  EXPECT_EQ(verdict_of(doubt_compressed(sticks, e, health)), Verdict::kStiction);
  e.error_ratio = 1.49;
  EXPECT_EQ(doubt_compressed(sticks, e, health), Reason::kCompressed);
  // Or that much agrees with it, lines or not.
  e.stem_weighed = true;
  e.stem_nats = 46;
  EXPECT_EQ(doubt_compressed(sticks, e, health), Reason::kCompressed);
  e.stem_nats = 46.1;
  EXPECT_EQ(verdict_of(doubt_compressed(sticks, e, health)), Verdict::kStiction);
  e.form = ValveForm::kLinear;
  EXPECT_EQ(verdict_of(doubt_compressed(sticks, e, health)), Verdict::kUndecided);
  health.compressed = false;
  EXPECT_EQ(verdict_of(doubt_compressed(sticks, e, health)), Verdict::kStiction);
}

TEST(Doubts, AsksOfAStemBetweenStoredPointsWhatOneAloneHasToHave) {
  RecordHealth<double> health;
  health.compressed = true;
  health.points_apart = 2;
  Evidence<double> e = sticking();
  e.form = ValveForm::kLinear;
  e.ladder.nats = 1;
  e.searched = {true, 60, 20, {{true, 0.5, 0.4, 0.6}, {true, 0.2, 0, 0.3}}};
  const auto verdict = [&] {
    return verdict_of(doubt_compressed(Reason::kSticksUnderLoad, e, health));
  };
  EXPECT_EQ(verdict(), Verdict::kStiction);
  e.cycle.nats = 15;
  EXPECT_EQ(verdict(), Verdict::kUndecided);
  health.compressed = false;
  EXPECT_EQ(verdict(), Verdict::kStiction);
}

TEST(Doubts, LeaveOpenWhatAReadingThatIsCutOffLooksLike) {
  RecordHealth<double> health;
  health.cut_off = 0.02;
  Evidence<double> e = sticking();
  e.error_ratio = 5;
  e.fit_percent = 95;
  const auto left = [&](Reason found) { return doubt_cut_off(found, e, health); };
  for (const Reason looks_alike :
       {Reason::kSticksBothStrokes, Reason::kDeadbandOnly, Reason::kSticksUnderLoad,
        Reason::kEvidenceTooWeak, Reason::kStemUnconfirmed, Reason::kLoadRepeats,
        Reason::kStemBounded}) {
    EXPECT_EQ(left(looks_alike), Reason::kReadingCutOff);
  }
  for (const Reason else_ : {Reason::kLinearExplains, Reason::kTooFewCycles,
                             Reason::kSetpointMoves, Reason::kModelTooPoor}) {
    EXPECT_EQ(left(else_), else_);
  }
  // A valve that leaves as good as nothing of y needs no cut to explain it.
  e.error_ratio = 5.1;
  EXPECT_EQ(left(Reason::kSticksBothStrokes), Reason::kSticksBothStrokes);
  EXPECT_EQ(left(Reason::kLoadRepeats), Reason::kReadingCutOff);
  e.fit_percent = 88;
  EXPECT_EQ(left(Reason::kSticksBothStrokes), Reason::kReadingCutOff);
  health.cut_off = 0;
  EXPECT_EQ(left(Reason::kSticksBothStrokes), Reason::kSticksBothStrokes);
}

// Of a loop under load, with so many nats of its stem and of the cycle before.
Reason repeated(double stem_nats, double cycle_nats, double error_ratio = 2,
                Reason found = Reason::kSticksBothStrokes) {
  Evidence<double> e = sticking();
  e.error_ratio = error_ratio;
  e.stem_weighed = true;
  e.stem_nats = stem_nats;
  e.ladder.nats = 3;
  e.cycle.nats = cycle_nats;
  return doubt_repeating(found, e);
}

TEST(Doubts, LeaveAFaultOpenThatALoadWithAClockForetellsNearlyAsWell) {
  for (const Reason fault : {Reason::kSticksBothStrokes, Reason::kDeadbandOnly}) {
    EXPECT_EQ(verdict_of(repeated(49, 30, 2, fault)), Verdict::kUndecided);
    EXPECT_EQ(repeated(49, 30, 2, fault), Reason::kLoadRepeats);
    EXPECT_EQ(repeated(51, 30, 2, fault), fault);
    EXPECT_EQ(verdict_of(repeated(299, 200, 2, fault)), Verdict::kUndecided);
    EXPECT_EQ(repeated(301, 200, 2, fault), fault);
  }
}

TEST(Doubts, TakeNoClockForOneThatSaysLittle) {
  EXPECT_EQ(verdict_of(repeated(10, 20)), Verdict::kStiction);
  EXPECT_EQ(verdict_of(repeated(10, 20.1)), Verdict::kUndecided);
}

TEST(Doubts, LeaveAFaultOpenWhereAStemTellsFarMoreBesideUUnderAClock) {
  const auto judged = [](double cycle_nats, double beside_u) {
    Evidence<double> e = sticking();
    e.ladder.nats = 200;
    e.cycle.nats = cycle_nats;
    e.beside_u.nats = beside_u;
    e.error_ratio = 20;
    e.fit_percent = 98.7;
    return doubt_repeating(Reason::kSticksBothStrokes, e);
  };
  EXPECT_EQ(judged(61, 261), Reason::kLoadRepeats);
  EXPECT_EQ(verdict_of(judged(61, 259)), Verdict::kStiction);
  EXPECT_EQ(verdict_of(judged(59, 900)), Verdict::kStiction);
}

TEST(Doubts, LeaveAFaultOpenWhoseBandsReachNothing) {
  const auto judged = [](Reason found, double low, double nats) {
    Evidence<double> e = sticking();
    e.ladder.nats = nats;
    return doubt_bands(found, e, PerStroke<double>{{true, 5, 0, 6}, {true, 4, low, 6}});
  };
  for (const Reason fault : {Reason::kSticksBothStrokes, Reason::kDeadbandOnly}) {
    EXPECT_EQ(judged(fault, 0, 25), Reason::kEvidenceTooWeak);
    EXPECT_EQ(judged(fault, 1, 25), fault);
    // A stem speaks, too.
    EXPECT_EQ(judged(fault, 0, 25.1), fault);
  }
  if (kStemSearch) {
    Evidence<double> e = sticking();
    e.ladder.nats = 0;
    e.curved = {true, 26, 0, 0.5, 0.5};
    const PerStroke<double> reaching{{true, 5, 0, 6}, {true, 4, 0, 6}};
    EXPECT_EQ(doubt_bands(Reason::kDeadbandOnly, e, reaching), Reason::kDeadbandOnly);
    // Of another band, in a few turns, it is no evidence for this one.
    e.reversals = 9;
    e.curved.wider_band = 2 * e.band_over_swing;
    EXPECT_EQ(doubt_bands(Reason::kDeadbandOnly, e, reaching), Reason::kEvidenceTooWeak);
    e.ladder.nats = 26;
    e.ladder.band = 2 * e.band_over_swing;
    EXPECT_EQ(doubt_bands(Reason::kDeadbandOnly, e, reaching), Reason::kEvidenceTooWeak);
    e.reversals = 10;
    EXPECT_EQ(doubt_bands(Reason::kDeadbandOnly, e, reaching), Reason::kDeadbandOnly);
  }
  EXPECT_EQ(judged(Reason::kLinearExplains, 0, 25), Reason::kLinearExplains);
}

TEST(Doubts, AskWhetherACurveDoesWhatAStemWouldDo) {
  Evidence<double> e = sticking();
  e.form = ValveForm::kLinear;
  e.ladder = {};
  e.ladder.predicted = 1000;
  e.ladder.hoped_band = 0.2;
  e.fit_linear_percent = 60;
  e.curved = {true, -1, 11, 0.5, 0.5};
  LoopEvidence<double> loop;
  loop.oscillates = true;
  const RecordHealth<double> health;
  const auto left_of = [&](Reason found) {
    return explained_by_curve(found, e, loop, health);
  };
  for (const Reason open :
       {Reason::kEvidenceTooWeak, Reason::kStemUnconfirmed, Reason::kStemBounded}) {
    EXPECT_TRUE(may_be_curve(open));
    EXPECT_EQ(left_of(open), Reason::kCurveExplains);
  }
  for (const Reason other : {Reason::kSticksBothStrokes, Reason::kLoadRepeats}) {
    EXPECT_EQ(left_of(other), other);
  }
  const Reason open = Reason::kEvidenceTooWeak;
  const auto still_open = [&](auto change) {
    const Evidence<double> before = e;
    change(e);
    const bool still = left_of(open) == open;
    e = before;
    return still;
  };
  EXPECT_TRUE(still_open([](auto& c) { c.curved.nats = 1; })) << "a stem beside it";
  EXPECT_TRUE(still_open([](auto& c) { c.curved.curve_nats = 10; }));
  EXPECT_TRUE(still_open([](auto& c) { c.ladder.nats = 10; })) << "nearly as much";
  EXPECT_TRUE(still_open([](auto& c) { c.curved.weighed = false; }));
  EXPECT_TRUE(still_open([](auto& c) { c.ladder.hoped_band = 0.4; })) << "would hide";
  EXPECT_TRUE(still_open([](auto& c) { c.fit_linear_percent = 20; })) << "too poor";
}

TEST(Doubts, KnowWhereYBends) {
  Evidence<double> e;
  e.beside_u.nats = 21;
  EXPECT_TRUE(bends(e));
  e.beside_u.nats = 19;
  EXPECT_FALSE(bends(e));
}

TEST(Doubts, LeaveNoStictionOpenWhereAStemTellsMuchBesideU) {
  Evidence<double> e;
  e.fit_linear_percent = 50;
  e.beside_u.nats = 21;
  const Reason healthy = Reason::kLinearExplains;
  EXPECT_EQ(doubt_bent(healthy, e), Reason::kEvidenceTooWeak);
  EXPECT_EQ(doubt_bent(Reason::kBandDoesNotMatter, e), Reason::kBandDoesNotMatter);
  e.fit_linear_percent = 80;  // a load hides nothing: a curve
  EXPECT_EQ(verdict_of(doubt_bent(healthy, e)), Verdict::kNoStiction);
  e.fit_linear_percent = 50;
  e.beside_u.nats = 19;
  EXPECT_EQ(verdict_of(doubt_bent(healthy, e)), Verdict::kNoStiction);
}

// A load that rises and falls in ramps leaves a valve's picture, however well it fits.
TEST(Doubts, TakeNoFreeRunForAnAnswerToAClock) {
  EXPECT_EQ(verdict_of(repeated(501, 500, 30)), Verdict::kUndecided);
  EXPECT_EQ(verdict_of(repeated(751, 500, 30)), Verdict::kStiction);
}

TEST(Doubts, BelieveAValveInAnExactCycleThatLeavesNothingToALoad) {
  Evidence<double> e = sticking();
  e.error_ratio = 5.1;
  e.cycle.nats = 500;
  e.fit_percent = 98.1;
  const Reason found = Reason::kSticksBothStrokes;
  EXPECT_EQ(verdict_of(doubt_repeating(found, e)), Verdict::kStiction);
  e.fit_percent = 97.9;
  EXPECT_EQ(verdict_of(doubt_repeating(found, e)), Verdict::kUndecided);
}

TEST(Doubts, SayOfAnOpenWindowThatItsSamplesAreTooFarApart) {
  const Reason open = Reason::kBandWouldNotShow;
  EXPECT_EQ(doubt_coarse(open, 5.9), Reason::kTurnsTooFast);
  EXPECT_EQ(verdict_of(doubt_coarse(open, 5.9)), Verdict::kUndecided);
  EXPECT_EQ(doubt_coarse(open, 6.1), Reason::kBandWouldNotShow);
  const Reason limit = Reason::kAtLimit;
  EXPECT_EQ(doubt_coarse(limit, 4.0), Reason::kAtLimit);
  const Reason decided = Reason::kLinearExplains;
  EXPECT_EQ(verdict_of(doubt_coarse(decided, 4.0)), Verdict::kNoStiction);
}

TEST(Doubts, LeaveAFaultOpenThatTwoCurvesExplainAsWellInTwoTurns) {
  Evidence<double> e = sticking();
  e.fit_percent = 95;
  e.reversals = 2;
  e.ladder.predicted = 60;
  const Reason found = Reason::kSticksBothStrokes;
  EXPECT_EQ(doubt_few_turns(found, e, 95.0), Reason::kTooFewCycles);
  EXPECT_EQ(doubt_few_turns(found, e, 94.9), found);
  const Reason none = Reason::kLinearExplains;
  EXPECT_EQ(doubt_few_turns(none, e, 99.0), none);
  e.reversals = 3;
  e.ladder.predicted = 60;
  EXPECT_EQ(doubt_few_turns(found, e, 99.0), found);
  e.ladder.predicted = 0;
  EXPECT_EQ(doubt_few_turns(found, e, 99.0), Reason::kTooFewCycles)
      << "nothing is foretold in so short a window";
}

TEST(Doubts, LeaveAFaultOpenThatALagByDirectionExplainsAsWell) {
  Evidence<double> e = sticking();
  e.reversals = 5;
  e.ladder.predicted = 60;
  const Reason found = Reason::kSticksBothStrokes;
  e.uneven_ratio = 0.99;
  EXPECT_EQ(doubt_few_turns(found, e, 0.0), found);
  e.uneven_ratio = 1;
  EXPECT_EQ(doubt_few_turns(found, e, 0.0), Reason::kTooFewCycles);
  EXPECT_EQ(doubt_few_turns(Reason::kLinearExplains, e, 0.0), Reason::kLinearExplains);
}

TEST(Doubts, LeaveAFaultOpenWhereABoundedStemTellsMore) {
  Evidence<double> e = sticking();
  e.ladder.nats = 40;
  e.bounded.nats = 51;
  const Reason found = Reason::kSticksBothStrokes;
  EXPECT_EQ(doubt_bounded(found, e), Reason::kStemBounded);
  EXPECT_EQ(verdict_of(Reason::kStemBounded), Verdict::kUndecided);
  EXPECT_EQ(doubt_bounded(Reason::kEvidenceTooWeak, e), Reason::kStemBounded);
  EXPECT_EQ(doubt_bounded(Reason::kLinearExplains, e), Reason::kLinearExplains);
  EXPECT_EQ(doubt_bounded(Reason::kLoadRepeats, e), Reason::kStemBounded);
  e.cycle.nats = 32;  // the clock tells nearly as much
  EXPECT_EQ(doubt_bounded(Reason::kLoadRepeats, e), Reason::kLoadRepeats);
  e.bounded.nats = 47;
  EXPECT_EQ(doubt_bounded(found, e), found);
  e.ladder.nats = 400;
  e.bounded.nats = 479;
  EXPECT_EQ(doubt_bounded(found, e), found);
  e.bounded.nats = 481;
  EXPECT_EQ(doubt_bounded(found, e), Reason::kStemBounded);
}

TEST(Doubts, LeaveAFaultOpenWhereTheSetpointDoesItsWork) {
  if (!kStemSearch) GTEST_SKIP() << "no stems are searched in this size";
  Evidence<double> e = sticking();
  const Reason found = Reason::kSticksBothStrokes;
  EXPECT_EQ(doubt_setpoint(found, e), found) << "the setpoint rests";
  e.beside_setpoint = {true, 1};
  EXPECT_EQ(doubt_setpoint(found, e), found);
  e.beside_setpoint = {true, 0};
  EXPECT_EQ(doubt_setpoint(found, e), Reason::kSetpointMoves);
  EXPECT_EQ(doubt_setpoint(Reason::kLinearExplains, e), Reason::kLinearExplains);
}

TEST(Doubts, LeaveAFaultOpenThatACurveAndTheSetpointMake) {
  if (!kStemSearch) GTEST_SKIP() << "no stems are searched in this size";
  Evidence<double> e = sticking();
  const Reason found = Reason::kSticksBothStrokes;
  EXPECT_EQ(doubt_curved(found, e), found) << "not asked";
  e.curved = {true, 1, 0, 0.5, 0.5};
  EXPECT_EQ(doubt_curved(found, e), found);
  e.curved.nats = 0;
  EXPECT_EQ(doubt_curved(found, e), Reason::kEvidenceTooWeak);
  EXPECT_EQ(doubt_curved(Reason::kLinearExplains, e), Reason::kLinearExplains);
}

TEST(Doubts, HaveNothingToSayOfAHealthyValve) {
  EXPECT_EQ(repeated(0, 500, 1, Reason::kLinearExplains), Reason::kLinearExplains);
}

TEST(Doubts, CountTheBestStemThereIs) {
  EXPECT_TRUE(repeats(RememberedCycle<double>{30}, 49.0));
  Evidence<double> e = sticking();
  e.error_ratio = 2;
  e.cycle.nats = 30;
  e.ladder.nats = 60;
  const Reason found = Reason::kSticksUnderLoad;
  EXPECT_EQ(verdict_of(doubt_repeating(found, e)), Verdict::kStiction);
  e.ladder.nats = 40;
  EXPECT_EQ(verdict_of(doubt_repeating(found, e)), Verdict::kUndecided);
  e.searched.nats = 60;
  EXPECT_EQ(verdict_of(doubt_repeating(found, e)), Verdict::kStiction);
}

TEST(Doubts, LeaveAFaultOpenWhereStrokesKeepAForeignTime) {
  if constexpr (kStrokePace) {
    Evidence<double> e = sticking();
    e.error_ratio = 4;
    e.fit_percent = 95;
    e.pace.strokes = 30;
    e.pace.spread = 0.05;
    e.pace.together = 0.5;
    const Reason sticks = Reason::kSticksBothStrokes;
    EXPECT_EQ(doubt_repeating(sticks, e), Reason::kLoadRepeats);
    EXPECT_EQ(doubt_repeating(Reason::kLinearExplains, e), Reason::kLinearExplains);
    e.error_ratio = 5.1;
    EXPECT_EQ(doubt_repeating(sticks, e), sticks) << "it leaves little to a load";
    e.fit_percent = 80;
    EXPECT_EQ(doubt_repeating(sticks, e), Reason::kLoadRepeats);
    e.pace.together = -0.5;
    EXPECT_EQ(doubt_repeating(sticks, e), sticks);
  }
}

}  // namespace
}  // namespace ident
