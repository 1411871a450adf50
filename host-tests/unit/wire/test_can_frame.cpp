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

TEST(CanFrame, LengthsOfCanFd) {
  CanFrame frame;
  frame.fd = frame.brs = true;
  for (int length = 0; length <= 255; ++length) {
    frame.dlc = static_cast<std::uint8_t>(length);
    const bool known = length <= 8 || length == 12 || length == 16 || length == 20 ||
                       length == 24 || length == 32 || length == 48 || length == 64;
    EXPECT_EQ(is_valid(frame), known) << length;
  }
  frame.dlc = 8;
  frame.remote = true;
  EXPECT_FALSE(is_valid(frame)) << "CAN FD has no remote frames";
  frame.remote = frame.fd = false;
  EXPECT_FALSE(is_valid(frame)) << "a classic frame has no bit rate switch";
}

TEST(CanFrame, LengthOfClassicFrames) {
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
