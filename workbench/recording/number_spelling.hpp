// Numbers in other letters than those of programs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// A cell of a number in the letters that programs read: without no-break and thin blanks
/// around it; U+2212, a dash or a minus behind (44.9-, as SAP writes) as '-' in front;
/// full-width and Arabic digits and marks as ASCII; D in the exponent as E; without the
/// apostrophe in front or ="" around by which spreadsheets keep text; 1,23,456.7, as
/// India groups digits, in groups of three. Nothing: the cell needs none of this.
[[nodiscard]] std::optional<std::string> plain_number(std::string_view cell);

/// Without blanks around it, no-break and thin ones included.
[[nodiscard]] std::string_view without_blanks(std::string_view cell);

}  // namespace workbench
