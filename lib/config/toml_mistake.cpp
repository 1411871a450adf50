#include "config/toml_mistake.hpp"

#include <algorithm>
#include <cctype>

namespace config {
namespace {

std::string_view line_of(std::string_view text, int line) {
  for (int k = 1; k < line; ++k) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// The single value behind `key =`; empty: there is none, or it begins as another thing.
std::string_view value_of(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return {};
  std::string_view value = line.substr(equals + 1);
  value = value.substr(0, value.find('#'));
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!value.empty() && is_blank(value.front())) value.remove_prefix(1);
  while (!value.empty() && is_blank(value.back())) value.remove_suffix(1);
  if (value.find_first_of("\"'[]{}") != std::string_view::npos) return {};
  return value;
}

bool is_decimal_comma(std::string_view value) {
  if (!value.empty() && (value[0] == '-' || value[0] == '+')) value.remove_prefix(1);
  const std::size_t comma = value.find(',');
  return comma != std::string_view::npos && comma > 0 && comma + 1 < value.size() &&
         std::all_of(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(comma),
                     is_digit) &&
         std::all_of(value.begin() + static_cast<std::ptrdiff_t>(comma) + 1, value.end(),
                     is_digit);
}

bool is_text(std::string_view value) {
  return std::any_of(value.begin(), value.end(), [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 ||
           static_cast<unsigned char>(c) >= 0x80;
  });
}

}  // namespace

std::string toml_mistake(std::string_view text, int line, std::string_view said) {
  const std::string value(value_of(line_of(text, line)));
  if (is_decimal_comma(value)) {
    std::string point = value;
    std::replace(point.begin(), point.end(), ',', '.');
    return "expected a number with a decimal point, found " + value + "; write " + point;
  }
  if (value == "True" || value == "False" || value == "TRUE" || value == "FALSE") {
    return "expected true or false in small letters, found " + value + "; write it small";
  }
  if (is_text(value)) {
    return "expected a number, true, false, or a text in quotes, found " + value +
           "; write a text as \"" + value + '"';
  }
  return "expected TOML, found " + std::string(said) + "; correct the line";
}

}  // namespace config
