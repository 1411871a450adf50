#include "workbench/recording/csv_layout.hpp"

#include <array>
#include <span>
#include <utility>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/columns/header_names.hpp"
#include "workbench/recording/columns/line_table.hpp"
#include "workbench/recording/columns/quality_columns.hpp"
#include "workbench/recording/columns/time_place.hpp"
#include "workbench/recording/formats/labview_export.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/later_texts.hpp"

namespace workbench {
namespace {

constexpr std::array<char, 4> kSeparators = {',', ';', '\t', '|'};
constexpr std::size_t kSampleBytes = std::size_t{1} << 20;
constexpr std::size_t kHeaderLines = 8;  // above the first row, looked through for names

// The first lines that are not blank; one that the sample cuts off is left out.
std::vector<SampleLine> sample_of(std::string_view text, const std::string& file) {
  std::vector<SampleLine> lines;
  CellReader reader(text, file);
  while (!reader.at_end() && lines.size() < kSampleLines) {
    const std::size_t line = reader.line();
    const std::string_view rest = whole_line(reader);
    const auto offset = static_cast<std::size_t>(rest.data() - text.data());
    if (offset + rest.size() > kSampleBytes && lines.size() > 1) break;
    if (!trimmed(rest).empty()) lines.push_back({rest, offset, line});
    reader.next_line();
  }
  // A LabVIEW file: what its heads say of channels is no row.
  const auto last = std::find_if(
      lines.rbegin(), lines.rend(),
      [](const SampleLine& line) { return line.text.starts_with(kEndOfLabviewHead); });
  lines.erase(lines.begin(), last.base());
  return lines;
}

bool holds_contract_names(const std::vector<LineCell>& cells,
                          const std::vector<Column>& required) {
  return std::ranges::all_of(required, [&cells](Column column) {
    return std::ranges::any_of(
        cells, [column](const LineCell& cell) { return role_of(cell.text) == column; });
  });
}

// Units under names: every filled cell but perhaps that of the time is one.
bool is_unit_row(const std::vector<LineCell>& cells) {
  std::size_t units = 0;
  std::size_t filled = 0;
  for (const LineCell& cell : cells) {
    if (cell.text.empty()) continue;
    ++filled;
    const bool bracketed = cell.text != without_brackets(cell.text);
    if (bracketed || is_unit(cell.text)) ++units;
  }
  return units > 0 && 2 * units >= filled;
}

// How much a line looks like the names of columns.
std::size_t header_merit(const std::vector<LineCell>& cells, const LayoutWish& wish) {
  std::size_t parts = 0;
  std::size_t filled = 0;
  for (const LineCell& cell : cells) {
    if (cell.text.empty()) continue;
    ++filled;
    const ColumnName name = column_name(cell.text);
    if (name.part != Part::kNone) ++parts;
    for (const std::string& named : wish.named) {
      if (column_name(named).key == name.key) parts += 4;
    }
  }
  return is_unit_row(cells) && parts == 0 ? 0 : 1 + 4 * parts + filled;
}

void take_units(const std::vector<LineCell>& cells, CsvLayout& out) {
  for (std::size_t c = 0; c < std::min(cells.size(), out.columns.size()); ++c) {
    std::string& unit = out.columns[c].name.unit;
    if (unit.empty() && !cells[c].text.empty()) {
      unit = column_name("x [" + std::string(without_brackets(cells[c].text)) + "]").unit;
    }
  }
}

// Min, Max, Min, Max in every column, under tags in some.
bool stand_under(const std::vector<LineCell>& cells, const std::vector<LineCell>& tags) {
  const auto is_empty = [](const LineCell& cell) { return cell.text.empty(); };
  return cells.size() == tags.size() && std::ranges::none_of(cells, is_empty) &&
         std::ranges::any_of(tags, is_empty) && has_repeated_names(cells) &&
         !is_unit_row(cells);
}

void take_names(const std::vector<LineCell>& cells, CsvLayout& out) {
  for (const LineCell& cell : cells) {
    LayoutColumn& column = out.columns.emplace_back();
    column.name = column_name(cell.text);
    column.column = cell.column;
  }
}

// The separator that a first line `sep=;` names; 0: none.
char named_separator(std::string_view line) {
  line = trimmed(line);
  if (line.size() >= 2 && line.front() == '"' && line.back() == '"') {
    line = line.substr(1, line.size() - 2);
  }
  return line.size() == 5 && line.starts_with("sep=") ? line[4]
         : line == "sep="                             ? '\t'
                                                      : '\0';
}

// "NO.", "Time", "ms", "degC", "V" under "Number", "Date&Time", "ms", "CH1", "CH2": units
// wherever numbers are measured, under a line of as many names.
bool is_units_of(const LineTable& table, std::size_t line) {
  const std::vector<LineCell>& cells = table.cells(line);
  const std::vector<LineCell>& names = table.cells(line - 1);
  if (cells.size() != names.size() || cells.size() < table.width()) return false;
  std::size_t units = 0;
  for (std::size_t c = 0; c < table.width(); ++c) {
    const Part part = column_name(cells[c].text).part;
    const bool measured = table.content(c) == Content::kNumber && !table.counts(c) &&
                          part != Part::kTime && part != Part::kMillis;
    if (!measured) continue;
    if (!is_unit(cells[c].text) || names[c].text.empty() || is_unit(names[c].text) ||
        kind_of(names[c].text) != CellKind::kText) {
      return false;
    }
    ++units;
  }
  return units > 1;
}

class LayoutFinder {
 public:
  LayoutFinder(std::string_view text, const std::string& file, const LayoutWish& wish)
      : text_(text), file_(file), wish_(wish), lines_(sample_of(text, file)) {}

