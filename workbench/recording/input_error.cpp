#include "workbench/recording/input_error.hpp"

#include <utility>

#include "workbench/recording/text_encoding.hpp"

namespace workbench {
namespace {

std::string printable(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    out += byte < 0x20 || byte == 0x7F ? '?' : c;
  }
  return out;
}

std::string message(const std::string& file, std::size_t line, std::size_t column,
                    const std::string& expected, const std::string& found,
                    const std::string& advice) {
  std::string text = file;
  if (line > 0) {
    text += ':' + std::to_string(line);
    if (column > 0) text += ':' + std::to_string(column);
  }
  return printable(text + ": expected " + expected + ", found " + found + "; " + advice);
}

}  // namespace

InputError::InputError(std::string file_name, std::size_t line_number,
                       std::size_t column_number, std::string what_was_expected,
                       std::string what_was_found, std::string what_to_do)
    : std::runtime_error(message(file_name, line_number, column_number, what_was_expected,
                                 what_was_found, what_to_do)),
      file(std::move(file_name)),
      line(line_number),
      column(column_number),
      expected(std::move(what_was_expected)),
      found(std::move(what_was_found)),
      advice(std::move(what_to_do)) {}

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string out = "'";
  std::size_t at = 0;
  while (at < text.size() && at < kLongest) {
    const auto byte = static_cast<unsigned char>(text[at]);
    const std::size_t length = utf8_length(text, at);
    if (byte < 0x20 || byte == 0x7F || length == 0) {
      out += '?';
      ++at;
    } else {
      out += text.substr(at, length);
      at += length;
    }
  }
  return out + (at < text.size() ? "…'" : "'");
}

}  // namespace workbench
