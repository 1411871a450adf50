// The first line of a CSV file: cells, and the columns that their names mean.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

inline constexpr std::size_t kMostHeaderCells = 4096;
inline constexpr int kIgnoredColumn = -1;

/// Without blanks and tabs at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The Column that a name means, aliases included, as a number; or kIgnoredColumn.
[[nodiscard]] int role_of(std::string_view name);

/// "a column u (or OP)", for messages.
[[nodiscard]] std::string with_aliases(Column column);

struct HeaderCell {
  std::string name;
  std::size_t column;  ///< in bytes, from 1
};

/// Splits one line; a quoted cell may contain the separator. At most kMostHeaderCells
/// + 1.
[[nodiscard]] std::vector<HeaderCell> split_header(std::string_view line, char separator);

}  // namespace workbench
