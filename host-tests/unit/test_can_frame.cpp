#include <gtest/gtest.h>

#include "wire/can_frame.hpp"

namespace wire {
namespace {

TEST(CanFrame, RangesOfTheIdentifier) {
  CanFrame frame;
  EXPECT_TRUE(is_valid(frame));
  frame.id = 0x7FF;
  EXPECT_TRUE(is_valid(frame));
  frame.id = 0x800;
  EXPECT_FALSE(is_valid(frame));
  frame.extended = true;
  EXPECT_TRUE(is_valid(frame));
  frame.id = 0x20000000;
  EXPECT_FALSE(is_valid(frame));
}

TEST(CanFrame, ClassicLengthOnly) {
  CanFrame frame;
  frame.dlc = 8;
  EXPECT_TRUE(is_valid(frame));
  frame.dlc = 9;
  EXPECT_FALSE(is_valid(frame));
}

TEST(CanFrame, AnErrorFrameIsNotExtended) {
  CanFrame frame;
  frame.error = true;
  frame.id = 0x1FFFFFFF;
  EXPECT_TRUE(is_valid(frame));
  frame.extended = true;
  EXPECT_FALSE(is_valid(frame));
}

}  // namespace
}  // namespace wire
