// A sheet of a workbook as text, and the sheets of an OpenDocument spreadsheet (ods).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "workbench/recording/formats/zip_parts.hpp"

namespace workbench {

/// The rows of a sheet as lines, their cells with tabs between them. Bounded: beyond 2^20
/// rows and 16384 columns cells are left out.
class SheetText {
 public:
  static constexpr std::size_t kMostText = std::size_t{512} << 20;

  /// Rows count from 1 and ascend; those between are blank lines.
  void begin_row(std::size_t row);
  /// Columns count from 0 and ascend. White space within `cell` becomes blanks, its
  /// quotes are single ones.
  void put(std::size_t column, std::string_view cell);
  void end_row();

  [[nodiscard]] const std::string& text() const { return text_; }
  /// Rows with two cells or more.
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t lines() const { return lines_; }
  /// The text itself; nothing is left of it.
  [[nodiscard]] std::string take() { return std::move(text_); }
  /// kMostText: nothing more is wanted.
  [[nodiscard]] bool is_full() const;

 private:
  std::string text_;
  std::size_t rows_ = 0;
  std::size_t lines_ = 0;
  std::size_t cells_ = 0;   // of this row, up to the last written
  std::size_t widest_ = 0;  // of the rows so far
  std::size_t filled_ = 0;  // of this row
};

/// One sheet of a workbook.
struct SheetTable {
  std::string name;
  SheetText text;
};

/// The sheets of content.xml (OASIS OpenDocument 1.3, part 3), in their order: numbers
/// and dates as they are stored, times of day as 14:30:00, all else as it is shown.
/// Hidden ones count as well. Throws InputError where it is damaged.
[[nodiscard]] std::vector<SheetTable> sheets_of_open_document(const ZipParts& archive);

}  // namespace workbench
