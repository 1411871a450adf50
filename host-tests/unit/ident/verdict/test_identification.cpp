#include <gtest/gtest.h>

#include <set>
#include <string>

#include "ident/verdict/identification.hpp"

namespace ident {
namespace {

TEST(Identification, HasOneSentenceForEachReason) {
  std::set<std::string_view> seen;
  for (int k = 1; k < kReasons; ++k) {
    const std::string_view text = sentence(static_cast<Reason>(k));
    ASSERT_FALSE(text.empty()) << k;
    EXPECT_EQ(text.back(), '.') << text;
    EXPECT_TRUE(seen.insert(text).second) << text;
  }
}

TEST(Identification, HasOneVerdictForEachReason) {
  std::string verdicts;
  for (int k = 0; k < kReasons; ++k) {
    verdicts += name(verdict_of(static_cast<Reason>(k)))[0];
  }
  // In the order of Reason: (s)tiction, (b)acklash, (n)o stiction, (u)ndecided; bad data
  // is the other b.
  EXPECT_EQ(verdicts, "ussssbsnnnuuuuuuuuuuussubuuuuuuunu");
  EXPECT_EQ(verdict_of(Reason::kDeadbandOnly), Verdict::kBacklash);
  EXPECT_EQ(verdict_of(Reason::kNotFinite), Verdict::kBadData);
}

TEST(Identification, HasNoSentenceForNoReason) {
  EXPECT_TRUE(sentence(Reason::kNone).empty());
  EXPECT_TRUE(sentence(static_cast<Reason>(kReasons)).empty());
}

// What the data cannot tell comes with what would help.
TEST(Identification, TellsWhatToRecord) {
  for (const Reason reason :
       {Reason::kConstant, Reason::kTooShort, Reason::kOneStroke, Reason::kTooFewCycles,
        Reason::kAtLimit, Reason::kSetpointMoves, Reason::kModelTooPoor,
        Reason::kEvidenceTooWeak, Reason::kBandBelowResolution, Reason::kBandWouldNotShow,
        Reason::kStemUnconfirmed, Reason::kReadingCutOff}) {
    EXPECT_NE(sentence(reason).find("record"), std::string_view::npos)
        << sentence(reason);
  }
}

template <class Real>
void starts_without_a_claim() {
  const Identification<Real> nothing;
  EXPECT_EQ(nothing.verdict, Verdict::kUndecided);
  EXPECT_EQ(nothing.reason, Reason::kNone);
  EXPECT_FALSE(nothing.stick_band.ascending.known);
  EXPECT_FALSE(nothing.stick_band.descending.known);
  EXPECT_FALSE(nothing.slip_jump.ascending.known);
  EXPECT_FALSE(nothing.slip_jump.descending.known);
  EXPECT_FALSE(nothing.valve.known);
  EXPECT_EQ(nothing.evidence.form, ValveForm::kLinear);
  EXPECT_EQ(nothing.evidence.error_ratio, Real(1));
  EXPECT_EQ(nothing.detectable_band, Real(0));
  EXPECT_EQ(nothing.evidence.ladder.predicted, 0u);
  EXPECT_FALSE(nothing.evidence.stem_weighed);
  EXPECT_EQ(nothing.cause, Cause::kUnknown);
}

TEST(Identification, StartsWithoutAClaim) {
  starts_without_a_claim<float>();
  starts_without_a_claim<double>();
}

}  // namespace
}  // namespace ident
