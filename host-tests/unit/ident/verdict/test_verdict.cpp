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

}  // namespace
}  // namespace ident
