// Letters and digits of ASCII, whatever the locale says.
#pragma once

#include <string>
#include <string_view>

#include "wire/text.hpp"

namespace workbench {

using wire::is_digit;

/// The text with small letters; bytes beyond ASCII stay. Never fails.
[[nodiscard]] inline std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return out;
}

}  // namespace workbench
