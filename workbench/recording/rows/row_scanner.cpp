#include "workbench/recording/rows/row_scanner.hpp"

#include <algorithm>
#include <utility>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/columns/header_names.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/later_texts.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/spelling/cell_number.hpp"
#include "workbench/recording/text_encoding.hpp"

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

RowScanner::RowScanner(std::string_view text, const std::string& file,
                       const CsvLayout& layout, std::vector<std::size_t> columns,
                       bool plain, bool counted)
    : text_(text.substr(layout.first_row_offset)),
      file_(file),
      layout_(layout),
      reader_(text_, file, layout.first_row_line),
      slot_of_(layout.columns.size(), -1),
      plain_(plain),
      counted_(counted),
      found_(columns.size()) {
  for (std::size_t slot = 0; slot < columns.size(); ++slot) {
    slot_of_[columns[slot]] = static_cast<std::int32_t>(slot);
    needed_ = std::max(needed_, columns[slot] + 1);
  }
}

bool RowScanner::take_line() {
  row_offset_ = reader_.cell_offset();
  line_ = reader_.line();
  cells_ = filled_cells_ = 0;
  for (Found& found : found_) found = {};
  const char separator = layout_.separator;
  while (true) {
    const std::string_view cell = reader_.take_cell(separator);
    if (cells_ == 0) row_offset_ = reader_.cell_offset();
    const std::int32_t slot = cells_ < slot_of_.size() ? slot_of_[cells_] : -1;
    if (slot >= 0) {
      found_[static_cast<std::size_t>(slot)] = {cell, reader_.cell_column()};
    }
    ++cells_;
    if (!cell.empty()) filled_cells_ = cells_;
    if (!reader_.take_separator(separator)) break;
  }
  end_column_ = reader_.column();
  return filled_cells_ > 0 || (cells_ != 1 && cells_ != layout_.columns.size());
}

bool RowScanner::skip_head() {
  if (plain_ && !reader_.starts_with(layout_.header)) return false;
  const std::string_view line = trimmed(reader_.rest_of_line());
  const bool is_header = !layout_.header.empty() && line == layout_.header;
  if (!is_header && (plain_ || !heads_again(line, layout_.header))) return false;
  if (is_header) {
    behind_head_ = true;
    empty_line_ = 0;
  }
  reader_.skip_rest_of_line();
  return true;
}

bool RowScanner::next() {
  behind_head_ = false;
  while (true) {
    if (!first_) reader_.next_line();
    first_ = false;
    if (reader_.at_end()) return false;
    if (skip_head()) continue;
    if (!take_line()) {
      if (empty_line_ == 0) empty_line_ = line_;
      continue;
    }
    if (plain_ && empty_line_ != 0) {
      throw InputError(file_, empty_line_, 1, "values", "an empty line between rows",
                       "remove the line, or write the values");
    }
    if (first_cells_ == 0) first_cells_ = cells_;
    const std::optional<InputError> wrong = wrong_count();
    if (!wrong) return true;
    reject(*wrong);
  }
}

std::optional<InputError> RowScanner::wrong_count() const {
  const std::size_t expected = layout_.columns.size();
  // Where blanks separate, a cell without a value moves those behind it.
  const bool blanks = layout_.separator == kBlanks && cells_ != first_cells_;
  if (cells_ == expected && !blanks) return std::nullopt;
  if (!plain_ && !blanks &&
      (cells_ > expected ? filled_cells_ <= std::max(expected, layout_.most_cells)
                         : cells_ >= needed_)) {
    return std::nullopt;
  }
  const bool commas = layout_.separator == ',' && cells_ > expected;
  const char* advice = "make every row as long as the header";
  if (commas) {
    advice =
        "make every row as long as the header; with decimal commas, separate the columns "
        "with semicolons";
  } else if (blanks) {
    advice = "write NaN where a value is missing, or separate the columns with tabs";
  }
  return InputError(file_, line_, end_column_,
                    blanks ? std::to_string(first_cells_) + " cells as in the first row"
                           : std::to_string(expected) + " cells as in the header",
                    std::to_string(cells_), advice);
}

bool RowScanner::is_cut_off() const {
  return cells_ < layout_.columns.size() && reader_.at_end() &&
         !is_line_end(text_.back());
}

InputError RowScanner::error(std::size_t slot, std::string expected, std::string found,
                             std::string advice) const {
  return InputError(file_, line_, found_[slot].column, std::move(expected),
                    std::move(found), std::move(advice));
}

bool RowScanner::is_remark() const {
  if (plain_ || counted_) return false;
  std::vector<std::string_view> cells;
  std::string_view first;
  for (std::size_t column = 0; column < slot_of_.size(); ++column) {
    if (slot_of_[column] < 0) continue;
    if (cells.empty()) first = layout_.columns[column].first;
    cells.push_back(found_[static_cast<std::size_t>(slot_of_[column])].text);
  }
  return workbench::is_remark(cells, first, layout_, behind_head_);
}

void RowScanner::reject(const InputError& why) {
  if (plain_ && !is_cut_off()) throw why;
  if (!rejected_.first) {
    rejected_.first = why;
    rejected_.text = utf8_of(text_.substr(
        row_offset_, std::min<std::size_t>(
                         text_.find_first_of("\r\n", row_offset_) - row_offset_, 40)));
  }
  ++rejected_.lines;
  if (is_remark()) return;
  if (!wrong_) wrong_ = why;
  if (++wrong_lines_ > kMostFooterLines) throw InputError(*wrong_);
}

void RowScanner::accept() {
  ++rows_;
  if (!rejected_.first) return;
  if (wrong_) throw InputError(*wrong_);
  const std::size_t lines = remarks_.lines + rejected_.lines;
  if (!remarks_.first) remarks_ = std::move(rejected_);
  remarks_.lines = lines;
  rejected_ = {};
}

void RowScanner::finish(std::vector<std::string>& notes) {
  constexpr std::size_t kRowsOfRemark = 10;
  if (remarks_.first) {
    if (remarks_.lines * kRowsOfRemark > rows_) throw InputError(*remarks_.first);
    notes.push_back(
        remarks_.lines == 1
            ? filled("a line between the rows is no row ({0}): left out",
                     {quoted(remarks_.text)})
            : filled("{0} lines between the rows are no rows (first {1}): left out",
                     {std::to_string(remarks_.lines), quoted(remarks_.text)}));
  }
  if (rejected_.first) {
    if (rows_ < 2) throw InputError(*rejected_.first);
    notes.push_back(
        (rejected_.lines == 1
             ? std::string("the last line is no row")
             : "the last " + std::to_string(rejected_.lines) + " lines are no rows") +
        " ('" + rejected_.text + "'): left out");
  }
}

std::size_t RowScanner::likely_rows() const {
  const std::size_t head = std::min<std::size_t>(text_.size(), 16384);
  const auto lines = static_cast<std::size_t>(std::count_if(
      text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(head), is_line_end));
  return std::min(kMaxSamples,
                  text_.size() / std::max<std::size_t>(head / (lines + 1), 2) + 16);
}

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
