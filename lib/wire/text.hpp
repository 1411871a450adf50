// Character classes, slices and numbers for the line readers, without the throwing paths
// of std::string_view::substr.
#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

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

/// What of `rest` stands before the first `mark`, or all of it; `rest` goes on behind it.
constexpr std::string_view take_until(std::string_view& rest, char mark) {
  const std::string_view taken = slice(rest, 0, rest.find(mark));
  rest = slice(rest, taken.size() + 1, rest.size());
  return taken;
}

/// The first line of `rest`, without its end, `\n`, `\r` or both; `rest` goes on behind
/// it.
constexpr std::string_view take_line(std::string_view& rest) {
  const std::string_view line = slice(rest, 0, rest.find_first_of("\r\n"));
  const bool both = slice(rest, line.size(), 2) == "\r\n";
  rest = slice(rest, line.size() + (both ? 2 : 1), rest.size());
  return line;
}

/// Without blanks at both ends.
constexpr std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The number that the whole of `text` is, as std::from_chars takes it; nothing where it
/// is none, or beyond a Number. `base`: 16, say; of whole numbers.
template <class Number, class... Base>
[[nodiscard]] std::optional<Number> number_of(std::string_view text, Base... base) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value, base...);
  return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

}  // namespace wire
