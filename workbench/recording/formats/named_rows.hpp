// Rows whose values stand beside their names, as a table.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace workbench {

/// The first line of a text, trimmed, which goes from it with its end.
[[nodiscard]] std::string_view take_line(std::string_view& text);

/// Collects name and value, row by row; a column each name, in the order in which they
/// come. Names and values are views of a text that has to outlive it.
class NamedRows {
 public:
  /// More columns than this are no table.
  static constexpr std::size_t kMostNames = 256;

  /// In the row that is open; of a name twice in a row the first value counts.
  void put(std::string_view name, std::string_view value);
  /// Begins a new row; a row without values is none.
  void end_row();

  [[nodiscard]] std::size_t rows() const { return ends_.size(); }
  /// There were more names than kMostNames.
  [[nodiscard]] bool is_full() const { return full_; }
  /// With tabs between the cells, the names in the first line; a value that a row lacks
  /// is blank. Quotes go, and of `\"` the backslash. Of ended rows only.
  [[nodiscard]] std::string text() const;

 private:
  struct Cell {
    std::size_t column;
    std::string_view value;
  };

  [[nodiscard]] std::size_t column_of(std::string_view name);

  std::vector<std::string_view> names_;
  std::vector<Cell> cells_;
  std::vector<std::size_t> ends_;  // of each row, in cells_
  std::size_t likely_ = 0;         // column of the next name
  bool full_ = false;
};

}  // namespace workbench