  CsvLayout find() {
    if (lines_.empty()) {
      throw InputError(file_, 1, 1, "a header row with the names of the columns",
                       "an empty file", "export the recording again");
    }
    if (const char named = named_separator(lines_[0].text); named != 0) {
      separators_ = {named};
      if (lines_.size() > 1) lines_.erase(lines_.begin());
    }
    if (!find_contract_names()) find_by_contents();
    if (out_.columns.size() > kMostHeaderCells) {
      throw InputError(file_, out_.header_line, 1,
                       "at most " + std::to_string(kMostHeaderCells) + " columns", "more",
                       "export only the columns of one loop");
    }
    if (out_.columns.size() == 1 && wish_.required.size() > 1 && lines_.size() > 1) {
      throw InputError(file_, out_.header_line, 1, "columns of u and y side by side",
                       "a single column",
                       "export both, with a comma, semicolon or tab between them");
    }
    return std::move(out_);
  }

 private:
  bool find_contract_names() {
    if (!wish_.named.empty()) return false;
    for (const char separator : separators_) {
      const std::vector<LineCell> cells = split_line(lines_[0].text, separator);
      if (!holds_contract_names(cells, wish_.required)) continue;
      out_.contract_names = true;
      take_names(cells, out_);
      std::size_t row = 1;
      if (lines_.size() > 1) {
        const std::vector<LineCell> next = split_line(lines_[1].text, separator);
        const bool all_units = next.size() == cells.size() && is_unit_row(next) &&
                               std::ranges::all_of(next, [](const LineCell& cell) {
                                 return cell.text.empty() ||
                                        kind_of(cell.text) == CellKind::kText ||
                                        is_unit(cell.text);
                               });
        if (all_units) {
          take_units(next, out_);
          row = 2;
        }
      }
      const std::vector<SampleLine> rows(
          lines_.begin() + static_cast<std::ptrdiff_t>(std::min(row, lines_.size())),
          lines_.end());
      set_rows(LineTable(rows, separator), 0, row);
      return true;
    }
    return false;
  }

