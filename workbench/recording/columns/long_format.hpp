// Which columns of a file hold tag, value and quality where each row is one sample, and
// which tell the rows of one signal, or of one loop, from those of another.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "workbench/recording/csv_layout.hpp"

namespace workbench {

/// Columns of a long format.
struct LongFormat {
  std::size_t tag = 0;
  std::optional<std::size_t> parameter;  ///< of the tag, in a column of its own
  std::size_t value = 0;
  std::optional<std::size_t> whole;  ///< values of tags that are whole numbers
  std::optional<std::size_t> quality;
  std::optional<std::size_t> unit;  ///< of the value, in words
};

/// Numbers that count rows are no signal.
[[nodiscard]] bool is_measured(const LayoutColumn& column);

/// No word for a quality, a mode or a unit.
[[nodiscard]] bool may_name_tag(std::string_view cell);

/// Tells a long format by a tag and a value column, without a controller output beside
/// them. The tag column has a name of tags, or is the only kind of text that changes; of
/// numbers only by a name of numbered tags. A column of parameters beside it names what
/// of the tag is meant: FIC101 and OP. The value column has a name of values, or one of
/// the process value (with one of whole numbers beside it, as Ignition stores them), or
/// is an average, or is the only one of numbers. Without a header
/// the first text column is that of the tags where its first cell names a signal, or may
/// name a tag and stands beside a time and a number alone.
/// `times`: the columns that make the time of a row, at least one.
[[nodiscard]] std::optional<LongFormat> long_format(
    const CsvLayout& layout, const std::vector<std::size_t>& times);

/// Columns of text that have to be read beside `given` (those of a long format; none) to
/// know whose row it is, told from the first rows: loop, device, element, ... A column
/// counts
/// - where rows of one tag repeat a time with another text, and with the text none does;
/// - where its texts take turns from row to row;
/// - where it has a name of tags and changes often, or says one tag in all of the first
///   rows and another one later.
/// What says how good a value is, or in which state a loop, does neither. `times`: the
/// columns that make the time of a row. In the order of the columns, `given` among them,
/// those that name a part of what others name (field, attribute, parameter) last.
/// O(columns of text · rows).
[[nodiscard]] std::vector<std::size_t> row_keys(const CsvLayout& layout,
                                                const std::vector<std::size_t>& times,
                                                const std::vector<std::size_t>& given);

}  // namespace workbench
