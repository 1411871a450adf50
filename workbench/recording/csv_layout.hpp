// Where the columns of a text file are, told from its first lines.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/column_name.hpp"
#include "workbench/recording/recording.hpp"
#include "workbench/recording/spelling/cell_number.hpp"

namespace workbench {

/// What the cells of a column hold, in most of the first rows.
enum class Content { kNothing, kNumber, kDateTime, kDate, kClock, kText };

[[nodiscard]] constexpr bool is_time(Content content) {
  return content == Content::kDateTime || content == Content::kDate ||
         content == Content::kClock;
}

struct LayoutColumn {
  ColumnName name;
  std::size_t column = 0;  ///< of the name in its line, in bytes, from 1
  Content content = Content::kNothing;
  bool counts = false;  ///< the first rows hold numbers that rise evenly
  double held = 0;      ///< share of the first rows that say the same as the one before
  std::string first;    ///< the cell of the first row
  /// Of each of the first rows the first that says the same; empty for plain numbers.
  std::vector<std::uint16_t> same_as;
  /// A tag that all of the first rows name, and later ones do not; or that tells the
  /// tables of one file apart (later_texts.hpp).
  bool changes_later = false;
  /// The first rows all say the same.
  [[nodiscard]] bool rests() const { return held == 1; }
};

struct CsvLayout {
  char separator = ',';
  std::vector<LayoutColumn> columns;
  std::size_t most_cells = 0;        ///< that a row may have: columns, or names
  std::size_t header_line = 1;       ///< from 1
  std::string header;                ///< its line; "": there is none
  std::size_t first_row_line = 2;    ///< line of the first row of values
  std::size_t first_row_offset = 0;  ///< its first byte
  NumberStyle style;
  std::vector<std::string> notes;  ///< what was taken as meant
  std::string cut_names;  ///< of these that of names beyond the cells; empty: none
  /// Points may group thousands: semicolons and 13.05.2026 are of a decimal comma.
  [[nodiscard]] bool points_may_group() const {
    return separator == ';' && style.dotted_dates;
  }
  bool contract_names = false;  ///< the first line holds the contract's bare names
};

/// The first of the columns that fits.
template <class Fits>
[[nodiscard]] std::optional<std::size_t> first_column(
    const std::vector<LayoutColumn>& columns, Fits fits) {
  const auto found = std::ranges::find_if(columns, fits);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

/// The first column that rises evenly: it may be the time, or count the rows.
[[nodiscard]] std::optional<std::size_t> counter_of(const CsvLayout& layout);

/// What the caller looks for.
struct LayoutWish {
  std::vector<Column> required;      ///< with t where the rows must have a time
  std::vector<std::string> named;    ///< names of columns given by the user
  std::optional<char> decimal = {};  ///< '.' or ',': the other one groups thousands
};

/// Finds separator (comma, semicolon, tab or |, a line `sep=;` says it; blanks where
/// there is none of these), header and first row in the first kSampleLines lines. A first
/// line with the contract's bare names is the header. Otherwise the rows are where cells
/// of one count hold numbers and times like those further down; the header is among the
/// lines above, a row of units or descriptions may follow it or stand before it, and what
/// is above is a preamble. Names repeated under merged cells (Value, Value) get the name
/// above in front. Without a header the columns are called #1, #2, …. Cost: under 20 ms,
/// and a walk through the rows where a column of tags rests in the first of them.
inline constexpr std::size_t kSampleLines = 150;
[[nodiscard]] CsvLayout layout_of(std::string_view text, const std::string& file,
                                  const LayoutWish& wish);

}  // namespace workbench