  // Line indices of the sample; what is between them is skipped.
  void set_rows(const LineTable& table, std::size_t header, std::size_t first_row) {
    out_.separator = table.separator();
    out_.header_line = lines_[header].line;
    if (header != first_row) out_.header = trimmed(lines_[header].text);
    if (first_row < lines_.size()) {
      out_.first_row_line = lines_[first_row].line;
      out_.first_row_offset = lines_[first_row].offset;
    } else {
      out_.first_row_line = lines_.back().line + 1;
      out_.first_row_offset = text_.size();
    }
    out_.most_cells = out_.columns.size();
    cut_names(table);
    // Blank lines in between are the row reader's to judge.
    if (first_row == header + 1) {
      out_.first_row_line = lines_[header].line + 1 + breaks_in(lines_[header].text);
      out_.first_row_offset =
          after_line_end(lines_[header].offset + lines_[header].text.size());
    }
    out_.style = table.style();
    if (wish_.decimal) {
      out_.style = {.decimal = *wish_.decimal,
                    .given = true,
                    .grouped = true,
                    .dotted_dates = out_.style.dotted_dates};
      out_.contract_names = false;
    }
    for (std::size_t c = 0; c < out_.columns.size(); ++c) {
      out_.columns[c].content = table.content(c);
      out_.columns[c].held = table.held(c);
      out_.columns[c].first = table.first(c);
      out_.columns[c].counts = table.counts(c);
    }
    settle_qualities(table, out_.columns);
    tell_temperature(out_.columns);
    for (std::size_t c = 0; c < out_.columns.size(); ++c) {
      const Part part = out_.columns[c].name.part;
      const bool is_plain = table.content(c) == Content::kNumber && part != Part::kTime &&
                            part != Part::kTag;
      if (!is_plain) out_.columns[c].same_as = table.same_as(c);
    }
    LaterTexts later(out_, file_);
    later.add(text_.substr(out_.first_row_offset));
    later.settle(out_);
  }

  // More names than cells, the same number in each row: the last have no cells. Where one
  // is a unit, a comma within a name may have made the names more.
  void cut_names(const LineTable& table) {
    const std::size_t names = out_.columns.size();
    const std::size_t cells = table.width();
    const bool unit = std::ranges::any_of(out_.columns, [](const LayoutColumn& c) {
      return c.name.part == Part::kNone && is_unit(c.name.text);
    });
    if (names <= cells || cells < 2 || unit || table.separator() == kBlanks ||
        !table.even()) {
      return;
    }
    const std::span<const LayoutColumn> cut = std::span(out_.columns).subspan(cells);
    const bool wanted = std::ranges::any_of(
        cut, [](const LayoutColumn& c) { return c.name.part != Part::kNone; });
    if (wanted) return;
    const bool named = std::ranges::any_of(
        cut, [](const LayoutColumn& c) { return !c.name.text.empty(); });
    out_.columns.resize(cells);
    if (!named) return;
    out_.cut_names = "the header has " + std::to_string(names) + " names, each row " +
                     std::to_string(cells) + " cells: the last names are left out";
    out_.notes.push_back(out_.cut_names);
  }

  [[nodiscard]] std::size_t after_line_end(std::size_t at) const {
    if (text_.substr(at).starts_with("\r\n")) return at + 2;
    return std::min(at + 1, text_.size());
  }

