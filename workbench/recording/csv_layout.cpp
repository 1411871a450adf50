#include "workbench/recording/csv_layout.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "workbench/recording/bad_value.hpp"
#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/written_time.hpp"

namespace workbench {
namespace {

constexpr std::array<char, 4> kSeparators = {',', ';', '\t', '|'};
constexpr std::size_t kSampleBytes = std::size_t{1} << 20;
constexpr std::size_t kHeaderLines = 8;  // above the first row, looked through for names

struct SampleLine {
  std::string_view text;
  std::size_t offset;
  std::size_t line;  // from 1
};

// The first lines that are not blank; one that the sample cuts off is left out.
std::vector<SampleLine> sample_of(std::string_view text, const std::string& file) {
  std::vector<SampleLine> lines;
  CellReader reader(text, file);
  while (!reader.at_end() && lines.size() < kSampleLines) {
    const std::string_view rest = reader.rest_of_line();
    const auto offset = static_cast<std::size_t>(rest.data() - text.data());
    if (offset + rest.size() > kSampleBytes && lines.size() > 1) break;
    if (!trimmed(rest).empty()) lines.push_back({rest, offset, reader.line()});
    reader.skip_rest_of_line();
    reader.next_line();
  }
  return lines;
}

enum class CellKind { kEmpty, kNumber, kDateTime, kDate, kClock, kBad, kText };

CellKind kind_of(std::string_view cell) {
  if (cell.empty()) return CellKind::kEmpty;
  NumberEvidence number;
  const std::optional<WrittenTime> time = written_time(cell);
  if (time) {
    return time->kind == WrittenTime::Day::kNone ? CellKind::kClock
           : time->has_clock                     ? CellKind::kDateTime
                                                 : CellKind::kDate;
  }
  if (number.add(cell)) return CellKind::kNumber;
  return says_no_value(cell, true) ? CellKind::kBad : CellKind::kText;
}

bool is_value(CellKind kind) {
  return kind == CellKind::kNumber || kind == CellKind::kDateTime ||
         kind == CellKind::kDate || kind == CellKind::kClock;
}

bool is_time(CellKind kind) {
  return is_value(kind) && kind != CellKind::kNumber;
}

// The lines of the sample under one separator.
class Table {
 public:
  Table(const std::vector<SampleLine>& lines, char separator) : separator_(separator) {
    for (const SampleLine& line : lines) {
      cells_.push_back(split_line(line.text, separator));
      std::vector<CellKind> kinds;
      for (const LineCell& cell : cells_.back()) kinds.push_back(kind_of(cell.text));
      kinds_.push_back(std::move(kinds));
    }
    find_width();
    find_contents();
    find_first_row();
  }

  [[nodiscard]] char separator() const { return separator_; }
  [[nodiscard]] std::size_t width() const { return width_; }
  [[nodiscard]] std::size_t first_row() const { return first_row_; }
  [[nodiscard]] bool has_rows() const { return first_row_ < cells_.size(); }
  [[nodiscard]] const std::vector<LineCell>& cells(std::size_t line) const {
    return cells_[line];
  }
  [[nodiscard]] Content content(std::size_t column) const {
    return column < contents_.size() ? contents_[column] : Content::kNothing;
  }
  // Columns that hold values, times counting twice: the better separator has more.
  [[nodiscard]] std::size_t merit() const {
    std::size_t merit = 0;
    for (const Content content : contents_) {
      if (content == Content::kNumber) ++merit;
      if (content == Content::kDateTime || content == Content::kDate ||
          content == Content::kClock) {
        merit += 2;
      }
    }
    return has_rows() ? merit : 0;
  }

  [[nodiscard]] NumberStyle style() const {
    NumberEvidence evidence;
    for (std::size_t i = first_row_; i < cells_.size(); ++i) {
      for (std::size_t c = 0; c < cells_[i].size(); ++c) {
        if (kinds_[i][c] == CellKind::kNumber) evidence.add(cells_[i][c].text);
      }
    }
    return evidence.style();
  }

  // Most filled cells of a line are text, none is a number or time.
  [[nodiscard]] bool is_text(std::size_t line) const {
    const std::vector<CellKind>& kinds = kinds_[line];
    return std::any_of(kinds.begin(), kinds.end(),
                       [](CellKind k) { return k == CellKind::kText; });
  }

