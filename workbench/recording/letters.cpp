#include "workbench/recording/letters.hpp"

#include <cstdint>

#include "workbench/recording/text_encoding.hpp"

namespace workbench {
namespace {

// Of U+00C0 to U+017F; '?': none.
constexpr std::string_view kLatin =
    "aaaaaa?ceeeeiiiidnooooo?ouuuuyt?aaaaaa?ceeeeiiiidnooooo?ouuuuyty"
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkklllllll"
    "lllnnnnnnnnnoooooo??rrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
constexpr std::uint32_t kLatinFirst = 0xC0;

std::uint32_t code_at(std::string_view text, std::size_t at, std::size_t length) {
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(text[at + i]));
  };
  if (length == 2) return (byte(0) & 0x1F) << 6 | (byte(1) & 0x3F);
  if (length == 3) {
    return (byte(0) & 0x0F) << 12 | (byte(1) & 0x3F) << 6 | (byte(2) & 0x3F);
  }
  return 0;
}

// Small Cyrillic letters; 0: the code is no letter to change.
std::uint32_t small_cyrillic(std::uint32_t code) {
  constexpr std::uint32_t kYo = 0x451;
  constexpr std::uint32_t kYe = 0x435;
  if (code == 0x401 || code == kYo) return kYe;
  if (code >= 0x410 && code < 0x430) return code + 0x20;
  return code >= 0x402 && code < 0x410 ? code + 0x50 : 0;
}

}  // namespace

std::string folded(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    const std::uint32_t code = code_at(text, at, length);
    const std::string_view bytes = text.substr(at, length == 0 ? 1 : length);
    at += bytes.size();
    if (code == 0xDF) {
      out += "ss";
    } else if (code == 0xC6 || code == 0xE6) {
      out += "ae";
    } else if (code >= kLatinFirst && code < kLatinFirst + kLatin.size() &&
               kLatin[code - kLatinFirst] != '?') {
      out += kLatin[code - kLatinFirst];
    } else if (code >= 0x218 && code <= 0x21B) {  // Romanian
      out += code < 0x21A ? 's' : 't';
    } else if (const std::uint32_t small = small_cyrillic(code); small != 0) {
      out += static_cast<char>(0xC0 | small >> 6);
      out += static_cast<char>(0x80 | (small & 0x3F));
    } else {
      const bool wide = code >= 0xFF01 && code <= 0xFF5E;
      const char c = wide ? static_cast<char>(code - 0xFEE0) : bytes[0];
      if (wide || bytes.size() == 1) {
        out += lower_case(c);
      } else {
        out += bytes;
      }
    }
  }
  return out;
}

}  // namespace workbench
