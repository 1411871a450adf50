// Letters and digits of ASCII, whatever the locale says; words of any language.
#pragma once

#include <algorithm>
#include <cstddef>
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

/// Letters, digits and signs of UTF-8, which may have several bytes each.
[[nodiscard]] inline std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Whether some word of a table, words with | between them, fits.
template <class Fits>
[[nodiscard]] constexpr bool any_word(std::string_view words, Fits fits) {
  while (true) {
    const std::size_t end = words.find('|');
    if (fits(words.substr(0, end))) return true;
    if (end == std::string_view::npos) return false;
    words.remove_prefix(end + 1);
  }
}
template <class Take>
constexpr void for_each_word(std::string_view words, Take take) {
  (void)any_word(words, [&take](std::string_view word) { return take(word), false; });
}
/// Whether the text is one of such words, letter for letter. Some 50 ns.
[[nodiscard]] constexpr bool is_one_of(std::string_view text, std::string_view words) {
  if (text.empty() || text.find('|') != std::string_view::npos) return false;
  std::size_t at = words.find(text);
  for (; at != std::string_view::npos; at = words.find(text, at + 1)) {
    const std::size_t end = at + text.size();
    const bool whole = end == words.size() || words[end] == '|';
    if (whole && (at == 0 || words[at - 1] == '|')) return true;
  }
  return false;
}
/// Whether it begins with one of them.
[[nodiscard]] constexpr bool begins_with_one_of(std::string_view text,
                                                std::string_view words) {
  return any_word(words,
                  [text](std::string_view word) { return text.starts_with(word); });
}

/// The letters of UTF-8 text small, Latin ones without their marks (Á and ă are a, Ł is
/// l, Æ is ae, ß is ss), ё as е, full-width ones as ASCII; other bytes as they are.
[[nodiscard]] std::string folded(std::string_view text);

}  // namespace workbench
