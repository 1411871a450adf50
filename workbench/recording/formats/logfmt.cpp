#include "workbench/recording/formats/logfmt.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/formats/named_rows.hpp"
#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

constexpr std::size_t kSampleOfLines = 40;

// Up to a blank outside of quotes; none are left before the rest.
std::string_view take_word(std::string_view& rest) {
  bool quoted = false;
  std::size_t at = 0;
  for (; at < rest.size() && (quoted || (rest[at] != ' ' && rest[at] != '\t')); ++at) {
    if (rest[at] == '\\' && quoted) {
      ++at;
    } else if (rest[at] == '"') {
      quoted = !quoted;
    }
  }
  at = std::min(at, rest.size());
  const std::string_view word = rest.substr(0, at);
  rest = trimmed(rest.substr(at));
  return word;
}

bool may_be_in_name(char c) {
  return is_letter_byte(c) || is_digit(c) || std::string_view("_.-/:").find(c) < 5;
}

std::string_view name_in(std::string_view word) {
  const std::size_t end = word.find('=');
  if (end == std::string_view::npos || end == 0 || is_digit(word[0])) return {};
  const std::string_view name = word.substr(0, end);
  return std::ranges::all_of(name, may_be_in_name) ? name : std::string_view();
}

// "2026-03-04T06:00:01Z", "2026-03-04 06:00:01", in brackets, too; "": none leads.
std::string_view take_time(std::string_view& line) {
  std::string_view rest = line;
  const bool bracketed = rest.starts_with('[');
  if (bracketed) rest.remove_prefix(1);
  if (rest.empty() || !is_digit(rest[0])) return {};
  const std::string_view begin = rest;
  std::string_view word = take_word(rest);
  if (!rest.empty() && is_digit(rest[0])) {
    std::string_view behind = rest;
    const std::string_view clock = take_word(behind);
    if (clock.find(':') != std::string_view::npos) {
      word = begin.substr(
          0, static_cast<std::size_t>(clock.data() + clock.size() - begin.data()));
      rest = behind;
    }
  }
  if (bracketed && word.ends_with(']')) word.remove_suffix(1);
  line = rest;
  return word;
}

struct Pair {
  std::string_view name;
  std::string_view value;
};

struct LogLine {
  std::string_view time;
  std::vector<Pair> pairs;
  [[nodiscard]] bool holds_values() const {
    return pairs.size() > (time.empty() ? 1U : 0U);
  }
};

void read_line(std::string_view line, LogLine& out) {
  out.pairs.clear();
  out.time = take_time(line);
  while (!line.empty()) {
    const std::string_view word = take_word(line);
    const std::string_view name = name_in(word);
    if (!name.empty()) out.pairs.push_back({name, word.substr(name.size() + 1)});
  }
}

bool is_logfmt(std::string_view text) {
  std::size_t lines = 0;
  std::size_t good = 0;
  LogLine line;
  while (!text.empty() && lines < kSampleOfLines) {
    const std::string_view next = take_line(text);
    if (next.empty()) continue;
    read_line(next, line);
    ++lines;
    good += line.holds_values();
  }
  return good > 0 && 4 * good >= 3 * lines;
}

}  // namespace

std::optional<std::string> logfmt_text(std::string_view text) {
  if (text.find('=') == std::string_view::npos || !is_logfmt(text)) return std::nullopt;
  NamedRows rows;
  LogLine line;
  while (!text.empty()) {
    read_line(take_line(text), line);
    if (!line.holds_values()) continue;
    if (!line.time.empty()) rows.put("time", line.time);
    for (const Pair& pair : line.pairs) rows.put(pair.name, pair.value);
    rows.end_row();
  }
  return rows.is_full() ? std::nullopt : std::optional(rows.text());
}

}  // namespace workbench