 private:
  // The commonest count of cells in the later three quarters of the lines.
  void find_width() {
    std::map<std::size_t, std::size_t> counts;
    for (std::size_t i = cells_.size() / 4; i < cells_.size(); ++i) {
      ++counts[cells_[i].size()];
    }
    std::size_t most = 0;
    for (const auto& [count, lines] : counts) {
      if (lines >= most) {
        most = lines;
        width_ = count;
      }
    }
  }

  void find_contents() {
    contents_.assign(width_, Content::kNothing);
    for (std::size_t c = 0; c < width_; ++c) {
      std::array<std::size_t, 7> counts{};
      for (std::size_t i = cells_.size() / 4; i < cells_.size(); ++i) {
        if (cells_[i].size() == width_) ++counts[static_cast<std::size_t>(kinds_[i][c])];
      }
      const auto of = [&counts](CellKind kind) {
        return counts[static_cast<std::size_t>(kind)];
      };
      const std::size_t dates = of(CellKind::kDateTime) + of(CellKind::kDate);
      const std::size_t values = dates + of(CellKind::kClock) + of(CellKind::kNumber);
      if (values + of(CellKind::kText) == 0) continue;
      if (values < of(CellKind::kText)) {
        contents_[c] = Content::kText;
      } else if (2 * dates >= values) {
        contents_[c] = of(CellKind::kDateTime) > 0 ? Content::kDateTime : Content::kDate;
      } else {
        contents_[c] =
            2 * of(CellKind::kClock) > values ? Content::kClock : Content::kNumber;
      }
    }
  }

  void find_first_row() {
    first_row_ = 0;
    while (first_row_ < cells_.size() && !is_row(first_row_)) ++first_row_;
  }

  // Times where the columns hold times; where there are none, some number.
  [[nodiscard]] bool is_row(std::size_t line) const {
    const std::vector<CellKind>& kinds = kinds_[line];
    if (kinds.size() < width_) return false;
    bool has_times = false;
    bool numbers = false;
    for (std::size_t c = 0; c < width_; ++c) {
      const bool of_times = contents_[c] == Content::kDateTime ||
                            contents_[c] == Content::kDate ||
                            contents_[c] == Content::kClock;
      if (of_times && is_time(kinds[c])) has_times = true;
      if (of_times && kinds[c] == CellKind::kText) return false;
      numbers = numbers || (contents_[c] == Content::kNumber && is_value(kinds[c]));
    }
    const bool timed = std::any_of(contents_.begin(), contents_.end(), [](Content c) {
      return c == Content::kDateTime || c == Content::kDate || c == Content::kClock;
    });
    return timed ? has_times : numbers;
  }

