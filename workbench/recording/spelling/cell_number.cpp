#include "workbench/recording/spelling/cell_number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>

#include "workbench/recording/letters.hpp"
#include "workbench/recording/text_encoding.hpp"

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

// No-break, thin, figure and full-width blanks; the first as Latin-1 has it, too.
constexpr std::string_view kBlanks =
    " |\t|\xC2\xA0|\xE2\x80\xAF|\xE2\x80\x89|\xE2\x80\x87|\xE3\x80\x80";

constexpr std::array<std::pair<std::string_view, char>, 7> kLetters = {{
    {"\xE2\x88\x92", '-'},  // U+2212, the minus sign
    {"\xE2\x80\x93", '-'},
    {"\xEF\xBC\x8D", '-'},
    {"\xEF\xBC\x8B", '+'},
    {"\xEF\xBC\x8E", '.'},
    {"\xEF\xBC\x8C", ','},
    {"\xD9\xAB", '.'},
}};

// The ASCII letter that the bytes at the front mean; 0: none.
char letter_of(std::string_view bytes) {
  for (const auto& [from, to] : kLetters) {
    if (bytes == from) return to;
  }
  const auto byte = [bytes](std::size_t i) {
    return static_cast<unsigned char>(bytes[i]);
  };
  int digit = -1;
  if (bytes.size() == 3 && bytes.starts_with("\xEF\xBC")) digit = byte(2) - 0x90;
  if (bytes.size() == 2 && byte(0) == 0xD9) digit = byte(1) - 0xA0;
  if (bytes.size() == 2 && byte(0) == 0xDB) digit = byte(1) - 0xB0;
  return digit >= 0 && digit < 10 ? static_cast<char>('0' + digit) : '\0';
}

std::string_view without_text_marks(std::string_view cell) {
  if (cell.starts_with("=\"") && cell.ends_with('"') && cell.size() > 3) {
    return cell.substr(2, cell.size() - 3);
  }
  if (cell.starts_with("=\"\"") && cell.ends_with("\"\"") && cell.size() > 5) {
    return cell.substr(3, cell.size() - 5);
  }
  return cell.size() > 1 && cell[0] == '\'' ? cell.substr(1) : cell;
}

// 1,23,45,678.9, the digits in groups of two before the last three, in groups of three:
// 012,345,678.9, at least two marks, so that they cannot be decimals.
std::optional<std::string> in_threes(std::string_view text) {
  const std::size_t begin = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  const std::size_t end = std::min(text.find('.'), text.size());
  const std::string_view whole = text.substr(begin, end - std::min(begin, end));
  constexpr std::size_t kLast = 4;  // a mark and three digits
  if (whole.size() < kLast + 4 || whole[whole.size() - kLast] != ',') return std::nullopt;
  std::string digits;
  std::size_t run = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (is_digit(whole[i])) {
      digits += whole[i];
      ++run;
      continue;
    }
    const bool first = digits.size() == run;
    if (whole[i] != ',' || run > 2 || run < (first ? 1U : 2U)) return std::nullopt;
    run = 0;
  }
  if (run != 3) return std::nullopt;
  constexpr std::size_t kFewest = 9;
  digits.insert(0, std::max(kFewest, (digits.size() + 2) / 3 * 3) - digits.size(), '0');
  std::string out(text.substr(0, begin));
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && i % 3 == 0) out += ',';
    out += digits[i];
  }
  return out + std::string(text.substr(end));
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

std::string_view without_blanks(std::string_view cell) {
  for (bool cut = true; cut;) {
    cut = false;
    for_each_word(kBlanks, [&](std::string_view blank) {
      if (cell.starts_with(blank)) {
        cell.remove_prefix(blank.size());
        cut = true;
      }
      if (cell.ends_with(blank)) {
        cell.remove_suffix(blank.size());
        cut = true;
      }
    });
  }
  return cell;
}

std::optional<std::string> plain_number(std::string_view cell) {
  const std::string_view text = without_blanks(without_text_marks(without_blanks(cell)));
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    const std::string_view bytes = text.substr(at, length == 0 ? 1 : length);
    at += bytes.size();
    const char letter = bytes.size() > 1 ? letter_of(bytes) : '\0';
    const bool exponent = (bytes == "D" || bytes == "d") && !out.empty() &&
                          (is_digit(out.back()) || out.back() == '.') && at < text.size();
    if (exponent) {
      out += 'E';
    } else if (letter != 0) {
      out += letter;
    } else {
      out += bytes;
    }
  }
  // +  52.624: a sign at the left edge of its column.
  const std::size_t digits = out.find_first_not_of(' ', 1);
  const bool apart = out.size() > 1 && (out[0] == '+' || out[0] == '-') &&
                     out[1] == ' ' && digits != std::string::npos &&
                     is_digit(out[digits]);
  if (apart) out.erase(1, digits - 1);
  if (out.size() > 1 && out.back() == '-' && is_digit(out[out.size() - 2])) {
    out.pop_back();
    out.insert(out.begin(), '-');
  }
  if (std::optional<std::string> threes = in_threes(out)) return threes;
  return out == cell ? std::nullopt : std::optional(std::move(out));
}

}  // namespace workbench
