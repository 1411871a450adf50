// The rows of a file, of each only the cells that are wanted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/csv_layout.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// Walks through the rows behind the header. In a plain file every row has as many cells
/// as the header, and no empty line stands between rows, but above the header once more;
/// a last row without a line end, of a file that was cut off, may be too short: it is
/// left out, and noted. In an export empty lines are skipped, cells beyond the header may
/// be empty, cells may lack at the end where nothing wanted stands, and up to
/// kMostFooterLines lines at the end may be no rows at all (a count of rows, a
/// signature): they are noted. So are lines of words between the rows (is_remark()),
/// at most one for ten rows, unless rows are counted. About 1 ns a byte.
inline constexpr std::size_t kMostFooterLines = 5;

class RowScanner {
 public:
  /// Wants the cells of `columns`, which are indices; everything must outlive this.
  /// `counted`: rows have no times, so that a line between them may stand for one.
  RowScanner(std::string_view text, const std::string& file, const CsvLayout& layout,
             std::vector<std::size_t> columns, bool plain, bool counted = false);

  /// To the next row; false at the end. Throws InputError.
  bool next();

  /// Cell number `slot` of the wanted columns; empty where the row is too short.
  [[nodiscard]] std::string_view cell(std::size_t slot) const {
    return found_[slot].text;
  }
  [[nodiscard]] std::size_t column(std::size_t slot) const { return found_[slot].column; }
  /// Between the row before and this one the header stands once more.
  [[nodiscard]] bool is_behind_head() const { return behind_head_; }
  [[nodiscard]] std::uint32_t line() const { return static_cast<std::uint32_t>(line_); }

  /// An error at this row and the cell of `slot`.
  [[nodiscard]] InputError error(std::size_t slot, std::string expected,
                                 std::string found, std::string advice) const;
  /// This row is none: `why` is thrown if rows follow, at once in a plain file.
  void reject(const InputError& why);
  /// This row is one. Throws what was rejected before it.
  void accept();
  /// After the last row: throws what was rejected, unless it is a footer; adds notes.
  void finish(std::vector<std::string>& notes);

  /// About how many rows are left.
  [[nodiscard]] std::size_t likely_rows() const;

 private:
  struct Found {
    std::string_view text;
    std::size_t column = 0;
  };
  [[nodiscard]] bool is_remark() const;
  // No row, but what stood above the first one; the reader is behind it then.
  bool skip_head();
  // Takes the cells of a line; false: nothing in it.
  bool take_line();
  [[nodiscard]] std::optional<InputError> wrong_count() const;
  // The last line of all, too short and without its end.
  [[nodiscard]] bool is_cut_off() const;

  std::string_view text_;
  const std::string& file_;
  const CsvLayout& layout_;
  CellReader reader_;
  std::vector<std::int32_t> slot_of_;  // by column; -1: not wanted
  std::size_t needed_ = 0;             // columns up to the last wanted
  bool plain_;
  bool counted_;
  bool first_ = true;
  bool behind_head_ = false;
  std::vector<Found> found_;
  std::size_t line_ = 0;
  std::size_t row_offset_ = 0;
  std::size_t cells_ = 0;         // of this row
  std::size_t first_cells_ = 0;   // of the first row
  std::size_t filled_cells_ = 0;  // up to the last that is not empty
  std::size_t end_column_ = 0;
  std::size_t empty_line_ = 0;  // the first before a row
  // Lines that are no rows.
  struct Rejected {
    std::optional<InputError> first;
    std::string text;  // of the first
    std::size_t lines = 0;
  };
  Rejected rejected_;                // since the last row
  std::optional<InputError> wrong_;  // the first of these that is no remark
  std::size_t wrong_lines_ = 0;
  Rejected remarks_;  // between the rows
  std::size_t rows_ = 0;
};

/// Whether a line that is no row is none without doubt: `cells` are those of the wanted
/// columns, from the left, `first` that of the first row in the leftmost of them. One of
/// them alone says something, and no number (`--- shift change ---`, `Page of shift B`);
/// or the leftmost is Average, Min, Total or the like; or the line begins with a mark.
/// Not where a cell is the name of a column or a unit that none has, for the columns may
/// be others there, and not where rows begin with letters themselves, but with a mark.
/// `behind_head`: the header stands above once more, and units may follow it.
[[nodiscard]] bool is_remark(std::span<const std::string_view> cells,
                             std::string_view first, const CsvLayout& layout,
                             bool behind_head);

}  // namespace workbench
