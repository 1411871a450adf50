#include <gtest/gtest.h>

#include "wire/j1939.hpp"

namespace wire::j1939 {
namespace {

TEST(J1939, AGroupToOneDeviceHasADestination) {
  EXPECT_TRUE(is_to_one(0xEF00));
  EXPECT_FALSE(is_to_one(0xF000));
  EXPECT_TRUE(is_to_one(0x1EF00));
  EXPECT_EQ(pgn_of(0x18FEF2FE), 0xFEF2U);
  EXPECT_EQ(pgn_of(0x18EF2103), 0xEF00U);
  EXPECT_EQ(pgn_of(0x1DF00103), 0x1F001U);
}

TEST(J1939, UnsignedWholeBytesHaveErrorCodes) {
  Signal signal;
  signal.length = 16;
  EXPECT_TRUE(has_error_codes(signal));
  signal.length = 12;
  EXPECT_FALSE(has_error_codes(signal));
  signal.length = 16;
  signal.is_signed = true;
  EXPECT_FALSE(has_error_codes(signal));
  signal = {};
  signal.length = 32;
  signal.type = ValueType::kFloat32;
  EXPECT_FALSE(has_error_codes(signal));
}

}  // namespace
}  // namespace wire::j1939
