// Character classes and slices for the line readers, without the throwing paths of
// std::string_view::substr.
#pragma once

#include <cstddef>
#include <string_view>

namespace wire {

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
constexpr bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
/// 0 … 15; −1 for what is no digit of a hexadecimal number.
constexpr int hex_value(char c) {
  if (is_digit(c)) return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

/// `text[start … start + length)`, cut to what exists.
constexpr std::string_view slice(std::string_view text, std::size_t start,
                                 std::size_t length) {
  if (start >= text.size()) return {};
  const std::size_t left = text.size() - start;
  return {text.data() + start, length < left ? length : left};
}

}  // namespace wire
