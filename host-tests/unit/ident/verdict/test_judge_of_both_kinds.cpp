// How the judge weighs both kinds of evidence: every branch and every threshold from both
// sides, with evidence made by hand.
#include <gtest/gtest.h>

#include "ident/verdict/judge.hpp"
#include "support/ident/judge_evidence.hpp"

namespace ident {
namespace {

using test::Change;
using test::expect;
using test::judge;
using test::sticking;

// One sample ahead as well: the stem and a rung of the same band say the same.
Evidence<double> weighed() {
  Evidence<double> e = sticking();
  e.fit_percent = 80;
  e.fit_linear_percent = 70;
  e.ladder.predicted = 500;
  e.ladder.nats = 60;
  e.ladder.band = 0.5;
  e.ladder.strokes = 20;
  e.ladder.detectable_band = e.ladder.hoped_band = 0.1;
  e.stem_weighed = true;
  e.stem_nats = 60;
  e.stem_strokes = 20;
  return e;
}

// Found running free by nothing but its better form, and by no rung, though one has a few
// nats.
Evidence<double> stem_alone() {
  Evidence<double> e = weighed();
  e.score = 0;
  e.error_ratio = 1;
  e.consistency = 0;
  e.cycles_better = 0;
  e.ladder.nats = 5;
  return e;
}

// Found by a rung of the ladder alone.
Evidence<double> rung_alone() {
  Evidence<double> e = stem_alone();
  e.form = ValveForm::kLinear;
  e.band_over_swing = e.slip_over_band = 0;
  e.stem_weighed = false;
  e.stem_nats = 0;
  e.ladder.nats = 60;
  return e;
}

// Found by nothing.
Evidence<double> following() {
  Evidence<double> e = rung_alone();
  e.ladder.nats = -5;
  return e;
}

Reason judged(Evidence<double> e, Change change, bool oscillates = true) {
  change(e);
  return judge(e, oscillates);
}

TEST(JudgeOfBothKinds, WhatConvincesRunningFreeNeedsTenNats) {
  const auto confirmed = [](double stem, double rung) {
    Evidence<double> e = weighed();
    e.stem_nats = stem;
    e.ladder.nats = rung;
    return judge(e, true);
  };
  expect(confirmed(60, 60), Reason::kSticksBothStrokes);
  expect(confirmed(10.1, -9), Reason::kSticksBothStrokes);
  expect(confirmed(-9, 10.1), Reason::kSticksBothStrokes);
  expect(confirmed(10, 10), Reason::kStemUnconfirmed);
  expect(confirmed(-50, -50), Reason::kStemUnconfirmed);
  // However clear it is running free.
  expect(judged(weighed(),
                [](auto& e) {
                  e.score = 1000;
                  e.error_ratio = 100;
                  e.stem_nats = e.ladder.nats = 9;
                }),
         Reason::kStemUnconfirmed);
}

TEST(JudgeOfBothKinds, ARungConfirmsAStemOfItsOwnBandOnly) {
  const auto confirmed = [](double band) {
    Evidence<double> e = weighed();
    e.stem_nats = 0;
    e.ladder.nats = 30;
    e.ladder.band = band;
    return judge(e, true);
  };
  // Within a factor of 1.5 of 0.5.
  expect(confirmed(0.74), Reason::kSticksBothStrokes);
  expect(confirmed(0.76), Reason::kEvidenceTooWeak);
  expect(confirmed(0.34), Reason::kSticksBothStrokes);
  expect(confirmed(0.33), Reason::kEvidenceTooWeak);
}

// A stem that was not weighed, because the search ended without one, has no nats.
TEST(JudgeOfBothKinds, AStemThatWasNotWeighedConfirmsNothing) {
  expect(judged(weighed(),
                [](auto& e) {
                  e.stem_weighed = false;
                  e.ladder.nats = 0;
                }),
         Reason::kStemUnconfirmed);
}

TEST(JudgeOfBothKinds, TwoThatAgreeNeedTwentyFiveNats) {
  // Too small a gain, and in too few cycles, to convince running free.
  const auto agreeing = [](Change change) {
    Evidence<double> e = weighed();
    e.error_ratio = 1.2;
    e.cycles_better = 7;
    e.stem_nats = 25.1;
    e.ladder.nats = 0;
    return judged(e, change);
  };
  expect(agreeing([](auto&) {}), Reason::kSticksBothStrokes);
  expect(agreeing([](auto& e) { e.stem_nats = 25; }), Reason::kEvidenceTooWeak);
  expect(agreeing([](auto& e) { e.score = 10; }), Reason::kEvidenceTooWeak);
  expect(agreeing([](auto& e) { e.score = 10.1; }), Reason::kSticksBothStrokes);
  expect(agreeing([](auto& e) { e.error_ratio = 1.15; }), Reason::kEvidenceTooWeak);
  expect(agreeing([](auto& e) { e.error_ratio = 1.16; }), Reason::kSticksBothStrokes);
  expect(agreeing([](auto& e) { e.consistency = 2.3; }), Reason::kEvidenceTooWeak);
  expect(agreeing([](auto& e) { e.cycles_better = 6; }), Reason::kEvidenceTooWeak);
}

TEST(JudgeOfBothKinds, AStemAloneNeedsTwentyNatsAndEightStrokes) {
  const auto alone = [](Change change) { return judged(stem_alone(), change); };
  expect(alone([](auto&) {}), Reason::kSticksBothStrokes);
  expect(alone([](auto& e) { e.stem_nats = 20.1; }), Reason::kSticksBothStrokes);
  expect(alone([](auto& e) { e.stem_nats = 20; }), Reason::kEvidenceTooWeak);
  expect(alone([](auto& e) { e.stem_strokes = 8; }), Reason::kSticksBothStrokes);
  expect(alone([](auto& e) { e.stem_strokes = 7; }), Reason::kEvidenceTooWeak);
  // What kind of fault it is, is asked as ever.
  expect(alone([](auto& e) { e.slip_over_band = 0; }), Reason::kDeadbandOnly);
  expect(alone([](auto& e) { e.band_over_swing = 0.049; }), Reason::kBandDoesNotMatter);
}

TEST(JudgeOfBothKinds, ARungAloneNeedsManyNatsAndABandThatMatters) {
  const auto rung = [](Change change) { return judged(rung_alone(), change); };
  expect(rung([](auto&) {}), Reason::kSticksUnderLoad);
  expect(rung([](auto& e) { e.ladder.nats = 46.1; }), Reason::kSticksUnderLoad);
  expect(rung([](auto& e) { e.ladder.nats = 46; }), Reason::kEvidenceTooWeak);
  expect(rung([](auto& e) { e.ladder.strokes = 8; }), Reason::kSticksUnderLoad);
  expect(rung([](auto& e) { e.ladder.strokes = 7; }), Reason::kEvidenceTooWeak);
  expect(rung([](auto& e) { e.reversals = 10; }), Reason::kSticksUnderLoad);
  expect(rung([](auto& e) { e.reversals = 9; }), Reason::kTooFewCycles);
  expect(rung([](auto& e) { e.ladder.band = 0.051; }), Reason::kSticksUnderLoad);
  expect(rung([](auto& e) { e.ladder.band = 0.05; }), Reason::kEvidenceTooWeak);
  expect(rung([](auto& e) { e.ladder.band = 1.04; }), Reason::kSticksUnderLoad);
  expect(rung([](auto& e) { e.ladder.band = 1.05; }), Reason::kEvidenceTooWeak);
}

// Where a stem of any kind was looked for, the ladder's has no say of its own.
TEST(JudgeOfBothKinds, ASearchedStemSpeaksInsteadOfARung) {
  Evidence<double> searched = rung_alone();
  searched.ladder.nats = 30;
  searched.searched = {true, 60, 20, {{true, 0.5, 0.4, 0.6}, {true, 0.2, 0, 0.3}}};
  const auto stem = [&searched](Change change) { return judged(searched, change); };
  expect(stem([](auto&) {}), Reason::kSticksUnderLoad);
  expect(stem([](auto& e) { e.searched.nats = 20.1; }), Reason::kSticksUnderLoad);
  expect(stem([](auto& e) { e.searched.nats = 20; }), Reason::kEvidenceTooWeak);
  expect(stem([](auto& e) {
           e.searched.nats = 0;
           e.ladder.nats = 500;
         }),
         Reason::kEvidenceTooWeak);
  expect(stem([](auto& e) { e.searched.strokes = 8; }), Reason::kSticksUnderLoad);
  expect(stem([](auto& e) { e.searched.strokes = 7; }), Reason::kEvidenceTooWeak);
  expect(stem([](auto& e) { e.reversals = 10; }), Reason::kSticksUnderLoad);
  expect(stem([](auto& e) { e.reversals = 9; }), Reason::kTooFewCycles);
  // The wider of its bands has to matter, and u has to pass it.
  const auto narrow = [&searched](double band, double running_free) {
    Evidence<double> e = searched;
    e.searched.band.ascending.value = band;
    e.searched.band.descending.value = 0;
    e.form = running_free > 0 ? ValveForm::kSymmetric : ValveForm::kLinear;
    e.band_over_swing = running_free;
    return judge(e, true);
  };
  expect(narrow(0.351, 0), Reason::kSticksUnderLoad);
  expect(narrow(0.35, 0), Reason::kEvidenceTooWeak);
  expect(narrow(0.34, 0.5), Reason::kSticksUnderLoad);
  expect(narrow(0.34, 0.52), Reason::kEvidenceTooWeak);
  expect(narrow(0.051, 0.051), Reason::kSticksUnderLoad);
  expect(narrow(0.05, 0.05), Reason::kEvidenceTooWeak);
  expect(stem([](auto& e) { e.searched.band.descending.value = 1.04; }),
         Reason::kSticksUnderLoad);
  expect(stem([](auto& e) { e.searched.band.descending.value = 1.05; }),
         Reason::kEvidenceTooWeak);
}

// What was said one cycle ago, and what bounded stems say, is none of a stem's own.
TEST(JudgeOfBothKinds, AStemHasToTellTwentyNatsMoreThanItsRivals) {
  Evidence<double> searched = rung_alone();
  searched.searched = {true, 100, 20, {{true, 0.5, 0.4, 0.6}, {true, 0.2, 0, 0.3}}};
  Evidence<double> fitted = stem_alone();
  fitted.stem_nats = 100;
  for (Evidence<double> e : {searched, fitted}) {
    e.cycle.nats = 30;
    e.bounded.nats = 49.9;
    EXPECT_EQ(verdict_of(judge(e, true)), Verdict::kStiction);
    e.bounded.nats = 50;
    expect(judge(e, true), Reason::kEvidenceTooWeak);
    e.bounded.nats = -50;
    e.cycle.nats = 80;
    expect(judge(e, true), Reason::kEvidenceTooWeak);
  }
}

// Rivals are weighed where a rung has any nats.
TEST(JudgeOfBothKinds, AStemWhoseRivalsWereNotWeighedNeedsManyNats) {
  Evidence<double> e = rung_alone();
  e.ladder.nats = 0;
  e.searched = {true, 46.1, 20, {{true, 0.5, 0.4, 0.6}, {true, 0.2, 0, 0.3}}};
  expect(judge(e, true), Reason::kSticksUnderLoad);
  e.searched.nats = 46;
  expect(judge(e, true), Reason::kEvidenceTooWeak);
}

// A load that comes and goes in steps is foretold by a stem, too; it explains nothing.
TEST(JudgeOfBothKinds, NoStemSticksBesideAValveThatExplainsNextToNothing) {
  Evidence<double> searched = rung_alone();
  searched.ladder.nats = 46;
  searched.searched = {true, 46, 20, {{true, 0.5, 0.4, 0.6}, {true, 0.2, 0, 0.3}}};
  Evidence<double> fitted = stem_alone();
  fitted.stem_nats = 46;
  for (Evidence<double> e : {searched, fitted}) {
    e.fit_percent = 15.1;
    EXPECT_EQ(verdict_of(judge(e, true)), Verdict::kStiction);
    e.fit_percent = 15;
    expect(judge(e, true), Reason::kEvidenceTooWeak);
  }
  // Unless it foretells so much that nothing else is left.
  for (Evidence<double> e : {rung_alone(), searched, stem_alone()}) {
    e.fit_percent = 1;
    e.searched.nats *= 1.01;
    EXPECT_EQ(verdict_of(judge(e, true)), Verdict::kStiction);
    e.cycle.nats = 20;
    expect(judge(e, true), Reason::kEvidenceTooWeak);
  }
}

// Wider than half the swing it may, if it moves y at all.
TEST(JudgeOfBothKinds, AWideStemSticksBesideAValveThatExplainsLittle) {
  Evidence<double> e = rung_alone();
  e.ladder.nats = 40;
  e.searched = {true, 40, 20, {{true, 0.51, 0.4, 0.6}, {true, 0.2, 0, 0.3}}};
  e.fit_percent = 6.1;
  expect(judge(e, true), Reason::kSticksUnderLoad);
  e.fit_percent = 6;
  expect(judge(e, true), Reason::kEvidenceTooWeak);
}

TEST(JudgeOfBothKinds, AFittedValveComesBeforeASearchedStem) {
  Evidence<double> e = weighed();
  e.searched = {true, 500, 20, {{true, 0.5, 0.4, 0.6}, {true, 0.5, 0.4, 0.6}}};
  EXPECT_TRUE(fitted_valve_sticks(e));
  expect(judge(e, true), Reason::kSticksBothStrokes);
  EXPECT_FALSE(fitted_valve_sticks(rung_alone()));
}

TEST(JudgeOfBothKinds, ASearchedStemIsToldInsteadOfAFittedOneWithFarFewerNats) {
  const PerStroke<double> fitted{{true, 0.5, 0.4, 0.6}, {true, 0.1, 0, 0.2}};
  Evidence<double> e = weighed();
  e.searched = {true, 80.1, 20, {{true, 0.5, 0.4, 0.6}, {true, 0.5, 0.4, 0.6}}};
  ASSERT_EQ(e.stem_nats, 60);
  EXPECT_TRUE(searched_stem_is_told(e, fitted));
  e.searched.nats = 80;
  EXPECT_FALSE(searched_stem_is_told(e, fitted));
  // A fitted valve whose stem was not weighed has none; but the other has to stick.
  e.stem_weighed = false;
  EXPECT_TRUE(searched_stem_is_told(e, fitted));
  e.searched.nats = 20;
  EXPECT_FALSE(searched_stem_is_told(e, fitted));
  e.searched.nats = 80;
  e.searched.strokes = 7;
  EXPECT_FALSE(searched_stem_is_told(e, fitted));
}

TEST(JudgeOfBothKinds, ASearchedStemIsToldInsteadOfBandsThatReachNothing) {
  const PerStroke<double> fitted{{true, 0.5, 0, 0.6}, {true, 0.1, 0, 0.2}};
  Evidence<double> e = weighed();
  e.searched = {true, 20.1, 20, {{true, 0.5, 0.4, 0.6}, {true, 0.5, 0.4, 0.6}}};
  EXPECT_TRUE(searched_stem_is_told(e, fitted));
  e.searched.nats = 20;
  EXPECT_FALSE(searched_stem_is_told(e, fitted));
}

TEST(JudgeOfBothKinds, TheWidestBandOfASearchedStemIsComparedWithTheStepOfU) {
  Evidence<double> e = rung_alone();
  e.searched = {true, 60, 20, {{true, 0.2, 0.1, 0.3}, {true, 0.4, 0.3, 0.5}}};
  LoopEvidence<double> loop;
  loop.oscillates = true;
  loop.u_step = 0.19;
  expect(ident::judge(e, loop), Reason::kSticksUnderLoad);
  loop.u_step = 0.21;
  expect(ident::judge(e, loop), Reason::kBandBelowResolution);
}

TEST(JudgeOfBothKinds, TheStrongerOfTheWindowsStemsCounts) {
  Evidence<double> e = weighed();
  EXPECT_EQ(nats_of_stems(e, -1.0), 60);
  e.searched.asked = true;
  e.searched.nats = 70;
  EXPECT_EQ(nats_of_stems(e, -1.0), 70);
  // No stem was worth it.
  e.searched.nats = 0;
  e.stem_nats = -15;
  EXPECT_EQ(nats_of_stems(e, -1.0), -15);
  e.stem_weighed = false;
  EXPECT_EQ(nats_of_stems(e, -1.0), -1);
}

// Where a valve that follows u explains y, nothing is hidden from the free run.
TEST(JudgeOfBothKinds, OneSampleAheadAloneIsHeardOnlyWhereALoadMayHideAStem) {
  const auto explained = [](Evidence<double> e, double percent) {
    e.fit_linear_percent = percent;
    return judge(e, true);
  };
  Evidence<double> stem = rung_alone();
  stem.searched = {true, 60, 20, {{true, 0.5, 0.4, 0.6}, {true, 0.2, 0, 0.3}}};
  for (const Evidence<double>& e : {rung_alone(), stem}) {
    expect(explained(e, 79.9), Reason::kSticksUnderLoad);
    expect(explained(e, 80), Reason::kEvidenceTooWeak);
  }
  Evidence<double> fitted = stem_alone();
  expect(explained(fitted, 79.9), Reason::kSticksBothStrokes);
  expect(explained(fitted, 80), Reason::kEvidenceTooWeak);
  fitted.error_ratio = 1.16;
  expect(explained(fitted, 80), Reason::kSticksBothStrokes);
  fitted.error_ratio = 1.15;
  expect(explained(fitted, 80), Reason::kEvidenceTooWeak);
}

// The rung's valve is described only where no fitted one is found.
TEST(JudgeOfBothKinds, AFittedValveComesBeforeARung) {
  expect(judged(weighed(), [](auto& e) { e.ladder.nats = 500; }),
         Reason::kSticksBothStrokes);
  expect(judged(weighed(),
                [](auto& e) {
                  e.ladder.band = 1;
                  e.stem_nats = 0;
                }),
         Reason::kSticksUnderLoad);
}

TEST(JudgeOfBothKinds, BetweenTenNatsAndAVerdictTheEvidenceIsTooWeak) {
  const auto nats = [](double value) {
    Evidence<double> e = following();
    e.ladder.nats = value;
    return judge(e, true);
  };
  expect(nats(10.1), Reason::kEvidenceTooWeak);
  expect(nats(10), Reason::kLinearExplains);
  expect(judged(stem_alone(), [](auto& e) { e.stem_nats = 10.1; }),
         Reason::kEvidenceTooWeak);
  expect(judged(stem_alone(), [](auto& e) { e.stem_nats = 10; }),
         Reason::kLinearExplains);
}

TEST(JudgeOfBothKinds, InAFewTurnsEightNatsAreEnoughForWhatIsBetterRunningFree) {
  const auto few = [](Change change) {
    Evidence<double> e = weighed();
    e.reversals = 9;
    e.error_ratio = 1.2;
    e.consistency = 2.4;
    e.cycles_better = 1;
    e.stem_nats = 8.1;
    e.ladder.nats = 0;
    return judged(e, change);
  };
  expect(few([](auto&) {}), Reason::kSticksBothStrokes);
  expect(few([](auto& e) { e.reversals = 2; }), Reason::kSticksBothStrokes);
  expect(few([](auto& e) { e.reversals = 1; }), Reason::kTooFewCycles);
  expect(few([](auto& e) { e.stem_nats = 8; }), Reason::kTooFewCycles);
  expect(few([](auto& e) { e.score = 10; }), Reason::kTooFewCycles);
  expect(few([](auto& e) { e.error_ratio = 1.15; }), Reason::kTooFewCycles);
  expect(few([](auto& e) { e.consistency = 2.3; }), Reason::kTooFewCycles);
  expect(few([](auto& e) { e.reversals = 10; }), Reason::kLinearExplains);
  expect(few([](auto& e) { e.band_over_swing = 0.049; }), Reason::kBandDoesNotMatter);
}

// What is better running free, not enough to convince, and not one sample ahead.
TEST(JudgeOfBothKinds, ASuspicionThatIsNotConfirmedIsNone) {
  const auto suspect = [](Change change) {
    Evidence<double> e = weighed();
    e.score = 5;
    e.stem_nats = e.ladder.nats = 10;
    return judged(e, change);
  };
  expect(suspect([](auto&) {}), Reason::kLinearExplains);
  expect(suspect([](auto& e) { e.ladder.detectable_band = e.ladder.hoped_band = 0.4; }),
         Reason::kBandWouldNotShow);
  // Of a band that does not matter, whatever would have shown.
  expect(suspect([](auto& e) {
           e.band_over_swing = 0.049;
           e.ladder.detectable_band = e.ladder.hoped_band = 0;
         }),
         Reason::kBandDoesNotMatter);
}

TEST(JudgeOfBothKinds, AValveFollowsOnlyWhereABandThatMattersWouldHaveShown) {
  const auto detectable = [](double band) {
    Evidence<double> e = following();
    e.ladder.detectable_band = e.ladder.hoped_band = band;
    return judge(e, true);
  };
  expect(detectable(0.1), Reason::kLinearExplains);
  expect(detectable(0.35), Reason::kLinearExplains);
  expect(detectable(0.36), Reason::kBandWouldNotShow);
  expect(detectable(0), Reason::kBandWouldNotShow);
}

TEST(JudgeOfBothKinds, ABandThatAStepTestExcludesDoesAsWell) {
  const auto excluded = [](double above) {
    Evidence<double> e = following();
    e.by_hand = true;
    e.reversals = 3;
    e.ladder.detectable_band = 0;
    e.excluded_above = above;
    return judge(e, false);
  };
  expect(excluded(0.35), Reason::kLinearExplains);
  expect(excluded(0.36), Reason::kBandWouldNotShow);
  expect(excluded(0), Reason::kBandWouldNotShow);
}

TEST(JudgeOfBothKinds, WhereNoValveExplainsYItIsAnotherThing) {
  const auto poor = [](auto& e) { e.fit_percent = 24.9; };
  expect(judged(following(), poor, true), Reason::kNotTheValve);
  expect(judged(following(), [](auto& e) { e.fit_percent = 25; }),
         Reason::kLinearExplains);
  expect(judged(following(),
                [](auto& e) {
                  e.fit_percent = 5;
                  e.ladder.detectable_band = e.ladder.hoped_band = 0.4;
                }),
         Reason::kBandWouldNotShow);
}

// Where nothing shows, the setpoint is a better reason than the band.
TEST(JudgeOfBothKinds, TheSetpointIsWhyNoBandWouldShow) {
  Evidence<double> e = following();
  e.ladder.detectable_band = e.ladder.hoped_band = 0;
  LoopEvidence<double> loop;
  loop.setpoint_share = 0.71;
  expect(ident::judge(e, loop), Reason::kSetpointMoves);
  e.ladder.detectable_band = e.ladder.hoped_band = 0.1;
  expect(ident::judge(e, loop), Reason::kLinearExplains);
  e.fit_linear_percent = 85;
  e.ladder.nats = 25;
  expect(ident::judge(e, loop), Reason::kSetpointMoves);
  e.ladder.nats = 25.1;
  expect(ident::judge(e, loop), Reason::kEvidenceTooWeak);
}

TEST(JudgeOfBothKinds, ReadsFloatAlike) {
  Evidence<float> e;
  e.reversals = 20;
  e.fit_percent = 60;
  e.ladder.predicted = 500;
  e.ladder.nats = 47;
  e.ladder.strokes = 8;
  e.ladder.band = 0.3f;
  EXPECT_EQ(judge(e, true), Reason::kSticksUnderLoad);
  e.ladder.nats = 3;
  EXPECT_EQ(judge(e, true), Reason::kBandWouldNotShow);
  e.ladder.detectable_band = e.ladder.hoped_band = 0.3f;
  EXPECT_EQ(judge(e, true), Reason::kLinearExplains);
}

TEST(JudgeOfBothKinds, ARungsBandIsComparedWithTheStepOfU) {
  LoopEvidence<double> loop;
  loop.oscillates = true;
  loop.u_step = 0.1;  // of a swing, the band is 0.5
  expect(ident::judge(rung_alone(), loop), Reason::kSticksUnderLoad);
  loop.u_step = 0.26;
  expect(ident::judge(rung_alone(), loop), Reason::kBandBelowResolution);
}

TEST(JudgeOfBothKinds, SaysOfALoopThatDoesNotOscillateThatTheModelIsTooPoor) {
  for (const double detectable : {0.0, 0.35, 0.36}) {
    Evidence<double> e = following();
    e.fit_percent = 5;
    e.ladder.detectable_band = detectable;
    const bool refuted = detectable == 0.35;
    expect(judge(e, false), refuted ? Reason::kLinearExplains : Reason::kModelTooPoor);
  }
}

}  // namespace
}  // namespace ident
