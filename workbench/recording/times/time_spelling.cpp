#include "workbench/recording/times/time_spelling.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <utility>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

// Beginnings, of which a longer one stands before the shorter; letters of UTF-8 folded.
// English, German, French, Spanish, Italian, Portuguese, Dutch, Swedish, Polish, Turkish,
// Finnish, Russian.
constexpr auto kMonths = std::to_array<std::pair<std::string_view, int>>({
    {"marras", 11}, {"jan", 1},   {"j\xE4n", 1}, {"gen", 1},   {"ene", 1},    {"sty", 1},
    {"oca", 1},     {"tammi", 1}, {"янв", 1},    {"feb", 2},   {"fev", 2},    {"lut", 2},
    {"sub", 2},     {"helmi", 2}, {"фев", 2},    {"mar", 3},   {"m\xE4r", 3}, {"mrz", 3},
    {"mrt", 3},     {"maer", 3},  {"maalis", 3}, {"мар", 3},   {"apr", 4},    {"avr", 4},
    {"abr", 4},     {"kwi", 4},   {"nis", 4},    {"huhti", 4}, {"апр", 4},    {"may", 5},
    {"mai", 5},     {"maj", 5},   {"mag", 5},    {"mei", 5},   {"touko", 5},  {"мая", 5},
    {"май", 5},     {"jun", 6},   {"juin", 6},   {"giu", 6},   {"cze", 6},    {"haz", 6},
    {"kesa", 6},    {"июн", 6},   {"jul", 7},    {"juil", 7},  {"lug", 7},    {"lip", 7},
    {"tem", 7},     {"heina", 7}, {"июл", 7},    {"aug", 8},   {"aou", 8},    {"ago", 8},
    {"sie", 8},     {"elo", 8},   {"авг", 8},    {"sep", 9},   {"set", 9},    {"wrz", 9},
    {"eyl", 9},     {"syys", 9},  {"сен", 9},    {"oct", 10},  {"okt", 10},   {"ott", 10},
    {"out", 10},    {"paz", 10},  {"eki", 10},   {"loka", 10}, {"окт", 10},   {"nov", 11},
    {"lis", 11},    {"kas", 11},  {"ноя", 11},   {"dec", 12},  {"dez", 12},   {"dic", 12},
    {"gru", 12},    {"ara", 12},  {"joulu", 12}, {"дек", 12},
});

using Spelling = std::pair<std::string_view, std::string_view>;

constexpr auto kMarks = std::to_array<Spelling>({{"年|月|년|월", "-"},
                                                 {"日|일|\xC2\xA0|\xE2\x80\xAF", " "},
                                                 {"時|时|点|分|시|분", ":"},
                                                 {"秒|초", ""}});

constexpr auto kHalves = std::to_array<Spelling>(
    {{"午前|上午|오전|a. m.|a. m", "AM"}, {"午後|下午|오후|p. m.|p. m", "PM"}});

// Between a date and its time of day.
constexpr std::string_view kBetween = " kl. | kl | klo | um | at | à | г.,| г. ";

// Of each of the words, in their order.
bool replace(std::string& text, std::string_view words, std::string_view to) {
  bool found = false;
  for_each_word(words, [&](std::string_view from) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size())) {
      text.replace(at, from.size(), to);
      found = true;
    }
  });
  return found;
}

// 8.00.00, 08.00.00.250
bool is_dotted_clock(std::string_view word) {
  std::size_t at = 0;
  for (int part = 0; part < 3; ++part) {
    std::size_t digits = 0;
    while (at < word.size() && is_digit(word[at])) {
      ++at;
      ++digits;
    }
    if (digits > 2 || digits < (part == 0 ? 1U : 2U)) return false;
    if (part == 2) break;
    if (at >= word.size() || word[at++] != '.') return false;
  }
  return at == word.size() ||
         ((word[at] == '.' || word[at] == ',') && at + 1 < word.size() &&
          std::all_of(word.begin() + static_cast<std::ptrdiff_t>(at) + 1, word.end(),
                      is_digit));
}

// Japanese eras by the year before their first.
constexpr auto kEras = std::to_array<std::pair<std::string_view, int>>({
    {"令和", 2018},
    {"平成", 1988},
    {"昭和", 1925},
    {"R", 2018},
    {"H", 1988},
    {"S", 1925},
});

// R8/11/27, 令和8年11月27日 and 令和元年5月1日 with the year of the common era.
void mark_era(std::string& text) {
  constexpr std::string_view kFirst = "元";
  for (const auto& [era, before] : kEras) {
    if (!text.starts_with(era)) continue;
    std::size_t at = era.size();
    int year = 0;
    if (std::string_view(text).substr(at).starts_with(kFirst)) {
      year = 1;
      at += kFirst.size();
    }
    for (; year < 10 && at < text.size() && is_digit(text[at]); ++at) {
      year = 10 * year + (text[at] - '0');
    }
    const std::string_view rest = std::string_view(text).substr(at);
    const bool dated = rest.starts_with("年") || rest.starts_with('/') ||
                       rest.starts_with('.') || rest.starts_with('-');
    if (year > 0 && dated) text = std::to_string(before + year) + std::string(rest);
    return;
  }
}

// The second word of the text, where it is a clock with dots.
void mark_clock(std::string& text) {
  const std::size_t begin = text.find(' ');
  if (begin == std::string::npos) return;
  const std::size_t end = std::min(text.find(' ', begin + 1), text.size());
  if (!is_dotted_clock(std::string_view(text).substr(begin + 1, end - begin - 1))) return;
  std::size_t dot = text.find('.', begin);
  text[dot] = ':';
  dot = text.find('.', dot);
  text[dot] = ':';
}

