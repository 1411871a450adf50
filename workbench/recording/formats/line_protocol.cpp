#include "workbench/recording/formats/line_protocol.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

// Up to an unescaped `mark` outside of quotes; the text behind it is left in `rest`.
std::string_view take_up_to(char mark, bool quotes, std::string_view& rest) {
  bool quoted = false;
  std::size_t at = 0;
  for (; at < rest.size() && (quoted || rest[at] != mark); ++at) {
    if (rest[at] == '\\')
      ++at;
    else if (quotes && rest[at] == '"')
      quoted = !quoted;
  }
  const std::string_view out = rest.substr(0, at);
  rest.remove_prefix(std::min(at + 1, rest.size()));
  return out;
}

// Without what escapes or would break the cells of a table.
std::string plain(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size()) ++i;
    if (text[i] != '"') out += text[i] == '\t' ? ' ' : text[i];
  }
  return out;
}

// 45i and 45u are whole numbers.
std::string value_of(std::string_view text) {
  const bool whole = text.size() > 1 && (text.back() == 'i' || text.back() == 'u') &&
                     is_digit(text[text.size() - 2]);
  if (whole) text.remove_suffix(1);
  return plain(text);
}

struct Field {
  std::string name;
  std::string value;
};

struct Point {
  std::string series;
  std::vector<Field> fields;
  std::string_view stamp;
};

std::optional<Point> point_of(std::string_view line) {
  constexpr std::size_t kFewestDigits = 9;
  std::string_view rest = line;
  std::string_view key = take_up_to(' ', false, rest);
  std::string_view fields = take_up_to(' ', true, rest);
  Point out;
  out.stamp = trimmed(rest);
  if (out.stamp.size() < kFewestDigits || !std::ranges::all_of(out.stamp, is_digit)) {
    return std::nullopt;
  }
  out.series = plain(take_up_to(',', false, key));
  if (out.series.empty()) return std::nullopt;
  while (!key.empty()) {
    std::string_view tag = take_up_to(',', false, key);
    (void)take_up_to('=', false, tag);
    if (tag.empty()) return std::nullopt;
    out.series += '.' + plain(tag);
  }
  while (!fields.empty()) {
    std::string_view field = take_up_to(',', true, fields);
    const std::string name = plain(take_up_to('=', false, field));
    if (name.empty() || field.empty()) return std::nullopt;
    out.fields.push_back({name, value_of(field)});
  }
  return out.fields.empty() ? std::nullopt : std::optional(std::move(out));
}

}  // namespace

std::optional<std::string> line_protocol_text(std::string_view text,
                                              const std::string& file) {
  std::string out = "time\ttag\tvalue\n";
  bool begun = false;
  std::size_t number = 0;
  for (std::size_t at = 0; at < text.size(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    const std::string_view line = trimmed(text.substr(at, end - at));
    at = end + (text.substr(end).starts_with("\r\n") ? 2 : 1);
    if (line.empty() || line[0] == '#' || line.starts_with("CREATE DATABASE")) continue;
    const std::optional<Point> point = point_of(line);
    if (!point && !begun) return std::nullopt;
    if (!point && end == text.size()) break;
    if (!point) {
      throw InputError(file, number + 1, 1,
                       "a point of InfluxDB's line protocol with its time, as "
                       "loop,tag=a op=44.9 1773475200000000000",
                       quoted(line), "repair the line, or remove it");
    }
    begun = true;
    for (const Field& field : point->fields) {
      ((out += point->stamp) += '\t') += point->series;
      (((out += '.') += field.name) += '\t') += field.value;
      out += '\n';
    }
  }
  return begun ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace workbench
