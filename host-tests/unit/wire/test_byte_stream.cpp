#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "wire/byte_stream.hpp"

namespace wire {
namespace {

TEST(ByteStream, ReadsWhatWasWritten) {
  std::array<std::uint8_t, 20> room{};
  ByteWriter out(room);
  out.number(0x1234, 2);
  out.number(static_cast<std::uint16_t>(std::int16_t{-2}), 2);
  out.single(1.5);
  out.single(std::numeric_limits<double>::quiet_NaN());
  out.bytes(std::array<std::uint8_t, 3>{7, 8, 9});
  EXPECT_EQ(out.size(), 15U);
  EXPECT_EQ(room[0], 0x12) << "most significant byte first";

  ByteReader in(room);
  EXPECT_EQ(in.number(2), 0x1234U);
  EXPECT_EQ(static_cast<std::int16_t>(in.number(2)), -2);
  EXPECT_EQ(in.single(), 1.5F);
  EXPECT_TRUE(std::isnan(in.single()));
  EXPECT_EQ(in.bytes(3)[2], 9);
}

}  // namespace
}  // namespace wire
