#include <gtest/gtest.h>

#include <array>

#include "wire/crc32.hpp"

namespace wire {
namespace {

TEST(Crc32, CheckValue) {
  constexpr std::array<std::uint8_t, 9> kDigits = {'1', '2', '3', '4', '5',
                                                   '6', '7', '8', '9'};
  EXPECT_EQ(crc32(kDigits), 0xCBF43926U);
  EXPECT_EQ(crc32({}), 0U);
  const std::span<const std::uint8_t> all(kDigits);
  EXPECT_EQ(crc32(all.subspan(4), crc32(all.first(4))), 0xCBF43926U);
}

}  // namespace
}  // namespace wire