// 1h2m3s400ms and 1h 2m 3.5s from the largest unit to the least, as 1:02:03.400000.
std::optional<std::string> clock_of_units(std::string_view text, std::size_t fewest) {
  constexpr auto kUnits =
      std::to_array<std::pair<std::string_view, double>>({{"d", 86400},
                                                          {"h", 3600},
                                                          {"ms", 1e-3},
                                                          {"us", 1e-6},
                                                          {"ns", 1e-9},
                                                          {"m", 60},
                                                          {"s", 1}});
  double seconds = 0;
  double before = std::numeric_limits<double>::infinity();
  std::size_t units = 0;
  while (!text.empty()) {
    double count = 0;
    const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(),
                                                count, std::chars_format::fixed);
    if (status != std::errc{} || !is_digit(text[0])) return std::nullopt;
    text = trimmed(text.substr(static_cast<std::size_t>(stop - text.data())));
    const auto* const unit = std::ranges::find_if(
        kUnits, [text](const auto& u) { return text.starts_with(u.first); });
    if (unit == kUnits.end() || unit->second >= before) return std::nullopt;
    seconds += count * unit->second;
    before = unit->second;
    ++units;
    text = text.substr(unit->first.size());
    while (!text.empty() && (text[0] == ' ' || text[0] == '_')) text.remove_prefix(1);
  }
  constexpr double kLongestS = 3.6e6;
  if (units < fewest || seconds >= kLongestS) return std::nullopt;
  const auto micros = static_cast<std::int64_t>(std::llround(seconds * 1e6));
  constexpr std::int64_t kSecond = 1'000'000;
  std::array<char, 32> out{};
  std::snprintf(out.data(), out.size(), "%d:%02d:%02d.%06d",
                static_cast<int>(micros / (3600 * kSecond)),
                static_cast<int>(micros / (60 * kSecond) % 60),
                static_cast<int>(micros / kSecond % 60),
                static_cast<int>(micros % kSecond));
  return out.data();
}

// Literals of IEC 61131-3: T#1h2m3s, TOD#14:30:00, DT#2026-05-13-14:30:00, D#2026-05-13.
std::optional<std::string> literal(std::string_view cell) {
  const std::size_t mark = cell.find('#');
  if (mark == std::string_view::npos) {
    const bool may_be = cell.size() >= 4 && is_digit(cell[0]) &&
                        (cell.back() == 's' || cell.back() == 'm');
    return may_be ? clock_of_units(cell, 2) : std::nullopt;
  }
  std::string kind = lower_case(cell.substr(0, mark));
  if (kind.starts_with('l')) kind.erase(0, 1);
  std::string rest = lower_case(cell.substr(mark + 1));
  if (kind == "t" || kind == "time") return clock_of_units(rest, 1);
  if (kind == "tod" || kind == "time_of_day" || kind == "d" || kind == "date")
    return rest;
  constexpr std::size_t kDate = 10;  // characters
  if ((kind != "dt" && kind != "date_and_time") || rest.size() < kDate + 1)
    return std::nullopt;
  if (rest[kDate] == '-') rest[kDate] = ' ';
  return rest;
}

}  // namespace

int month_named(std::string_view lower) {
  const std::string plain = folded(lower);
  for (const auto& [name, month] : kMonths) {
    if (plain.starts_with(name)) return month;
  }
  return 0;
}

bool is_weekday(std::string_view lower) {
  constexpr std::string_view kShort =
      "mo|mon|tue|tues|wed|thu|thur|thurs|fri|sat|sun|di|mi|do|fr|sa|so";
  if (is_one_of(lower, kShort)) return true;
  return lower.size() > 4 && (lower.ends_with("day") || lower.ends_with("tag") ||
                              lower == "mittwoch" || lower == "sonnabend");
}

std::optional<std::string> dotted_clock(std::string_view cell) {
  if (!is_dotted_clock(cell)) return std::nullopt;
  std::string text(cell);
  const std::size_t first = text.find('.');
  const std::size_t second = text.find('.', first + 1);
  const auto below = [&text](std::size_t from, std::size_t to, int limit) {
    return std::stoi(text.substr(from, to - from)) < limit;
  };
  if (!below(0, first, 24) || !below(first + 1, second, 60) ||
      !below(second + 1, second + 3, 60)) {
    return std::nullopt;
  }
  text[first] = text[second] = ':';
  return text;
}

std::optional<std::string> plain_time(std::string_view cell) {
  constexpr std::size_t kLongest = 64;
  if (cell.size() > kLongest) return std::nullopt;
  if (auto known = literal(cell)) return known;
  const bool may_be = cell.size() >= 6 && std::ranges::count_if(cell, is_digit) >= 3;
  if (!may_be) return std::nullopt;
  std::string text(cell);
  mark_era(text);
  bool marked = false;
  for (const auto& [marks, to] : kMarks) marked = replace(text, marks, to) || marked;
  std::string_view half;
  for (const auto& [words, to] : kHalves) {
    if (replace(text, words, "")) half = to;
  }
  replace(text, kBetween, " ");
  while (replace(text, "  ", " ")) continue;
  if (marked) {
    replace(text, "- ", "-");
    replace(text, ": ", ":");
  }
  text = trimmed(text);
  if (text.ends_with(':')) text.pop_back();
  mark_clock(text);
  if (!half.empty()) text += ' ' + std::string(half);
  return text == cell ? std::nullopt : std::optional(std::move(text));
}

}  // namespace workbench
