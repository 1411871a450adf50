// Strokes in the words of the valve, where it is known which way a higher output moves
// it.
#pragma once

#include <string>
#include <string_view>

#include "workbench/serve/session.hpp"

namespace workbench {

/// HTML of the report or of a part of it, with its bands, jumps and reasons of one stroke
/// named as the page names them: of opening and closing, or as it stands where `opens` is
/// unknown.
[[nodiscard]] std::string in_direction_words(std::string_view html, Opens opens);

}  // namespace workbench
