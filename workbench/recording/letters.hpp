// Letters and digits of ASCII, whatever the locale says.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "wire/text.hpp"

namespace workbench {

using wire::is_digit;

[[nodiscard]] constexpr bool is_capital(char c) {
  return c >= 'A' && c <= 'Z';
}
[[nodiscard]] constexpr bool is_small(char c) {
  return c >= 'a' && c <= 'z';
}

/// A letter, or a byte of one beyond ASCII.
[[nodiscard]] constexpr bool is_letter_byte(char c) {
  return is_small(c) || is_capital(c) || static_cast<unsigned char>(c) >= 0x80;
}

/// With small letters; bytes beyond ASCII stay. Never fails.
[[nodiscard]] constexpr char lower_case(char c) {
  return is_capital(c) ? static_cast<char>(c + 32) : c;
}
[[nodiscard]] inline std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = lower_case(c);
  return out;
}

/// True where the text is one of the words, letter for letter.
[[nodiscard]] inline bool is_one_of(std::string_view text,
                                    std::span<const std::string_view> words) {
  return std::ranges::find(words, text) != words.end();
}

}  // namespace workbench
