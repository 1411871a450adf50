#include "workbench/recording/cell_number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>

#include "workbench/recording/letters.hpp"
#include "workbench/recording/number_spelling.hpp"

namespace workbench {
namespace {

constexpr std::size_t kLongestNumber = 64;

std::string_view without_plus(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  return text;
}

NumberReader::Result parse(std::string_view text, double& value) {
  const auto [stop, status] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (status == std::errc::invalid_argument || stop != text.data() + text.size()) {
    return NumberReader::Result::kText;
  }
  return status != std::errc{} || !std::isfinite(value) ? NumberReader::Result::kNotFinite
                                                        : NumberReader::Result::kOk;
}

// A number taken apart: at most one decimal mark, digits grouped in threes before it.
struct Marks {
  std::array<char, kLongestNumber> plain{};  // with a point, without groups
  std::size_t length = 0;
  char decimal = 0;           // the last mark, if it may be one
  char group = 0;             // what stood between groups; 0: none
  bool single_three = false;  // one mark only, with three digits behind it and one to
                              // three, the first no zero, before it: either reading
  [[nodiscard]] std::string_view text() const { return {plain.data(), length}; }
};

// The length of a blank that groups digits: ' ', NBSP or narrow NBSP in UTF-8, NBSP in
// Latin-1, '\''; 0: none.
std::size_t blank_group(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  if (rest[0] == ' ' || rest[0] == '\'' || rest[0] == '\xA0') return 1;
  if (rest.starts_with("\xC2\xA0")) return 2;
  if (rest.starts_with("\xE2\x80\xAF") || rest.starts_with("\xE2\x80\x99")) return 3;
  return 0;
}

// The digits and marks at the front of a number; an exponent may follow.
struct MarkedDigits {
  std::size_t end = 0;
  std::size_t last_mark = std::string_view::npos;
  std::size_t marks = 0;     // points and commas
  bool has_decimal = false;  // the last mark is the decimal one
};

MarkedDigits marked_digits(std::string_view text, std::size_t at) {
  MarkedDigits out{.end = at};
  std::array<bool, 2> seen{};
  while (out.end < text.size()) {
    const char c = text[out.end];
    if (c == '.' || c == ',') {
      out.last_mark = out.end;
      ++out.marks;
      seen[c == ',' ? 1 : 0] = true;
      ++out.end;
    } else if (is_digit(c)) {
      ++out.end;
    } else if (const std::size_t blank = blank_group(text, out.end); blank > 0) {
      out.end += blank;
    } else {
      break;
    }
  }
  const bool both = seen[0] && seen[1];
  // Two equal marks are groups; of two kinds the last one is the decimal mark.
  out.has_decimal = both || out.marks == 1;
  return out;
}

bool take_apart(std::string_view text, Marks& out) {
  text = without_plus(text);
  if (text.size() > kLongestNumber || text.empty()) return false;
  std::size_t at = text[0] == '-' ? 1 : 0;
  const MarkedDigits front = marked_digits(text, at);
  out.decimal = front.has_decimal ? text[front.last_mark] : 0;
  std::size_t run = 0;    // digits since the last group mark
  std::size_t whole = 0;  // groups closed
  std::size_t fraction = 0;
  bool in_fraction = false;
  const auto add = [&out](char c) { out.plain[out.length++] = c; };
  if (at == 1) add('-');
  const char first_digit = at < text.size() ? text[at] : 0;
  while (at < front.end) {
    const char c = text[at];
    if (is_digit(c)) {
      add(c);
      in_fraction ? ++fraction : ++run;
      ++at;
      continue;
    }
    if (front.has_decimal && at == front.last_mark) {
      if (whole > 0 && run != 3) return false;
      in_fraction = true;
      add('.');
      ++at;
      continue;
    }
    const std::size_t length = c == '.' || c == ',' ? 1 : blank_group(text, at);
    const char mark = c == '.' || c == ',' ? c : ' ';
    if (in_fraction || (out.group != 0 && out.group != mark)) return false;
    if (whole == 0 ? run < 1 || run > 3 : run != 3) return false;
    out.group = mark;
    ++whole;
    run = 0;
    at += length;
  }
  if (!in_fraction && whole > 0 && run != 3) return false;
  if (run + fraction == 0 && whole == 0) return false;
  out.single_three = front.marks == 1 && whole == 0 && fraction == 3 && run >= 1 &&
                     run <= 3 && first_digit != '0' && front.end == text.size();
  for (; at < text.size(); ++at) add(text[at]);
  double ignored = 0;
  return parse(out.text(), ignored) != NumberReader::Result::kText &&
         (out.length == 0 || out.plain[out.length - 1] != ' ');
}

}  // namespace

bool NumberEvidence::add(std::string_view cell) {
  Marks marks;
  if (cell.empty()) return false;
  if (!take_apart(cell, marks)) {
    const std::optional<std::string> plain = plain_number(cell);
    marks = {};
    if (!plain || !take_apart(*plain, marks)) return false;
  }
  if (marks.group == '.' || (marks.group != 0 && marks.decimal == ',')) {
    decimal_comma_ = true;
  }
  if (marks.group == ',' || (marks.group != 0 && marks.decimal == '.')) {
    decimal_point_ = true;
  }
  grouped_ = grouped_ || marks.group == '.' || marks.group == ',';
  if (marks.group == 0 && !marks.single_three) {
    decimal_point_ = decimal_point_ || marks.decimal == '.';
    decimal_comma_ = decimal_comma_ || marks.decimal == ',';
  }
  return true;
}

NumberStyle NumberEvidence::style() const {
  NumberStyle style;
  if (decimal_point_ != decimal_comma_) style.decimal = decimal_comma_ ? ',' : '.';
  style.grouped = grouped_ && style.decimal != 0;
  return style;
}

NumberReader::Result NumberReader::read(std::string_view cell, double& value) {
  const Result result = read_as_it_is(cell, value);
  if (result != Result::kText || plain_) return result;
  const std::optional<std::string> plain = plain_number(cell);
  return plain ? read_as_it_is(*plain, value) : result;
}

NumberReader::Result NumberReader::read_as_it_is(std::string_view cell, double& value) {
  cell = without_plus(cell);
  const bool commas = cell.find(',') != std::string_view::npos;
  if (!commas && (plain_ || !style_.grouped)) {
    const Result result = parse(cell, value);
    if (result != Result::kText || plain_) {
      if (result != Result::kOk) return result;
      const bool point = cell.find('.') != std::string_view::npos;
      return point && (separator_ != ',' || !plain_) ? accept('.') : Result::kOk;
    }
  }
  return read_marked(cell, value);
}

NumberReader::Result NumberReader::read_marked(std::string_view cell, double& value) {
  if (plain_ && separator_ == ',') return Result::kText;
  Marks marks;
  if (!take_apart(cell, marks)) return Result::kText;
  if (plain_ && (marks.group != 0 || marks.decimal != ',')) return Result::kText;
  if (marks.single_three && !plain_) {
    if (separator_ == ',' && marks.decimal == ',' && style_.decimal == 0) {
      return Result::kUnclear;
    }
    const bool is_group = style_.decimal != 0 && marks.decimal != style_.decimal &&
                          (style_.grouped || separator_ == ',');
    if (is_group) {
      const auto mark =
          std::find(marks.plain.begin(), marks.plain.begin() + marks.length, '.');
      std::copy(mark + 1, marks.plain.begin() + marks.length, mark);
      --marks.length;
      marks.decimal = 0;
    }
  }
  const Result result = parse(marks.text(), value);
  if (result != Result::kOk) return result;
  const char decimal = marks.decimal != 0   ? marks.decimal
                       : marks.group == ',' ? '.'
                       : marks.group == '.' ? ','
                                            : '\0';
  return decimal == 0 ? Result::kOk : accept(decimal);
}

NumberReader::Result NumberReader::accept(char decimal) {
  if (style_.given && decimal != style_.decimal) return Result::kMixedMarks;
  (decimal == ',' ? commas_ : points_) = true;
  return points_ && commas_ ? Result::kMixedMarks : Result::kOk;
}

std::optional<double> as_number(std::string_view cell) {
  double value = 0;
  const auto [stop, status] =
      std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool whole = status == std::errc{} && stop == cell.data() + cell.size();
  return whole ? std::optional(value) : std::nullopt;
}

}  // namespace workbench
