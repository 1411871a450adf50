// Offsets and scales worked by hand, and signals that do not move.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "ident/signal_scale.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

TEST(SignalScale, MapsTheRangeToZeroToOne) {
  Signal values{3, 7, 5};
  const auto scale = scale_of_range<double>(values);
  EXPECT_TRUE(scale.moves);
  EXPECT_EQ(scale.offset, 3);
  EXPECT_EQ(scale.factor, 4);
  scale.apply(values);
  EXPECT_EQ(values, (Signal{0, 1, 0.5}));
}

TEST(SignalScale, MapsToZeroMeanAndUnitVariance) {
  Signal values{1, 3, 1, 3};
  const auto scale = scale_of_variance<double>(values);
  EXPECT_TRUE(scale.moves);
  EXPECT_NEAR(scale.offset, 2, 1e-12);
  EXPECT_NEAR(scale.factor, 1, 1e-12);
  scale.apply(values);
  EXPECT_NEAR(values[0], -1, 1e-12);
  EXPECT_NEAR(values[3], 1, 1e-12);
}

TEST(SignalScale, BearsLargeAndSmallNumbers) {
  for (const double factor : {1e-300, 1e-150, 1e150, 1e300}) {
    const auto scale = scale_of_variance<double>(Signal{-factor, factor});
    EXPECT_TRUE(scale.moves) << factor;
    EXPECT_NEAR(scale.factor / factor, 1, 1e-12) << factor;
  }
}

TEST(SignalScale, SeesNoMovementInConstants) {
  for (const double level : {0.0, 3.0, -1e9}) {
    EXPECT_FALSE(scale_of_range<double>(Signal(10, level)).moves) << level;
    EXPECT_FALSE(scale_of_variance<double>(Signal(10, level)).moves) << level;
  }
  // A swing in the last digits only.
  EXPECT_FALSE(scale_of_range<double>(Signal{1e9, 1e9 + 6}).moves);
  EXPECT_FALSE(scale_of_variance<double>(Signal{1e9, 1e9 + 6}).moves);
  EXPECT_TRUE(scale_of_range<double>(Signal{1e6, 1e6 + 6}).moves);
  // A range that is no number any more.
  const double most = std::numeric_limits<double>::max();
  EXPECT_FALSE(scale_of_range<double>(Signal{-most, most}).moves);
}

TEST(ScaledMeans, AveragesAndScales) {
  Signal means(2);
  // Means 2 and 6: mean 4, deviation 2. The seventh value is left over.
  ASSERT_TRUE(scaled_means<double>(Signal{1, 2, 3, 5, 6, 7, 100}, 3, means));
  EXPECT_NEAR(means[0], -1, 1e-12);
  EXPECT_NEAR(means[1], 1, 1e-12);
}

TEST(ScaledMeans, RefusesMeansThatAreAllAlike) {
  Signal means(2);
  EXPECT_FALSE(scaled_means<double>(Signal{1, 3, 3, 1}, 2, means));
  EXPECT_TRUE(scaled_means<double>(Signal{1, 3, 3, 1}, 1, std::span<double>(means)));
}

TEST(SignalScale, IsTheSameInFloat) {
  const auto scale = scale_of_variance<float>(std::vector<float>{1, 3, 1, 3});
  EXPECT_NEAR(scale.factor, 1, 1e-6f);
  EXPECT_EQ(scale_of_range<float>(std::vector<float>{1, 3}).factor, 2);
}

}  // namespace
}  // namespace ident
