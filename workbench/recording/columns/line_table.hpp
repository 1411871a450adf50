// The first lines of a text file, cut into cells by one separator.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/csv_layout.hpp"
#include "workbench/recording/spelling/cell_number.hpp"

namespace workbench {

/// A line that is not blank.
struct SampleLine {
  std::string_view text;
  std::size_t offset;
  std::size_t line;  ///< from 1
};

enum class CellKind { kEmpty, kNumber, kDateTime, kDate, kClock, kBad, kText };

/// What a cell holds; a number may have a unit behind it, and a word that stands for a
/// missing value is kBad.
[[nodiscard]] CellKind kind_of(std::string_view cell);

/// Tells how many columns there are, what they hold, and where the rows begin: the width
/// is that of most of the later lines, and the first row the first line that has numbers
/// and times where they have. Lines must outlive it. About 1 µs a cell.
class LineTable {
 public:
  LineTable(const std::vector<SampleLine>& lines, char separator);

  [[nodiscard]] char separator() const { return separator_; }
  [[nodiscard]] std::size_t width() const { return width_; }
  /// Index of the first row; where has_rows() is false, the number of lines.
  [[nodiscard]] std::size_t first_row() const { return first_row_; }
  [[nodiscard]] std::size_t lines() const { return cells_.size(); }
  [[nodiscard]] bool has_rows() const { return first_row_ < cells_.size(); }
  [[nodiscard]] const std::vector<LineCell>& cells(std::size_t line) const {
    return cells_[line];
  }
  [[nodiscard]] Content content(std::size_t column) const {
    return column < contents_.size() ? contents_[column] : Content::kNothing;
  }
  /// The cell of the first row; "" where there is none.
  [[nodiscard]] std::string_view first(std::size_t column) const {
    return has_rows() && column < cells_[first_row_].size()
               ? cells_[first_row_][column].text
               : std::string_view();
  }
  /// Share of the rows that say the same there as the one before; 1 with less than two.
  [[nodiscard]] double held(std::size_t column) const;
  /// Of each row the first that says the same there; rows count from the first one.
  [[nodiscard]] std::vector<std::uint16_t> same_as(std::size_t column) const;
  /// The rows hold numbers there that rise by the same step, as times and row numbers do.
  [[nodiscard]] bool counts(std::size_t column) const;
  /// Columns that hold values, times counting twice: the better separator has more.
  [[nodiscard]] std::size_t merit() const;
  [[nodiscard]] NumberStyle style() const;
  /// All rows have width() cells; there are at least five.
  [[nodiscard]] bool even() const;
  /// Some cell of the line is text: no number, no time, no mark of a missing value.
  [[nodiscard]] bool is_text(std::size_t line) const;

 private:
  void find_width();
  [[nodiscard]] bool holds_dotted_clocks(std::size_t column) const;
  void mark_clocks(std::size_t column);
  void find_contents();
  void find_first_row();
  [[nodiscard]] bool is_whole(std::size_t line) const;
  [[nodiscard]] bool is_names(std::size_t line) const;
  [[nodiscard]] bool is_row(std::size_t line) const;

  char separator_;
  std::vector<std::vector<LineCell>> cells_;
  std::vector<std::vector<CellKind>> kinds_;
  std::vector<Content> contents_;
  std::size_t width_ = 1;
  std::size_t first_row_ = 0;
};

}  // namespace workbench
