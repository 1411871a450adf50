// Offsets and scales worked by hand, and signals that do not move.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include "ident/signal/signal_scale.hpp"

namespace ident {
namespace {

using Signal = std::vector<double>;

TEST(SignalScale, TellsNumbersFromWhatIsNone) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(all_finite<double>({}));
  EXPECT_TRUE(all_finite<double>(Signal{1, -2, 0}));
  EXPECT_FALSE(all_finite<double>(Signal{1, 2, kInfinity}));
  EXPECT_FALSE(all_finite<double>(Signal{std::nan(""), 2}));
}

TEST(SignalScale, RestsAtItsOffsetOrAtTheValueOfAConstant) {
  EXPECT_EQ((SignalScale<double>{true, 3, 2}.resting(Signal{7, 9})), 3);
  EXPECT_EQ((SignalScale<double>{false, 3, 2}.resting(Signal{7, 7})), 7);
  EXPECT_EQ((SignalScale<double>{false, 3, 2}.resting({})), 3);
}

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

// The rounded values, and what they are after having been scaled and scaled back.
template <class Real>
void expect_the_same_again(std::vector<Real> values) {
  const ValueGrid<Real> grid{std::span<const Real>(values)};
  for (Real& value : values) {
    value = grid.round(value);
  }
  for (const bool reverse : {false, true}) {
    for (const auto& of : {scale_of_range<Real>, scale_of_variance<Real>}) {
      SignalScale<Real> scale = of(values);
      if (!scale.moves) {
        continue;
      }
      scale.factor *= reverse ? Real(-1) : Real(1);
      auto scaled = values;
      scale.apply(scaled);
      for (std::size_t k = 0; k < values.size(); ++k) {
        ASSERT_EQ(grid.round(scale.back(scaled[k])), values[k]) << k;
      }
    }
  }
}

TEST(ValueGrid, BringsScaledValuesBackToTheBit) {
  std::mt19937 engine(1);
  std::normal_distribution<double> normal;
  for (const double level : {0.0, 0.3, 50.0, -7e4}) {
    for (const double swing : {1e-3, 1.0, 40.0, 3e6}) {
      std::vector<double> values(1000);
      for (double& value : values) {
        value = level + swing * normal(engine);
      }
      expect_the_same_again(values);
      expect_the_same_again(std::vector<float>(values.begin(), values.end()));
    }
  }
}

TEST(ValueGrid, RoundsByLittle) {
  for (const float level : {0.0F, 5.0F, 300.0F}) {
    const std::vector<float> values{level - 1.4F, level + 0.1234567F, level + 1.9F};
    const ValueGrid<float> grid{std::span<const float>(values)};
    for (const float value : values) {
      EXPECT_NEAR(grid.round(value), value, (level > 60 ? 3e-7F : 2e-6F) * values[2]);
    }
  }
}

TEST(ValueGrid, LeavesWhatItCannotRound) {
  const float most = std::numeric_limits<float>::max();
  for (const std::vector<float>& values :
       {std::vector<float>{}, {0, 0}, {-most, most}, {3, 3}}) {
    const ValueGrid<float> grid{std::span<const float>(values)};
    for (const float value : values) {
      EXPECT_EQ(grid.round(value), value);
    }
  }
  EXPECT_EQ(ValueGrid<float>().round(0.1F), 0.1F);
}

TEST(SignalScale, IsTheSameInFloat) {
  const auto scale = scale_of_variance<float>(std::vector<float>{1, 3, 1, 3});
  EXPECT_NEAR(scale.factor, 1, 1e-6f);
  EXPECT_EQ(scale_of_range<float>(std::vector<float>{1, 3}).factor, 2);
}

}  // namespace
}  // namespace ident
