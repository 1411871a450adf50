#include "config/loop_tag.hpp"

#include <algorithm>

namespace config {
namespace {

bool is_plain(char c) {
  return c > ' ' && c <= '~' && c != '"';
}

// The character that begins there, UTF-8, in words where it cannot be seen.
std::string character_at(const std::string& text, std::size_t at) {
  if (text[at] == ' ') return "a blank";
  if (text[at] == '"') return "a quote";
  const auto code = static_cast<unsigned char>(text[at]);
  if (code < 0x80) return "a control character";
  std::size_t end = at + 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) {
    ++end;
  }
  return '"' + text.substr(at, end - at) + '"';
}

}  // namespace

std::string problem_of_tag(const std::string& tag) {
  const auto odd = std::ranges::find_if_not(tag, is_plain);
  if (odd != tag.end()) {
    const auto at = static_cast<std::size_t>(odd - tag.begin());
    return "expected ASCII characters without blanks and quotes, found " +
           character_at(tag, at) + " in \"" + tag + "\"; leave it out, or write - or _";
  }
  if (tag.size() > kMostTagBytes) {
    return "expected up to " + std::to_string(kMostTagBytes) + " characters, found " +
           std::to_string(tag.size()) + " in \"" + tag + "\"; shorten the tag";
  }
  return {};
}

}  // namespace config
