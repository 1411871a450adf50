#include "config/toml_mistake.hpp"

#include <algorithm>
#include <cctype>

#include "wire/text.hpp"

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
                     wire::is_digit) &&
         std::all_of(value.begin() + static_cast<std::ptrdiff_t>(comma) + 1, value.end(),
                     wire::is_digit);
}

bool is_text(std::string_view value) {
  return std::ranges::any_of(value, [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 ||
           static_cast<unsigned char>(c) >= 0x80;
  });
}

// What begins as that table or key in the line, if any does: `[name]`, `[[name]]`, `name
// =`.
bool names(std::string_view line, std::string_view name) {
  const auto drop = [&line](std::string_view those) {
    line.remove_prefix(std::min(line.find_first_not_of(those), line.size()));
  };
  drop(" \t[");
  if (!line.starts_with(name)) return false;
  line.remove_prefix(name.size());
  drop(" \t");
  return line.starts_with(']') || line.starts_with('=');
}

// The newest line above that gives the name; for a key only down from its table's head.
int line_above(std::string_view text, int line, std::string_view name, bool is_key) {
  for (int above = line - 1; above > 0; --above) {
    const std::string_view other = line_of(text, above);
    if (names(other, name)) return above;
    const std::size_t first = other.find_first_not_of(" \t");
    if (is_key && first != std::string_view::npos && other[first] == '[') break;
  }
  return 0;
}

// What stands twice, told by the parser as `… existing KIND 'NAME'`; empty: nothing does.
std::string told_twice(std::string_view text, int line, std::string_view said) {
  const std::size_t begin = said.find('\'');
  const std::size_t end = said.rfind('\'');
  if (said.find("redefine existing") == std::string_view::npos || begin == end) return {};
  const std::string name(said.substr(begin + 1, end - begin - 1));
  const bool is_key = said.find("table header") == std::string_view::npos;
  const int first = line_above(text, line, name, is_key);
  const std::string where = first > 0 ? ", first in line " + std::to_string(first) : "";
  if (said.find("array-of-tables") != std::string_view::npos) {
    return "expected [[" + name + "]] for each of its tables, found [" + name + "]" +
           where + "; write [[" + name + "]] there, too";
  }
  return "expected " + name + " once, found it twice" + where + "; remove one";
}

}  // namespace

std::string toml_mistake(std::string_view text, int line, std::string_view said) {
  if (std::string twice = told_twice(text, line, said); !twice.empty()) return twice;
  const std::string value(value_of(line_of(text, line)));
  if (is_decimal_comma(value)) {
    std::string point = value;
    std::ranges::replace(point, ',', '.');
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
