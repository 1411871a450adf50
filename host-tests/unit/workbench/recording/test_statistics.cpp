#include <gtest/gtest.h>

#include <cmath>

#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

using Values = std::vector<double>;

TEST(Statistics, MeanAndWhatIsLeftWithoutIt) {
  EXPECT_EQ(mean_of(Values{1, 2, 6}), 3);
  EXPECT_EQ(centred(Values{1, 2, 6}), (Values{-2, -1, 3}));
  EXPECT_TRUE(centred({}).empty());
}

TEST(Statistics, RanksCountFromTheSmallest) {
  Values values = {5, 1, 9, 2};
  EXPECT_EQ(of_rank(values, 0), 1);
  EXPECT_EQ(of_rank(values, 2), 5);
  EXPECT_EQ(of_rank(values, 3), 9);
}

TEST(Statistics, MedianIsTheMiddleOrTheMeanOfTheTwoThere) {
  EXPECT_EQ(median({3}), 3);
  EXPECT_EQ(median({5, 1, 9}), 5);
  EXPECT_EQ(median({5, 1, 9, 2}), 3.5);
}

TEST(Statistics, GapsAreAlike) {
  EXPECT_TRUE(are_alike(2, 2));
  EXPECT_TRUE(are_alike(NAN, NAN));
  EXPECT_FALSE(are_alike(2, NAN));
  EXPECT_FALSE(are_alike(2, 3));
}

}  // namespace
}  // namespace workbench
