#include "workbench/recording/remark_line.hpp"

#include <algorithm>
#include <string>

#include "workbench/recording/cell_number.hpp"
#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

constexpr std::string_view kSummaries =
    "average|avg|avg.|mean|min|min.|minimum|max|max.|maximum|sum|total|totals|subtotal|"
    "count|std|std dev|stddev|stdev|median|range|mittelwert|summe|anzahl|durchschnitt|"
    "moyenne|somme|promedio|suma|media|totale|gemiddelde";

bool begins_as_number(std::string_view cell) {
  const std::size_t at = cell.find_first_not_of("+-.,( ");
  return at != std::string_view::npos && is_digit(cell[at]);
}

bool has_letters(std::string_view cell) {
  return std::ranges::any_of(cell, is_letter_byte);
}

bool is_summary(std::string_view cell) {
  if (cell.ends_with(':')) cell.remove_suffix(1);
  return is_one_of(lower_case(trimmed(cell)), kSummaries);
}

bool begins_with_mark(std::string_view cell) {
  constexpr std::size_t kFewest = 2;
  if (cell.size() < kFewest) return false;
  return cell[0] == '#' ||
         (std::string_view("-*=_").find(cell[0]) != std::string_view::npos &&
          cell[1] == cell[0]);
}

bool is_name(std::string_view cell, const CsvLayout& layout) {
  cell = trimmed(cell.substr(std::min(cell.find_first_not_of("# "), cell.size())));
  return !cell.empty() &&
         std::ranges::any_of(layout.columns, [cell](const LayoutColumn& column) {
           return column.name.text == cell;
         });
}

// A unit that no column has: what follows is measured otherwise.
bool is_other_unit(std::string_view cell, const CsvLayout& layout) {
  if (cell.empty() || !is_unit(without_brackets(cell))) return false;
  const std::string unit =
      column_name("x [" + std::string(without_brackets(cell)) + ']').unit;
  return std::ranges::none_of(layout.columns, [&unit](const LayoutColumn& column) {
    return column.name.unit == unit;
  });
}

}  // namespace

bool is_remark(std::span<const std::string_view> cells, std::string_view first,
               const CsvLayout& layout, bool behind_head) {
  if (cells.empty() || first.empty()) return false;
  const auto speaks_of_columns = [&layout](std::string_view cell) {
    return is_name(cell, layout) || is_other_unit(cell, layout);
  };
  if (std::ranges::any_of(cells, speaks_of_columns)) return false;
  const bool marked = begins_with_mark(cells.front());
  if (!marked && has_letters(first.substr(0, 1))) return false;
  if (!marked && is_summary(cells.front())) return true;
  if (std::ranges::any_of(cells, begins_as_number)) return false;
  const auto words = std::ranges::count_if(cells, has_letters);
  return marked || behind_head || words == 1;
}

}  // namespace workbench
