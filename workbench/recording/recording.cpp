#include "workbench/recording/recording.hpp"

namespace workbench {

std::string_view name_of(Column column) {
  switch (column) {
    case Column::t:
      return "t";
    case Column::u:
      return "u";
    case Column::y:
      return "y";
    case Column::sp:
      return "sp";
    case Column::x:
      return "x";
  }
  return "?";
}

const std::vector<double>& Recording::values(Column column) const {
  return of_column(column, t, u, y, sp, x);
}

std::vector<double>& Recording::values(Column column) {
  return const_cast<std::vector<double>&>(  // NOLINT: *this is not const here
      static_cast<const Recording*>(this)->values(column));
}

}  // namespace workbench
