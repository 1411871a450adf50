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

/// `text[start … start + length)`, cut to what exists.
constexpr std::string_view slice(std::string_view text, std::size_t start,
                                 std::size_t length) {
  if (start >= text.size()) return {};
  const std::size_t left = text.size() - start;
  return {text.data() + start, length < left ? length : left};
}

}  // namespace wire
