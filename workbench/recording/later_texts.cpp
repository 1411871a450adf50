#include "workbench/recording/later_texts.hpp"

#include <algorithm>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/columns/line_table.hpp"
#include "workbench/recording/columns/long_format.hpp"
#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

// One text beside times and a number, epoch seconds being numbers, too.
bool is_lone_text(const CsvLayout& layout) {
  const auto count = [&layout](Content content) {
    return std::ranges::count(layout.columns, content, &LayoutColumn::content);
  };
  const std::size_t columns = layout.columns.size();
  return count(Content::kText) == 1 &&
         (columns == 3 || (columns == 4 && count(Content::kNumber) == 1));
}

bool may_change(const CsvLayout& layout, const LayoutColumn& column) {
  if (column.content != Content::kText || !column.rests()) return false;
  if (!layout.header.empty()) return column.name.part == Part::kTag;
  return is_signal(column_name(column.first).part) ||
         (is_lone_text(layout) && may_name_tag(column.first));
}

// Page 3, Page 3 of 30, - Seite 3/30 -, with the separators of empty cells around.
bool numbers_page(std::string_view line) {
  constexpr std::string_view kAround = " \t,;|\"-";
  const std::size_t begin = line.find_first_not_of(kAround);
  if (begin == std::string_view::npos || line.size() > 80) return false;
  line = line.substr(begin, line.find_last_not_of(kAround) - begin + 1);
  const std::string lower = lower_case(line);
  const std::size_t blank = lower.find(' ');
  const std::string_view rest = std::string_view(lower).substr(blank + 1);
  if (blank == std::string::npos || rest.empty()) return false;
  return is_one_of(std::string_view(lower).substr(0, blank),
                   "page|seite|pagina|p\xC3\xA1gina|strona|sida|side") &&
         is_digit(rest[0]) &&
         std::ranges::count_if(rest, is_small) <= 3 &&  // of, von, sur
         rest.find_first_of(",;:\t|.") == std::string_view::npos;
}

constexpr std::size_t kMostTables = 10'000;

std::optional<std::size_t> named(const CsvLayout& layout, std::string_view name) {
  return first_column(layout.columns,
                      [name](const LayoutColumn& c) { return c.name.text == name; });
}

}  // namespace

bool heads_again(std::string_view line, const std::string& header) {
  line = trimmed(line);
  return line.starts_with("#group,") || line.starts_with("#datatype,") ||
         line.starts_with("#default,") || (!header.empty() && line == header) ||
         numbers_page(line);
}

LaterTexts::LaterTexts(const CsvLayout& layout, const std::string& file)
    : layout_(layout), file_(file), tables_(layout) {
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    if (may_change(layout, layout.columns[i])) resting_.push_back(i);
  }
}

void LaterTexts::add(std::string_view rows) {
  CellReader reader(rows, file_);
  for (; !reader.at_end() && are_open(); reader.next_line()) {
    const std::string_view line = whole_line(reader);
    if (heads_again(line, layout_.header)) continue;
    const std::vector<LineCell> cells = split_line(line, layout_.separator);
    if (cells.size() < layout_.columns.size()) continue;
    std::erase_if(resting_, [&](std::size_t column) {
      const std::string_view cell = cells[column].text;
      const bool changes =
          cell != layout_.columns[column].first && kind_of(cell) == CellKind::kText;
      if (changes) changed_.push_back(column);
      return changes;
    });
    if (tables_.are_there()) tables_.add(cells);
  }
}

void LaterTexts::settle(CsvLayout& layout) const {
  for (LayoutColumn& column : layout.columns) column.changes_later = false;
  for (const std::size_t column : changed_) layout.columns[column].changes_later = true;
  for (const std::size_t key : tables_.keys()) layout.columns[key].changes_later = true;
}

FluxTables::FluxTables(const CsvLayout& layout)
    : layout_(layout),
      result_(named(layout, "result")),
      table_(named(layout, "table")),
      timed_(named(layout, "_time").has_value()) {
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    const LayoutColumn& column = layout.columns[i];
    const bool text = column.content == Content::kText;
    if (text && column.name.part != Part::kQuality) texts_.push_back(i);
  }
}

bool FluxTables::are_there() const {
  return result_ && table_ && timed_ && tables_.size() <= kMostTables;
}

void FluxTables::add(const std::vector<LineCell>& cells) {
  const std::string id =
      std::string(cells[*result_].text) + '\n' + std::string(cells[*table_].text);
  const auto [at, is_new] = tables_.try_emplace(id);
  std::vector<std::string>& known = at->second;
  for (std::size_t k = 0; is_new && k < texts_.size(); ++k) {
    known.emplace_back(cells[texts_[k]].text);
  }
  for (std::size_t k = 0; k < texts_.size(); ++k) {
    if (known[k] != cells[texts_[k]].text) moving_.insert(k);
  }
}

std::vector<std::size_t> FluxTables::keys() const {
  if (!are_there()) return {};
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < texts_.size(); ++k) {
    if (!moving_.contains(k)) order.push_back(k);
  }
  std::ranges::stable_sort(
      order, [this](std::size_t a, std::size_t b) { return merit(a) > merit(b); });
  const std::size_t most = told_apart(order);
  std::vector<std::size_t> chosen;
  for (std::size_t k : order) {
    const std::size_t before = told_apart(chosen);
    if (before == most) break;
    chosen.push_back(k);
    if (told_apart(chosen) == before) chosen.pop_back();
  }
  for (std::size_t& k : chosen) k = texts_[k];
  return chosen;
}

int FluxTables::merit(std::size_t k) const {
  const LayoutColumn& column = layout_.columns[texts_[k]];
  if (column.name.part == Part::kTag) return 2;
  return is_signal(column_name(column.first).part) ? 1 : 0;
}

std::size_t FluxTables::told_apart(const std::vector<std::size_t>& by) const {
  std::set<std::vector<std::string>> seen;
  for (const auto& [id, texts] : tables_) {
    std::vector<std::string> some;
    for (const std::size_t k : by) some.push_back(texts[k]);
    seen.insert(std::move(some));
  }
  return seen.size();
}

}  // namespace workbench