  void find_by_contents() {
    std::optional<LineTable> best;
    for (const char separator : separators_) {
      LineTable table(lines_, separator);
      if (!best || merits_of(table) > merits_of(*best)) best = std::move(table);
    }
    if (best->width() == 1) {
      LineTable blanks(lines_, kBlanks);
      if (blanks.has_rows() && blanks.width() > 1) best = std::move(blanks);
    }
    if (!best->has_rows()) {
      take_names(best->cells(0), out_);
      set_rows(*best, 0, 1);
      return;
    }
    const std::size_t first_row = best->first_row();
    std::size_t header = first_row;
    std::size_t merit = 0;
    bool named = false;
    const std::size_t highest = first_row > kHeaderLines ? first_row - kHeaderLines : 0;
    for (std::size_t i = first_row; i-- > highest;) {
      const std::vector<LineCell>& cells = best->cells(i);
      const auto empty = std::ranges::count(cells, "", &LineCell::text);
      const std::size_t filled = cells.size() - static_cast<std::size_t>(empty);
      const bool remark = is_remark_of_names(cells, best->width());
      if ((!best->is_text(i) && !remark) || filled < (best->width() > 2 ? 2U : 1U)) {
        continue;
      }
      if (cells.size() + 1 < best->width() && i + 1 < first_row) continue;
      // The channels of a preamble, above names that fill the columns.
      if (cells.size() > best->width() && named) continue;
      const std::size_t of_line = header_merit(cells, wish_);
      if (of_line > merit || (of_line == merit && header == first_row)) {
        merit = of_line;
        header = i;
        named = cells.size() == best->width() && of_line > 1 + filled;
      }
    }
    if (header + 1 < first_row &&
        stand_under(best->cells(header + 1), best->cells(header))) {
      ++header;
    } else if (header > highest && header < first_row && is_units_of(*best, header)) {
      --header;
    }
    if (header == first_row) {
      take_names(names_without_header(*best), out_);
      set_rows(*best, first_row, first_row);
      return;
    }
    take_names(names_of(*best, header), out_);
    if (header > 0 && has_repeated_names(best->cells(header))) {
      const std::vector<LineCell>& above =
          best->cells(line_of_tags(*best, header, highest).value_or(header - 1));
      put_names_above(above, best->cells(header), out_.columns);
    }
    name_the_rest(*best, out_.columns);
    take_unit_rows(*best, header, highest);
    set_rows(*best, header, first_row);
  }

  void take_unit_rows(const LineTable& table, std::size_t header, std::size_t highest) {
    // Names that were spread over a date and its clock, and units with them.
    const std::size_t short_one = out_.columns.size() - 1;
    const bool spread = table.cells(header).size() == short_one;
    for (std::size_t i = highest; i < table.first_row(); ++i) {
      std::vector<LineCell> cells = table.cells(i);
      const bool remark = cells[0].text.starts_with('#');
      if (i == header || remark || !is_unit_row(cells)) continue;
      if (spread && cells.size() == short_one) cells.insert(cells.begin() + 1, {"", 1});
      take_units(cells, out_);
    }
  }

  // What speaks for a separator, the weightiest first: values, no text between them as
  // of 52,6;110,4 cut at the commas, and names in the first line.
  [[nodiscard]] static std::array<std::size_t, 3> merits_of(const LineTable& table) {
    std::size_t others = kMostHeaderCells + 1;
    for (std::size_t c = 0; c < table.width() && table.has_rows(); ++c) {
      if (table.content(c) == Content::kText) --others;
    }
    return {table.merit(), others, first_line_merit(table)};
  }

  [[nodiscard]] static std::size_t first_line_merit(const LineTable& table) {
    std::size_t parts = 0;
    for (const LineCell& cell : table.cells(0)) {
      if (column_name(cell.text).part != Part::kNone) ++parts;
    }
    return parts * (kMostHeaderCells + 2) + table.cells(0).size();
  }

  std::string_view text_;
  const std::string& file_;
  const LayoutWish& wish_;
  std::vector<SampleLine> lines_;
  std::vector<char> separators_{kSeparators.begin(), kSeparators.end()};
  CsvLayout out_;
};

}  // namespace

std::optional<std::size_t> counter_of(const CsvLayout& layout) {
  return first_column(layout.columns, [](const LayoutColumn& c) { return c.counts; });
}

CsvLayout layout_of(std::string_view text, const std::string& file,
                    const LayoutWish& wish) {
  return LayoutFinder(text, file, wish).find();
}

}  // namespace workbench
