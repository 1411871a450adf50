#include "workbench/recording/columns/header_names.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "workbench/recording/column_name.hpp"
#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

// A cell that is the same in all rows and names the number behind it.
bool names_next(const LineTable& table, const std::vector<LineCell>& cells,
                std::size_t c) {
  return table.content(c) == Content::kText && table.content(c + 1) == Content::kNumber &&
         table.held(c) == 1 && column_name(cells[c].text).part != Part::kNone;
}

// FIC101.OP,,FIC101.PV,: names over the times of values that have their own, as PI
// DataLink puts them, moved to the values.
void move_from_times(const LineTable& table, std::vector<LineCell>& given) {
  std::vector<LineCell> names = given;
  const bool cut = names.size() + 1 == table.width() && table.even();
  if (names.size() != table.width() && !cut) return;
  if (cut) names.push_back({"", names.back().column});
  std::vector<std::size_t> times;
  for (std::size_t c = 0; c + 1 < names.size(); ++c) {
    const bool once = table.content(c) == Content::kNothing &&
                      kind_of(table.first(c)) == CellKind::kDateTime;
    if (table.content(c) != Content::kDateTime && !once) continue;
    const Content behind = table.content(c + 1);
    const bool over = !names[c].text.empty() && names[c + 1].text.empty() &&
                      column_name(names[c].text).part != Part::kTime &&
                      (behind == Content::kNumber || behind == Content::kNothing);
    if (!over) return;
    times.push_back(c);
  }
  if (times.size() < 2) return;
  for (const std::size_t c : times) {
    names[c + 1] = names[c];
    names[c].text = "Time";
  }
  given = std::move(names);
}

// Each filled cell over the first of names that repeat as often.
bool stand_over_groups(const std::vector<LineCell>& above,
                       const std::vector<LineCell>& cells, std::size_t filled) {
  const std::string_view first = cells.front().text;
  const auto begins = [first](const LineCell& cell) { return cell.text == first; };
  if (first.empty() || std::cmp_not_equal(std::ranges::count_if(cells, begins), filled)) {
    return false;
  }
  for (std::size_t c = 0; c < above.size(); ++c) {
    if (above[c].text.empty() == begins(cells[c])) return false;
  }
  return true;
}

}  // namespace

std::vector<LineCell> names_of(const LineTable& table, std::size_t header) {
  std::vector<LineCell> names = table.cells(header);
  const std::size_t width = table.width();
  const bool blanks = table.separator() == kBlanks;
  // "# t u y": the mark of a remark is no column.
  if (blanks && names.size() > width && (names[0].text == "#" || names[0].text == "%")) {
    names.erase(names.begin());
  }
  move_from_times(table, names);
  if (names.size() >= width || !table.even()) return names;
  std::vector<LineCell> spread;
  std::size_t taken = 0;
  bool over_times = false;
  if (table.counts(0)) spread.push_back({"", 1});
  while (spread.size() < width && taken < names.size()) {
    const std::size_t c = spread.size();
    spread.push_back(names[taken++]);
    const Part part = column_name(spread.back().text).part;
    over_times = over_times || ((part == Part::kTime || part == Part::kTag) &&
                                is_time(table.content(c)));
    const bool unnamed = taken < names.size() && names.size() + 1 == width &&
                         column_name(names[taken].text).part != Part::kTime;
    const bool cut = (blanks || unnamed) && table.content(c) == Content::kDate &&
                     table.content(c + 1) == Content::kClock;
    if (cut) spread.push_back({"", spread.back().column});
  }
  // Else a column more may as well stand behind the last name.
  const bool fits = over_times && spread.size() == width && taken == names.size();
  return fits ? spread : names;
}

std::vector<LineCell> names_without_header(const LineTable& table) {
  static const std::vector<std::string> kNumbers = [] {
    std::vector<std::string> out;
    for (std::size_t i = 1; i <= kMostHeaderCells + 1; ++i) {
      out.push_back('#' + std::to_string(i));
    }
    return out;
  }();
  std::vector<LineCell> cells = table.cells(table.first_row());
  if (cells.size() > 1 && cells.back().text.empty() &&
      table.content(cells.size() - 1) == Content::kNothing) {
    cells.pop_back();
  }
  std::vector<LineCell> names;
  std::size_t named = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const bool by_row = c > 0 && names_next(table, cells, c - 1);
    named += by_row;
    names.push_back({by_row ? cells[c - 1].text : kNumbers[c], cells[c].column});
  }
  for (std::size_t c = 0; c < names.size() && named < 2; ++c) names[c].text = kNumbers[c];
  return names;
}

bool has_repeated_names(const std::vector<LineCell>& cells) {
  std::vector<std::string_view> names;
  for (const LineCell& cell : cells) {
    if (!cell.text.empty()) names.push_back(cell.text);
  }
  std::ranges::sort(names);
  return std::ranges::adjacent_find(names) != names.end();
}

std::optional<std::size_t> line_of_tags(const LineTable& table, std::size_t header,
                                        std::size_t highest) {
  for (std::size_t i = header; i-- > highest;) {
    const std::vector<LineCell>& cells = table.cells(i);
    const bool whole = cells.size() == table.cells(header).size();
    if (whole && column_name(cells[0].text).part == Part::kTag) return i;
  }
  return std::nullopt;
}

void put_names_above(const std::vector<LineCell>& above,
                     const std::vector<LineCell>& cells,
                     std::vector<LayoutColumn>& columns) {
  const auto filled =
      std::ranges::count_if(above, [](const LineCell& c) { return !c.text.empty(); });
  if (filled < 2) return;  // a title
  std::map<std::string_view, std::size_t> count;
  for (const LineCell& cell : cells) ++count[cell.text];
  const bool cut = above.size() < cells.size();
  if (above.size() > cells.size()) return;
  if (cut && !stand_over_groups(above, cells, static_cast<std::size_t>(filled))) return;
  std::string last;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const bool named = c < above.size() && !above[c].text.empty();
    if (named) last = std::string(above[c].text);
    const bool is_time = columns[c].name.part == Part::kTime && count[cells[c].text] < 2;
    const bool blank = cells[c].text.empty() && !named;
    if (last.empty() || is_time || blank) continue;
    columns[c].name = column_name(last + ' ' + std::string(cells[c].text));
  }
}

bool is_remark_of_names(const std::vector<LineCell>& cells, std::size_t width) {
  return cells.size() == width && width > 1 &&
         std::ranges::all_of(cells, [](const LineCell& cell) {
           return cell.text.size() > 1 && cell.text[0] == '#' && !is_digit(cell.text[1]);
         });
}

void name_the_rest(const LineTable& table, std::vector<LayoutColumn>& columns) {
  // Commas between decimals would make as many cells.
  const bool whole = table.separator() != ',' || table.style().decimal == '.';
  if (!table.even() || columns.size() < 2 || !whole) return;
  for (std::size_t c = columns.size(); c < table.width(); ++c) {
    if (table.content(c) == Content::kNothing) return;
    LayoutColumn& column = columns.emplace_back();
    column.name.text = '#' + std::to_string(c + 1);
    column.column = 1;
  }
}

}  // namespace workbench
