// What people read: sentences for every verdict, advice that suits the cause, numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "workbench/analysis/wording.hpp"

namespace workbench {
namespace {

using ident::Cause;
using ident::Reason;

using ident::kReasons;

TEST(Wording, HasOneHeadlineForEachVerdict) {
  std::set<std::string_view> seen;
  for (int k = 0; k < 5; ++k) {
    const std::string_view text =
        headline(static_cast<ident::Verdict>(k), Reason::kNone, 1);
    ASSERT_FALSE(text.empty());
    EXPECT_TRUE(seen.insert(text).second) << text;
  }
}

TEST(Wording, SaysNoMoreOfAFineValveThanWasSeen) {
  const auto said = [](Reason reason, double band) {
    return headline(ident::Verdict::kNoStiction, reason, band);
  };
  EXPECT_EQ(said(Reason::kLinearExplains, 1), "The valve does not stick.");
  EXPECT_EQ(said(Reason::kLinearExplains, 0), "Nothing speaks for a sticking valve.");
  EXPECT_EQ(said(Reason::kBandDoesNotMatter, 1),
            "If the valve sticks, then by too little to matter.");
  EXPECT_EQ(said(Reason::kNotTheValve, 1),
            "Nothing says that the valve causes what is seen.");
  EXPECT_EQ(advice(Reason::kLinearExplains, Cause::kUnknown, 0, false).find("Leave"),
            std::string_view::npos);
}

// A reason that tells what to record needs no advice beside it, unless something else
// than the recording is to be looked at.
TEST(Wording, AdvisesWhereTheReasonDoesNot) {
  for (int k = 0; k < kReasons; ++k) {
    const Reason reason = static_cast<Reason>(k);
    const bool decided = k >= static_cast<int>(Reason::kSticksBothStrokes) &&
                         k <= static_cast<int>(Reason::kNotTheValve);
    const bool elsewhere =
        (k >= static_cast<int>(Reason::kSensorSticks) && reason != Reason::kLoadRepeats &&
         reason != Reason::kTurnsTooFast) ||
        reason == Reason::kSticksTogether || reason == Reason::kStrokesUnresolved;
    EXPECT_EQ(advice(reason, Cause::kUnknown, 1, true).empty(), !decided && !elsewhere)
        << ident::sentence(reason);
  }
}

TEST(Wording, AdvisesWhatSuitsTheCause) {
  const auto suited = [](Cause cause) {
    return advice(Reason::kLinearExplains, cause, 1, false);
  };
  EXPECT_NE(suited(Cause::kTightTuning).find("retune"), std::string_view::npos);
  EXPECT_NE(suited(Cause::kExternalPeriodic).find("another loop"),
            std::string_view::npos);
  EXPECT_EQ(suited(Cause::kSetpoint), suited(Cause::kUnknown));
  EXPECT_EQ(advice(Reason::kSticksAscending, Cause::kValve, 1, true),
            advice(Reason::kSticksAscending, Cause::kUnknown, 1, true));
}

TEST(Wording, SendsToThePlayAsWellWhereNoSlipWasTold) {
  const auto sends_to_play = [](bool slips) {
    return advice(Reason::kSticksBothStrokes, Cause::kValve, 0, slips).find("play") !=
           std::string_view::npos;
  };
  EXPECT_TRUE(sends_to_play(false));
  EXPECT_FALSE(sends_to_play(true));
}

TEST(Wording, RoundsToWhatTheIntervalSupports) {
  EXPECT_EQ(text_of({true, 5.0234, 4.83, 5.21}).value, "5.02");
  EXPECT_EQ(text_of({true, 5.0234, 4.83, 5.21}).interval, "4.83 to 5.21");
  EXPECT_EQ(text_of({true, 512.34, 480, 540}).value, "512");
  EXPECT_EQ(text_of({}).value, "unknown");
  EXPECT_EQ(fixed(-0.001, 1), "0.0");
  EXPECT_EQ(fixed(-0.0001, 2), "0.00");
  EXPECT_EQ(fixed(-1.5, 1), "-1.5");
  EXPECT_EQ(fixed(1.5e300, 2), "1.5e+300");
  EXPECT_EQ(fixed(std::nan(""), 1), "–");
}

TEST(Wording, GivesDurationsInTheUnitThatSuits) {
  EXPECT_EQ(duration(29.2), "29.2 s");
  EXPECT_EQ(duration(1400), "23.3 min");
  EXPECT_EQ(duration(7200), "2.00 h");
  EXPECT_EQ(duration(9000), "2.50 h");
  EXPECT_EQ(span_of({3, -1, 2}), 4);
}

}  // namespace
}  // namespace workbench
