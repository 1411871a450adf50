// What usually is meant by a line that is no TOML.
#pragma once

#include <string>
#include <string_view>

namespace config {

/// Of a text that the parser gave up at `line` (from 1), with what it said then:
/// `expected …, found …; do …`. A decimal comma and a text without quotes are named.
[[nodiscard]] std::string toml_mistake(std::string_view text, int line,
                                       std::string_view said);

}  // namespace config
