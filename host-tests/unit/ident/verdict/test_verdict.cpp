#include <gtest/gtest.h>

#include "ident/verdict/verdict.hpp"

namespace ident {
namespace {

TEST(Verdict, HasTheContractsNames) {
  EXPECT_EQ(name(Verdict::kStiction), "stiction");
  EXPECT_EQ(name(Verdict::kBacklash), "backlash");
  EXPECT_EQ(name(Verdict::kNoStiction), "no_stiction");
  EXPECT_EQ(name(Verdict::kUndecided), "undecided");
  EXPECT_EQ(name(Verdict::kBadData), "bad_data");
}

TEST(Verdict, IsAFaultWhereTheValveSticksOrHasPlay) {
  EXPECT_TRUE(is_fault(Verdict::kStiction));
  EXPECT_TRUE(is_fault(Verdict::kBacklash));
  EXPECT_FALSE(is_fault(Verdict::kNoStiction));
  EXPECT_FALSE(is_fault(Verdict::kUndecided));
  EXPECT_FALSE(is_fault(Verdict::kBadData));
}

TEST(Estimate, IsUnknownUntilSaidOtherwise) {
  const PerStroke<float> stroke;
  EXPECT_FALSE(stroke.ascending.known);
  EXPECT_FALSE(stroke.descending.known);
}

TEST(PerStroke, CountsOnlyTheStrokesThatAreKnown) {
  PerStroke<float> band;
  band.ascending.value = 3;
  band.descending.value = 5;
  EXPECT_EQ(band.mean(), 0);
  EXPECT_EQ(band.larger(), 0);
  band.descending.known = true;
  EXPECT_EQ(band.mean(), 5);
  EXPECT_FALSE(band.both_known());
  band.ascending.known = true;
  EXPECT_EQ(band.mean(), 4);
  EXPECT_EQ(band.larger(), 5);
  EXPECT_TRUE(band.both_known());
  band.descending.known = false;
  EXPECT_EQ(band.mean(), 3);
}

}  // namespace
}  // namespace ident
