#include <gtest/gtest.h>

#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

TEST(Letters, AreThoseOfAscii) {
  EXPECT_EQ(lower_case("AZaz@[09Ä"), "azaz@[09Ä");
  EXPECT_TRUE(is_digit('0') && is_digit('9'));
  EXPECT_FALSE(is_digit('/') || is_digit(':') || is_digit('\xB2'));
  EXPECT_TRUE(is_capital('A') && is_capital('Z') && is_small('a') && is_small('z'));
  EXPECT_FALSE(is_capital('[') || is_capital('@') || is_small('`') || is_small('{'));
  EXPECT_TRUE(is_letter_byte('A') && is_letter_byte('z') && is_letter_byte('\xC4'));
  EXPECT_FALSE(is_letter_byte('1') || is_letter_byte('_'));
}

TEST(Letters, FindAWordInAList) {
  constexpr std::string_view kWords = "auto|man|deg c";
  EXPECT_TRUE(is_one_of("auto", kWords) && is_one_of("man", kWords));
  EXPECT_TRUE(is_one_of("deg c", kWords));
  EXPECT_FALSE(is_one_of("ma", kWords) || is_one_of("an", kWords));
  EXPECT_FALSE(is_one_of("", kWords) || is_one_of("auto|man", kWords));
  EXPECT_TRUE(begins_with_one_of("manual", kWords));
  EXPECT_FALSE(begins_with_one_of("ma", kWords) || begins_with_one_of("xman", kWords));
}

TEST(Letters, CountCharactersAndNotTheirBytes) {
  EXPECT_EQ(characters(""), 0U);
  EXPECT_EQ(characters("Ventil"), 6U);
  EXPECT_EQ(characters("Öffnung 5 µm ±"), 14U);
}

}  // namespace
}  // namespace workbench
