// Walks through separated text, cell by cell and line by line.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "wire/text.hpp"

namespace workbench {

inline constexpr std::size_t kMostHeaderCells = 4096;

using wire::is_line_end;
using wire::trimmed;

/// The first line of a text, without its end, LF or CRLF; it goes from the text with it.
[[nodiscard]] std::string_view take_whole_line(std::string_view& text);

/// Splits one line; a quoted cell may contain the separator, and the id of an OPC UA node
/// a semicolon. Several blanks separate
/// once, and those at the ends of the line do not. Never throws; at most kMostHeaderCells
/// + 1 cells.
struct LineCell {
  std::string_view text;  ///< without quotes and the blanks around them
  std::size_t column;     ///< in bytes, from 1
};
[[nodiscard]] std::vector<LineCell> split_line(std::string_view line, char separator);

/// Line breaks that a cell in quotes may hold.
inline constexpr int kMostBreaks = 8;

/// A cursor in `text`, which must outlive it. Lines end with LF, CRLF or CR. A cell
/// may stand in quotes, a quote inside written twice; blanks around it go. Quotes must
/// close within kMostBreaks lines. About 1 ns a byte.
class CellReader {
 public:
  /// `file` stands in messages and must outlive this; `text` begins with line `line`.
  CellReader(std::string_view text, const std::string& file, std::size_t line = 1);

  [[nodiscard]] bool at_end() const { return at_ >= end_; }
  [[nodiscard]] std::size_t line() const { return line_; }
  /// Bytes of text before the cell last taken.
  [[nodiscard]] std::size_t cell_offset() const {
    return static_cast<std::size_t>(cell_start_ - begin_);
  }
  /// Column of the cell last taken, and of the cursor; in bytes, from 1.
  [[nodiscard]] std::size_t cell_column() const { return column_of(cell_start_); }
  [[nodiscard]] std::size_t column() const { return column_of(at_); }

  [[nodiscard]] std::string_view rest_of_line() const {
    return {at_, static_cast<std::size_t>(std::find_if(at_, end_, is_line_end) - at_)};
  }
  [[nodiscard]] bool starts_with(std::string_view text) const {
    return std::string_view(at_, end_).starts_with(text);
  }
  void skip_rest_of_line() { at_ += rest_of_line().size(); }
  /// From the end of a line to the start of the next.
  void next_line();

  /// Consumes one cell up to the separator or the end of the line. Throws InputError.
  std::string_view take_cell(char separator);
  /// Consumes a separator; false at the end of the line.
  bool take_separator(char separator) {
    if (at_ >= end_ || *at_ != separator) return false;
    ++at_;
    return true;
  }

 private:
  std::string_view take_quoted_cell(char separator, char blank);
  [[nodiscard]] std::size_t column_of(const char* at) const {
    return static_cast<std::size_t>(at - line_start_) + 1;
  }

  const std::string* file_;
  const char* begin_;
  const char* at_;
  const char* end_;
  const char* line_start_;
  const char* cell_start_;
  std::size_t line_;
};

/// From where `reader` stands to the end of the line, or, where a quoted cell holds line
/// breaks, to the end of the line on which it closes. Moves the reader there.
[[nodiscard]] std::string_view whole_line(CellReader& reader);

/// Line breaks within a text.
[[nodiscard]] std::size_t breaks_in(std::string_view text);

}  // namespace workbench
