// From the bytes of a file to text in UTF-8, or the reason why they are no text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "workbench/recording/workbook.hpp"

namespace workbench {

/// `bytes` without a byte-order mark. UTF-16 (either order, with or without mark) and a
/// sheet of a workbook (workbook.hpp) are converted into `storage`, which then backs the
/// result, as are exports of a scope, of LabVIEW and of InfluxDB (scope_export.hpp,
/// labview_export.hpp, line_protocol.hpp); all else is handed back as it stands,
/// Windows-1252 included: utf8_of() turns its names into UTF-8. Throws InputError naming
/// `file` for what is no text but known by its first bytes (a Parquet file, a web page,
/// ...), with the way to save it as CSV, and for UTF-16 that is cut off. Converting
/// UTF-16 takes about 2 ns a byte.
[[nodiscard]] std::string_view text_of(std::string_view bytes, const std::string& file,
                                       std::string& storage);
/// The same with a choice among the sheets of a workbook. Throws std::invalid_argument
/// where one is named and `bytes` are none.
[[nodiscard]] std::string_view text_of(std::string_view bytes, const std::string& file,
                                       std::string& storage, SheetChoice& sheet);

/// Bytes of the UTF-8 character that begins at `at`; 0 where there is none.
[[nodiscard]] std::size_t utf8_length(std::string_view text, std::size_t at);

/// `text` as it stands where it is UTF-8, otherwise read as Windows-1252.
[[nodiscard]] std::string utf8_of(std::string_view text);

}  // namespace workbench
