#include <gtest/gtest.h>

#include <array>

#include "wire/uds_reply.hpp"

namespace wire {
namespace {

TEST(UdsReply, AppendsUntilItIsFull) {
  std::array<std::uint8_t, 5> storage{};
  UdsReply reply(storage);
  reply.number(0x0102, 2);
  reply.bytes(std::array<std::uint8_t, 2>{3, 4});
  EXPECT_EQ(reply.room().size(), 1U);
  EXPECT_FALSE(reply.overflow());
  reply.number(0x0506, 2);
  EXPECT_TRUE(reply.overflow());
  reply.number(7, 1);
  EXPECT_EQ(reply.data().size(), 4U) << "nothing after what did not fit";
  EXPECT_EQ(storage, (std::array<std::uint8_t, 5>{1, 2, 3, 4, 0}));
}

}  // namespace
}  // namespace wire
