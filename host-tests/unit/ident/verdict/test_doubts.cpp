// What makes a judgement doubtful, with evidence made by hand.
#include <gtest/gtest.h>

#include "ident/verdict/doubts.hpp"
#include "support/ident/judge_evidence.hpp"

namespace ident {
namespace {

using test::sticking;

TEST(Doubts, LeavesNoStictionOpenWhereStoredPointsAreFarApart) {
  const Judgement none{Verdict::kNoStiction, Reason::kLinearExplains};
  const Evidence<double> e;
  RecordHealth<double> health;
  EXPECT_EQ(doubt_compressed(none, e, health).verdict, Verdict::kNoStiction);
  health.compressed = true;
  health.points_apart = 2;
  EXPECT_EQ(doubt_compressed(none, e, health).verdict, Verdict::kNoStiction);
  health.points_apart = 4;
  EXPECT_EQ(doubt_compressed(none, e, health).verdict, Verdict::kUndecided);
  EXPECT_EQ(doubt_compressed(none, e, health).reason, Reason::kCompressed);
}

TEST(Doubts, LeavesAllOpenWhereAHistorianHeldYForLong) {
  const Evidence<double> e = sticking();
  RecordHealth<double> health;
  for (const Verdict verdict :
       {Verdict::kStiction, Verdict::kBacklash, Verdict::kNoStiction}) {
    const Judgement found{verdict, Reason::kSticksBothStrokes};
    health.held_apart = 6;
    EXPECT_EQ(doubt_compressed(found, e, health).verdict, verdict);
    health.held_apart = 6.1;
    EXPECT_EQ(doubt_compressed(found, e, health).verdict, Verdict::kUndecided);
    EXPECT_EQ(doubt_compressed(found, e, health).reason, Reason::kCompressed);
  }
  const Judgement open{Verdict::kUndecided, Reason::kTooFewCycles};
  EXPECT_EQ(doubt_compressed(open, e, health).reason, Reason::kTooFewCycles);
}

TEST(Doubts, AsksOfLinesBetweenStoredPointsThatTheValveConvincesRunningFree) {
  const Judgement sticks{Verdict::kStiction, Reason::kSticksBothStrokes};
  RecordHealth<double> health;
  health.compressed = true;
  health.points_apart = 2;
  Evidence<double> e = sticking();
  EXPECT_EQ(doubt_compressed(sticks, e, health).verdict, Verdict::kStiction);
  e.error_ratio = 1.51;
  EXPECT_EQ(doubt_compressed(sticks, e, health).verdict, Verdict::kStiction);
  e.error_ratio = 1.49;
  EXPECT_EQ(doubt_compressed(sticks, e, health).reason, Reason::kCompressed);
  // Or that much agrees with it, lines or not.
  e.stem_weighed = true;
  e.stem_nats = 46;
  EXPECT_EQ(doubt_compressed(sticks, e, health).reason, Reason::kCompressed);
  e.stem_nats = 46.1;
  EXPECT_EQ(doubt_compressed(sticks, e, health).verdict, Verdict::kStiction);
  e.form = ValveForm::kLinear;
  EXPECT_EQ(doubt_compressed(sticks, e, health).verdict, Verdict::kUndecided);
  health.compressed = false;
  EXPECT_EQ(doubt_compressed(sticks, e, health).verdict, Verdict::kStiction);
}

// Of a loop under load, with so many nats of its stem and of the cycle before.
Judgement repeated(double stem_nats, double cycle_nats, double error_ratio = 2,
                   Verdict verdict = Verdict::kStiction) {
  Evidence<double> e = sticking();
  e.error_ratio = error_ratio;
  e.stem_weighed = true;
  e.stem_nats = stem_nats;
  e.ladder.nats = 3;
  e.cycle.nats = cycle_nats;
  return doubt_repeating(Judgement{verdict, Reason::kSticksBothStrokes}, e);
}

TEST(Doubts, LeaveAFaultOpenThatALoadWithAClockForetellsNearlyAsWell) {
  for (const Verdict fault : {Verdict::kStiction, Verdict::kBacklash}) {
    EXPECT_EQ(repeated(49, 30, 2, fault).verdict, Verdict::kUndecided);
    EXPECT_EQ(repeated(49, 30, 2, fault).reason, Reason::kLoadRepeats);
    EXPECT_EQ(repeated(51, 30, 2, fault).verdict, fault);
    EXPECT_EQ(repeated(299, 200, 2, fault).verdict, Verdict::kUndecided);
    EXPECT_EQ(repeated(301, 200, 2, fault).verdict, fault);
  }
}

TEST(Doubts, TakeNoClockForOneThatSaysLittle) {
  EXPECT_EQ(repeated(10, 20).verdict, Verdict::kStiction);
  EXPECT_EQ(repeated(10, 20.1).verdict, Verdict::kUndecided);
}

// Of a stem found one sample ahead, beside which u tells so much.
Judgement beside(double told_by_u, double cycle_nats, double error_ratio = 1) {
  Evidence<double> e = sticking();
  e.form = error_ratio > 1 ? e.form : ValveForm::kLinear;
  e.error_ratio = error_ratio;
  e.ladder.nats = 200;
  e.cycle.nats = cycle_nats;
  e.beside.u = told_by_u;
  return doubt_repeating(Judgement{Verdict::kStiction, Reason::kSticksUnderLoad}, e);
}

TEST(Doubts, LeaveAFaultOpenWhereUTellsMuchBesideTheStem) {
  EXPECT_EQ(beside(0.25, 0).reason, Reason::kStemUnconfirmed);
  EXPECT_EQ(beside(0.2, 0).verdict, Verdict::kStiction);
  EXPECT_EQ(beside(0.25, 30).reason, Reason::kLoadRepeats);
  EXPECT_EQ(beside(0.2, 30).verdict, Verdict::kStiction);
  // What explains y running free as well needs a clock to be doubted.
  EXPECT_EQ(beside(0.25, 0, 3).verdict, Verdict::kStiction);
  EXPECT_EQ(beside(0.25, 30, 3).verdict, Verdict::kUndecided);
  EXPECT_EQ(beside(0.9, 30, 5.1).verdict, Verdict::kStiction);
}

TEST(Doubts, KnowWhichStemsMayBeALoadsAndWhereYBends) {
  EXPECT_TRUE(may_remember_load(0.3));
  EXPECT_FALSE(may_remember_load(0.4));
  EXPECT_TRUE(bends(Beside<double>{0, 21}));
  EXPECT_FALSE(bends(Beside<double>{0, 19}));
}

TEST(Doubts, LeaveNoStictionOpenWhereAStemTellsMuchBesideU) {
  Evidence<double> e;
  e.fit_linear_percent = 50;
  e.beside.stem = 21;
  const Judgement healthy{Verdict::kNoStiction, Reason::kLinearExplains};
  EXPECT_EQ(doubt_bent(healthy, e).reason, Reason::kEvidenceTooWeak);
  EXPECT_EQ(doubt_bent({Verdict::kNoStiction, Reason::kBandDoesNotMatter}, e).verdict,
            Verdict::kNoStiction);
  e.fit_linear_percent = 80;  // a load hides nothing: a curve
  EXPECT_EQ(doubt_bent(healthy, e).verdict, Verdict::kNoStiction);
  e.fit_linear_percent = 50;
  e.beside.stem = 19;
  EXPECT_EQ(doubt_bent(healthy, e).verdict, Verdict::kNoStiction);
}

TEST(Doubts, BelieveAValveThatExplainsAllOfAnExactCycle) {
  EXPECT_EQ(repeated(100, 500, 4.9).verdict, Verdict::kUndecided);
  EXPECT_EQ(repeated(100, 500, 5.1).verdict, Verdict::kStiction);
}

TEST(Doubts, SayOfAnOpenWindowThatItsSamplesAreTooFarApart) {
  const Judgement open{Verdict::kUndecided, Reason::kBandWouldNotShow};
  EXPECT_EQ(doubt_coarse(open, 5.9).reason, Reason::kTurnsTooFast);
  EXPECT_EQ(doubt_coarse(open, 5.9).verdict, Verdict::kUndecided);
  EXPECT_EQ(doubt_coarse(open, 6.1).reason, Reason::kBandWouldNotShow);
  const Judgement limit{Verdict::kUndecided, Reason::kAtLimit};
  EXPECT_EQ(doubt_coarse(limit, 4.0).reason, Reason::kAtLimit);
  const Judgement decided{Verdict::kNoStiction, Reason::kLinearExplains};
  EXPECT_EQ(doubt_coarse(decided, 4.0).verdict, Verdict::kNoStiction);
}

TEST(Doubts, HaveNothingToSayOfAHealthyValve) {
  EXPECT_EQ(repeated(0, 500, 1, Verdict::kNoStiction).verdict, Verdict::kNoStiction);
}

TEST(Doubts, CountTheBestStemThereIs) {
  EXPECT_TRUE(repeats(RememberedCycle<double>{30}, 49.0));
  Evidence<double> e = sticking();
  e.error_ratio = 2;
  e.cycle.nats = 30;
  e.ladder.nats = 60;
  const Judgement found{Verdict::kStiction, Reason::kSticksUnderLoad};
  EXPECT_EQ(doubt_repeating(found, e).verdict, Verdict::kStiction);
  e.ladder.nats = 40;
  EXPECT_EQ(doubt_repeating(found, e).verdict, Verdict::kUndecided);
  e.searched.nats = 60;
  EXPECT_EQ(doubt_repeating(found, e).verdict, Verdict::kStiction);
}

}  // namespace
}  // namespace ident
