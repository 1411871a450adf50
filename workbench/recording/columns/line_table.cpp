#include "workbench/recording/columns/line_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "workbench/recording/spelling/bad_value.hpp"
#include "workbench/recording/spelling/column_words.hpp"
#include "workbench/recording/spelling/mark_doubt.hpp"
#include "workbench/recording/spelling/quality_words.hpp"
#include "workbench/recording/times/time_spelling.hpp"
#include "workbench/recording/written_time.hpp"

namespace workbench {
namespace {

constexpr std::size_t kPreambleLines = 20;  // with numbers of its own

std::string_view without_unit(std::string_view cell) {
  return trimmed(cell.substr(0, cell.size() - unit_behind(cell).size()));
}

bool is_value(CellKind kind) {
  return kind == CellKind::kNumber || kind == CellKind::kDateTime ||
         kind == CellKind::kDate || kind == CellKind::kClock;
}

bool is_time(CellKind kind) {
  return is_value(kind) && kind != CellKind::kNumber;
}

}  // namespace

CellKind kind_of(std::string_view cell) {
  if (cell.empty()) return CellKind::kEmpty;
  NumberEvidence number;
  const std::optional<WrittenTime> time = written_time(cell);
  if (time) {
    return time->kind == WrittenTime::Day::kNone ? CellKind::kClock
           : time->has_clock                     ? CellKind::kDateTime
                                                 : CellKind::kDate;
  }
  if (number.add(without_unit(cell))) return CellKind::kNumber;
  if (const auto negative = negative_of(cell); negative && number.add(*negative)) {
    return CellKind::kNumber;
  }
  if (const auto found = number_with_quality(cell);
      found && number.add(without_unit(found->number))) {
    return CellKind::kNumber;
  }
  return says_no_value(cell, true) ? CellKind::kBad : CellKind::kText;
}

LineTable::LineTable(const std::vector<SampleLine>& lines, char separator)
    : separator_(separator) {
  for (const SampleLine& line : lines) {
    cells_.push_back(split_line(line.text, separator));
    std::vector<CellKind> kinds;
    for (const LineCell& cell : cells_.back()) kinds.push_back(kind_of(cell.text));
    kinds_.push_back(std::move(kinds));
  }
  find_width();
  for (std::size_t c = 0; c < width_; ++c) {
    if (holds_dotted_clocks(c)) mark_clocks(c);
  }
  find_contents();
  find_first_row();
}

double LineTable::held(std::size_t column) const {
  std::optional<std::string_view> before;
  std::size_t rows = 0;
  std::size_t same = 0;
  for (std::size_t i = first_row_; i < cells_.size(); ++i) {
    if (column >= cells_[i].size()) continue;
    const std::string_view cell = cells_[i][column].text;
    if (before) {
      ++rows;
      same += cell == *before;
    }
    before = cell;
  }
  return rows > 0 ? static_cast<double>(same) / static_cast<double>(rows) : 1;
}

std::vector<std::uint16_t> LineTable::same_as(std::size_t column) const {
  std::vector<std::uint16_t> out;
  std::map<std::string_view, std::uint16_t> known;
  for (std::size_t i = first_row_; i < cells_.size(); ++i) {
    const std::string_view cell =
        column < cells_[i].size() ? cells_[i][column].text : std::string_view();
    const auto row = static_cast<std::uint16_t>(i - first_row_);
    out.push_back(known.try_emplace(cell, row).first->second);
  }
  return out;
}

bool LineTable::counts(std::size_t column) const {
  constexpr double kEven = 0.01;  // of the step, for what was rounded
  constexpr std::size_t kFewest = 5;
  std::vector<double> values;
  std::size_t decimals = 0;
  for (std::size_t i = first_row_; i < cells_.size(); ++i) {
    if (column >= cells_[i].size()) return false;
    const std::string_view cell = cells_[i][column].text;
    const std::optional<double> value = wire::number_of<double>(cell);
    if (!value) return false;
    values.push_back(*value);
    const std::size_t point = std::min(cell.find('.'), cell.size() - 1);
    decimals = std::max(decimals, cell.size() - 1 - point);
  }
  if (values.size() < kFewest || !(values[1] > values[0])) return false;
  const double step =
      (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  // A step that was rounded is off by one of its last decimals, a small part of it.
  constexpr double kSmall = 0.25;
  const double digit = std::pow(10.0, -static_cast<double>(decimals));
  const bool rounded = decimals > 0 && digit <= kSmall * step;
  const double most = std::max(kEven * step, rounded ? digit * (1 + kEven) : 0);
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (!(std::abs(values[i] - values[i - 1] - step) < most)) return false;
  }
  return true;
}

std::size_t LineTable::merit() const {
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

NumberStyle LineTable::style() const {
  NumberEvidence evidence;
  bool dotted_dates = false;
  for (std::size_t i = first_row_; i < cells_.size(); ++i) {
    for (std::size_t c = 0; c < cells_[i].size(); ++c) {
      const std::string_view cell = cells_[i][c].text;
      const CellKind kind = kinds_[i][c];
      if (kind == CellKind::kNumber) evidence.add(without_unit(cell));
      const bool dated = kind == CellKind::kDate || kind == CellKind::kDateTime;
      dotted_dates = dotted_dates || (dated && cell.find('.') <= 2);
    }
  }
  NumberStyle style = evidence.style();
  style.dotted_dates = dotted_dates;
  return style;
}

bool LineTable::even() const {
  constexpr std::size_t kFewest = 5;
  return first_row_ + kFewest <= cells_.size() &&
         std::all_of(cells_.begin() + static_cast<std::ptrdiff_t>(first_row_),
                     cells_.end(),
                     [this](const auto& cells) { return cells.size() == width_; });
}

bool LineTable::is_text(std::size_t line) const {
  const std::vector<CellKind>& kinds = kinds_[line];
  return std::ranges::any_of(kinds, [](CellKind k) { return k == CellKind::kText; });
}

// The commonest count of cells in the later three quarters of the lines.
void LineTable::find_width() {
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

// 14.05.30 throughout the later rows: a clock where one of them is no date, or where what
// would be the year moves by itself.
bool LineTable::holds_dotted_clocks(std::size_t column) const {
  constexpr std::size_t kFewest = 3;
  std::size_t clocks = 0;
  std::size_t others = 0;
  bool dates = true;
  std::size_t moves = 0;
  std::size_t last_moves = 0;
  std::string before;
  for (std::size_t i = cells_.size() / 4; i < cells_.size(); ++i) {
    if (cells_[i].size() != width_ || cells_[i][column].text.empty()) continue;
    const std::optional<std::string> clock = dotted_clock(cells_[i][column].text);
    ++(clock ? clocks : others);
    if (!clock) continue;
    dates = dates && kinds_[i][column] == CellKind::kDate;
    if (!before.empty() && before != *clock) {
      ++moves;
      const std::size_t minute = clock->find(':', clock->find(':') + 1);
      last_moves += before.substr(0, minute) == clock->substr(0, minute);
    }
    before = *clock;
  }
  return clocks >= kFewest && clocks > 9 * others && (!dates || 2 * last_moves > moves);
}

void LineTable::mark_clocks(std::size_t column) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (column < cells_[i].size() && dotted_clock(cells_[i][column].text)) {
      kinds_[i][column] = CellKind::kClock;
    }
  }
}

void LineTable::find_contents() {
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

void LineTable::find_first_row() {
  first_row_ = 0;
  while (first_row_ < cells_.size() && !is_row(first_row_)) ++first_row_;
  // A preamble may hold numbers of its own (channels, sample counts): names that fill
  // the columns of numbers stand below it, and no whole row above them.
  for (std::size_t i = first_row_;
       i < std::min(cells_.size(), first_row_ + kPreambleLines); ++i) {
    if (is_whole(i)) break;
    if (!is_names(i)) continue;
    first_row_ = i + 1;
    while (first_row_ < cells_.size() && !is_row(first_row_)) ++first_row_;
  }
}

// No text where numbers or times belong.
bool LineTable::is_whole(std::size_t line) const {
  const std::vector<CellKind>& kinds = kinds_[line];
  for (std::size_t c = 0; c < std::min(width_, kinds.size()); ++c) {
    const bool holds =
        contents_[c] != Content::kNothing && contents_[c] != Content::kText;
    if (holds && kinds[c] == CellKind::kText) return false;
  }
  return kinds.size() >= width_;
}

// Text and nothing else, in every column that holds numbers or times.
bool LineTable::is_names(std::size_t line) const {
  if (kinds_[line].size() < width_) return false;
  bool names = false;
  for (std::size_t c = 0; c < width_; ++c) {
    const CellKind kind = kinds_[line][c];
    if (is_value(kind)) return false;
    const bool holds =
        contents_[c] != Content::kNothing && contents_[c] != Content::kText;
    if (holds && kind != CellKind::kText) return false;
    names = names || holds;
  }
  return names;
}

// Times where the columns hold times; where there are none, some number.
bool LineTable::is_row(std::size_t line) const {
  const std::vector<CellKind>& kinds = kinds_[line];
  if (kinds.size() < width_) return false;
  // The keys of a preamble stand where rows have their first number.
  if (contents_[0] == Content::kNumber && kinds[0] == CellKind::kText) return false;
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
  const bool timed = std::ranges::any_of(contents_, [](Content c) {
    return c == Content::kDateTime || c == Content::kDate || c == Content::kClock;
  });
  return timed ? has_times : numbers;
}

}  // namespace workbench
