// What is left of evidence that comes from one place.
#include <gtest/gtest.h>

#include "ident/evidence/spoken_parts.hpp"

namespace ident {
namespace {

constexpr std::size_t kParts = SpokenParts<double>::kCount;

// A stem that takes `everywhere` from each part, and `more` from the fourth.
SpokenParts<double> speaking(double everywhere, double more) {
  SpokenParts<double> parts;
  for (std::size_t i = 0; i < kParts; ++i) parts.set(i, 100);
  for (std::size_t i = 0; i < kParts; ++i) {
    parts.less(i, 100 - everywhere - (i == 3 ? more : 0));
  }
  return parts;
}

TEST(SpokenParts, WhatIsSaidEverywhereCounts) {
  EXPECT_DOUBLE_EQ(speaking(2, 0).without_excess(50), 50);
}

TEST(SpokenParts, OnePartMaySayThreeTimesAsMuchAsTheOthers) {
  EXPECT_DOUBLE_EQ(speaking(2, 4).without_excess(50), 50);
  // 20 parts of 2, and 12 more in one of which 4 count.
  EXPECT_DOUBLE_EQ(speaking(2, 12).without_excess(52), 44);
}

TEST(SpokenParts, WhatIsSaidInOnePlaceOnlyIsNothing) {
  EXPECT_DOUBLE_EQ(speaking(0, 30).without_excess(50), 0);
  EXPECT_LE(speaking(-1, 30).without_excess(50), 0);
}

TEST(SpokenParts, AgainstAStemNothingIsTakenBack) {
  EXPECT_DOUBLE_EQ(speaking(-1, 0).without_excess(-20), -20);
}

}  // namespace
}  // namespace ident
