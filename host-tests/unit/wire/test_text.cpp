#include <gtest/gtest.h>

#include <cstdint>

#include "wire/text.hpp"

namespace wire {
namespace {

TEST(Text, SlicesWhatExists) {
  EXPECT_EQ(slice("stem", 1, 2), "te");
  EXPECT_EQ(slice("stem", 2, 9), "em");
  EXPECT_EQ(slice("stem", 5, 1), "");
}

TEST(Text, IsTakenPartByPart) {
  std::string_view rest = "a,,b";
  EXPECT_EQ(take_until(rest, ','), "a");
  EXPECT_EQ(take_until(rest, ','), "");
  EXPECT_EQ(take_until(rest, ','), "b");
  EXPECT_TRUE(rest.empty());
  EXPECT_EQ(take_until(rest, ','), "");
}

TEST(Text, HasANumberThatIsTheWholeOfIt) {
  EXPECT_EQ(number_of<double>("-4.5e2"), -450.0);
  EXPECT_EQ(number_of<std::uint32_t>("7ff", 16), 0x7ffU);
  for (const char* text : {"", "4,5", "+4", "4 %", "1 000", "x", "1e999"}) {
    EXPECT_FALSE(number_of<double>(text)) << text;
  }
  for (const char* text : {"-1", "256", "1.0", "f"}) {
    EXPECT_FALSE(number_of<std::uint8_t>(text)) << text;
  }
}

}  // namespace
}  // namespace wire