  char separator_;
  std::vector<std::vector<LineCell>> cells_;
  std::vector<std::vector<CellKind>> kinds_;
  std::vector<Content> contents_;
  std::size_t width_ = 1;
  std::size_t first_row_ = 0;
};

bool holds_contract_names(const std::vector<LineCell>& cells,
                          const std::vector<Column>& required) {
  return std::all_of(required.begin(), required.end(), [&cells](Column column) {
    return std::any_of(cells.begin(), cells.end(), [column](const LineCell& cell) {
      return role_of(cell.text) == static_cast<int>(column);
    });
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

void take_names(const std::vector<LineCell>& cells, CsvLayout& out) {
  for (const LineCell& cell : cells) {
    out.columns.push_back({column_name(cell.text), cell.column, Content::kNothing});
  }
}

// "Value, Status, Value, Status" under "FIC101.OP, , FIC101.PV, ": one name each.
void put_names_above(const std::vector<LineCell>& above,
                     const std::vector<LineCell>& cells, CsvLayout& out) {
  const auto filled = std::count_if(above.begin(), above.end(),
                                    [](const LineCell& c) { return !c.text.empty(); });
  if (filled < 2) return;  // a title
  std::map<std::string_view, std::size_t> count;
  for (const LineCell& cell : cells) ++count[cell.text];
  std::string last;
  for (std::size_t c = 0; c < std::min(above.size(), cells.size()); ++c) {
    if (!above[c].text.empty()) last = std::string(above[c].text);
    const bool is_time =
        out.columns[c].name.part == Part::kTime && count[cells[c].text] < 2;
    if (last.empty() || is_time) continue;
    out.columns[c].name = column_name(last + ' ' + std::string(cells[c].text));
  }
}

bool has_repeated_names(const std::vector<LineCell>& cells) {
  std::vector<std::string_view> names;
  for (const LineCell& cell : cells) {
    if (!cell.text.empty()) names.push_back(cell.text);
  }
  std::sort(names.begin(), names.end());
  return std::adjacent_find(names.begin(), names.end()) != names.end();
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
        const bool all_units =
            next.size() == cells.size() && is_unit_row(next) &&
            std::all_of(next.begin(), next.end(), [](const LineCell& cell) {
              return cell.text.empty() || kind_of(cell.text) == CellKind::kText ||
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
      set_rows(Table(rows, separator), 0, row);
      return true;
    }
    return false;
  }

  // Line indices of the sample; what is between them is skipped.
  void set_rows(const Table& table, std::size_t header, std::size_t first_row) {
    out_.separator = table.separator();
    out_.header_line = lines_[header].line;
    if (first_row < lines_.size()) {
      out_.first_row_line = lines_[first_row].line;
      out_.first_row_offset = lines_[first_row].offset;
    } else {
      out_.first_row_line = lines_.back().line + 1;
      out_.first_row_offset = text_.size();
    }
    // Blank lines in between are the row reader's to judge.
    if (first_row == header + 1) {
      out_.first_row_line = lines_[header].line + 1;
      out_.first_row_offset =
          after_line_end(lines_[header].offset + lines_[header].text.size());
    }
    out_.style = table.style();
    for (std::size_t c = 0; c < out_.columns.size(); ++c) {
      out_.columns[c].content = table.content(c);
    }
  }

  [[nodiscard]] std::size_t after_line_end(std::size_t at) const {
    if (text_.substr(at).starts_with("\r\n")) return at + 2;
    return std::min(at + 1, text_.size());
  }

  void find_by_contents() {
    std::optional<Table> best;
    for (const char separator : separators_) {
      Table table(lines_, separator);
      const bool better = !best || table.merit() > best->merit() ||
                          (table.merit() == best->merit() &&
                           first_line_merit(table) > first_line_merit(*best));
      if (better) best = std::move(table);
    }
    if (!best->has_rows()) {
      take_names(best->cells(0), out_);
      set_rows(*best, 0, 1);
      return;
    }
    const std::size_t first_row = best->first_row();
    std::size_t header = first_row;
    std::size_t merit = 0;
    const std::size_t highest = first_row > kHeaderLines ? first_row - kHeaderLines : 0;
    for (std::size_t i = first_row; i-- > highest;) {
      const std::vector<LineCell>& cells = best->cells(i);
      const std::size_t needed = best->width() > 2 ? 2 : 1;
      const auto filled = static_cast<std::size_t>(
          std::count_if(cells.begin(), cells.end(),
                        [](const LineCell& cell) { return !cell.text.empty(); }));
      if (!best->is_text(i) || filled < std::min(needed, best->width())) continue;
      if (cells.size() + 1 < best->width() && i + 1 < first_row) continue;
      const std::size_t of_line = header_merit(cells, wish_);
      if (of_line > merit || (of_line == merit && header == first_row)) {
        merit = of_line;
        header = i;
      }
    }
    if (header == first_row) {
      throw InputError(file_, lines_[first_row].line, 1,
                       "a header row with the names of the columns (t, u, y)", "numbers",
                       "add a first line such as t,u,y");
    }
    take_names(best->cells(header), out_);
    if (header > 0 && has_repeated_names(best->cells(header)) &&
        best->cells(header - 1).size() == best->cells(header).size()) {
      put_names_above(best->cells(header - 1), best->cells(header), out_);
    }
    for (std::size_t i = highest; i < first_row; ++i) {
      const std::vector<LineCell>& cells = best->cells(i);
      const bool remark = cells[0].text.starts_with('#');
      if (i != header && !remark && is_unit_row(cells)) take_units(cells, out_);
    }
    set_rows(*best, header, first_row);
  }

  [[nodiscard]] static std::size_t first_line_merit(const Table& table) {
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

CsvLayout layout_of(std::string_view text, const std::string& file,
                    const LayoutWish& wish) {
  return LayoutFinder(text, file, wish).find();
}

}  // namespace workbench
