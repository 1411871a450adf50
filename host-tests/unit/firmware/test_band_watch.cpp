#include <gtest/gtest.h>

#include "firmware/band_watch.hpp"

namespace firmware {
namespace {

constexpr double kNone = wire::kNotAvailable;

BandWatch::Bands bands(double low, double high, double down_low = kNone,
                       double down_high = kNone) {
  return {{{low, high}, {down_low, down_high}}};
}

TEST(BandWatch, TellsAChangeThatTwoWindowsConfirm) {
  BandWatch watch;
  EXPECT_FALSE(watch.take(bands(4.8, 5.2))) << "the first is not a change";
  EXPECT_FALSE(watch.take(bands(5.1, 5.5))) << "the intervals touch";
  EXPECT_FALSE(watch.take(bands(6.0, 6.4)));
  EXPECT_TRUE(watch.take(bands(6.1, 6.5)));
  EXPECT_FALSE(watch.take(bands(6.1, 6.5))) << "told once";
  EXPECT_EQ(watch.told()[0], (wire::BandInterval{6.1, 6.5}));
}

TEST(BandWatch, OneWindowAloneIsNoChange) {
  BandWatch watch;
  for (int k = 0; k < 5; ++k) {
    EXPECT_FALSE(watch.take(bands(4.8, 5.2)));
    EXPECT_FALSE(watch.take(bands(2.0, 2.2)));
    EXPECT_FALSE(watch.take(bands(4.8, 5.2)));
    EXPECT_FALSE(watch.take(bands(7.0, 7.2)));
  }
}

TEST(BandWatch, WindowsOnTwoSidesDoNotConfirmEachOther) {
  BandWatch watch;
  EXPECT_FALSE(watch.take(bands(4.8, 5.2)));
  EXPECT_FALSE(watch.take(bands(2.0, 2.2)));
  EXPECT_FALSE(watch.take(bands(7.0, 7.2)));
}

TEST(BandWatch, AWindowThatKnowsNoBandSaysNothing) {
  BandWatch watch;
  EXPECT_FALSE(watch.take(bands(4.8, 5.2, 1, 2)));
  EXPECT_FALSE(watch.take(bands(6, 7, kNone, kNone)));
  EXPECT_FALSE(watch.take(bands(kNone, kNone, 1, 2)));
  EXPECT_TRUE(watch.take(bands(6, 7, kNone, kNone)));
}

TEST(BandWatch, GoesOnAfterARestart) {
  BandWatch before;
  EXPECT_FALSE(before.take(bands(4.8, 5.2)));
  BandWatch after;
  after.restore(before.told());
  EXPECT_FALSE(after.take(bands(6, 7)));
  EXPECT_TRUE(after.take(bands(6, 7)));
}

}  // namespace
}  // namespace firmware
