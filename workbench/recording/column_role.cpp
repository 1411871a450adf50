// The bare names of the contract.
#include <array>
#include <utility>

#include "workbench/recording/column_name.hpp"
#include "workbench/recording/letters.hpp"

namespace workbench {

int role_of(std::string_view name) {
  const std::string lower = lower_case(name);
  constexpr std::array<std::pair<std::string_view, Column>, 9> kNames = {{
      {"t", Column::t},
      {"u", Column::u},
      {"op", Column::u},
      {"y", Column::y},
      {"pv", Column::y},
      {"sp", Column::sp},
      {"x", Column::x},
      {"mv", Column::x},
      {"pos", Column::x},
  }};
  for (const auto& [known, column] : kNames) {
    if (lower == known) return static_cast<int>(column);
  }
  return kIgnoredColumn;
}

std::string with_aliases(Column column) {
  switch (column) {
    case Column::u:
      return "a column u (or OP)";
    case Column::y:
      return "a column y (or PV)";
    case Column::x:
      return "a column x (or MV, POS)";
    case Column::sp:
      return "a column sp";
    case Column::t:
      break;
  }
  return "a column t (time in seconds)";
}

}  // namespace workbench
