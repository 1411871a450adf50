#include <gtest/gtest.h>

#include <array>

#include "wire/big_endian.hpp"

namespace wire {
namespace {

TEST(BigEndian, EveryWidthThereAndBack) {
  constexpr std::uint64_t kValue = 0x0123456789ABCDEF;
  for (std::size_t bytes = 1; bytes <= 8; ++bytes) {
    std::array<std::uint8_t, 9> out;
    out.fill(0xEE);
    put_big_endian(kValue, std::span(out).first(bytes));
    EXPECT_EQ(out[bytes - 1], 0xEF);
    EXPECT_EQ(out[bytes], 0xEE);
    EXPECT_EQ(get_big_endian(std::span(out).first(bytes)),
              kValue & ~std::uint64_t{0} >> (64 - 8 * bytes));
  }
  EXPECT_EQ(get_big_endian({}), 0U);
}

}  // namespace
}  // namespace wire
