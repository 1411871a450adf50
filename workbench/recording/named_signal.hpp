// Columns or tags with their names, and which of them a given name means.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "workbench/recording/column_name.hpp"

namespace workbench {

/// A column or tag among which to choose.
struct NamedSignal {
  ColumnName name;
  std::size_t number = 0;  ///< as #3 counts, from 1
  std::size_t column = 1;  ///< place of the name in its line, in bytes
  bool measured = true;    ///< holds numbers, or nothing so far
  bool counts = false;     ///< rises evenly, as a time does
  double held = 0;         ///< share of values that are those before
  bool empty = false;      ///< no value in the rows that were looked at
};

/// Where the candidates come from, for messages.
struct ChoiceContext {
  const std::string& file;
  std::size_t header_line = 1;         ///< 0: tags of a long format
  const char* candidates = "columns";  ///< or "tags"
  std::string time_option = {};        ///< "--time \"#1\"": what the file needs as well
  std::string beside = {};             ///< what else is to be known of the candidates
};

/// The candidates that a name fits best, in their order: letter for letter, else without
/// regard to case, unit and the like, else less what all have in front, else by its last
/// pieces, else by any. Empty: none.
[[nodiscard]] std::vector<std::size_t> best_fitting(
    const ColumnName& wanted, const std::vector<NamedSignal>& candidates);

/// The candidate that a given name means. Throws std::invalid_argument.
[[nodiscard]] std::size_t candidate_named(const std::string& name, const char* option,
                                          const std::vector<NamedSignal>& candidates,
                                          const ChoiceContext& context);

/// Bytes that list_of() comes to, and names in a message.
inline constexpr std::size_t kLongestList = 600;

/// A name as it stands in a message: at most 60 bytes.
[[nodiscard]] std::string cut_name(const std::string& name);

/// "'FIC101.OP' 'FIC101.PV' and 12 more", at most about 600 bytes.
[[nodiscard]] std::string list_of(const std::vector<NamedSignal>& candidates);

/// The same in a message, and what else is to be known.
[[nodiscard]] std::string list_of(const std::vector<NamedSignal>& candidates,
                                  const ChoiceContext& context);

/// `name` as a shell takes it: in quotes where it must be.
[[nodiscard]] std::string shell_word(const std::string& name);

/// What an option calls a column: its name, cut, or else its number.
[[nodiscard]] std::string option_word(const std::string& name, std::size_t number);

}  // namespace workbench
