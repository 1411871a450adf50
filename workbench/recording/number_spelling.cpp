#include "workbench/recording/number_spelling.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "workbench/recording/letters.hpp"
#include "workbench/recording/text_encoding.hpp"

namespace workbench {
namespace {

using namespace std::string_view_literals;

// No-break, thin, figure and full-width blanks; the first as Latin-1 has it, too.
constexpr std::array kBlanks = {" "sv,
                                "\t"sv,
                                "\xC2\xA0"sv,
                                "\xE2\x80\xAF"sv,
                                "\xE2\x80\x89"sv,
                                "\xE2\x80\x87"sv,
                                "\xE3\x80\x80"sv};

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

std::string_view without_blanks(std::string_view cell) {
  for (bool cut = true; cut;) {
    cut = false;
    for (const std::string_view blank : kBlanks) {
      if (cell.starts_with(blank)) {
        cell.remove_prefix(blank.size());
        cut = true;
      }
      if (cell.ends_with(blank)) {
        cell.remove_suffix(blank.size());
        cut = true;
      }
    }
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
