// The table in an Excel workbook, as text.
#pragma once

#include <string>
#include <string_view>

namespace workbench {

/// True for the first bytes of a zip archive, which an xlsx workbook is.
[[nodiscard]] bool is_zip(std::string_view bytes);

/// The sheet of an xlsx workbook (ECMA-376) that holds the rows, as tab-separated text: a
/// line a row of the sheet, numbers as they are stored, numbers shown as dates as
/// 2026-05-13 14:30:00.250, times of day as 14:30:00.250, durations in s. Hidden sheets
/// are left out. Throws InputError naming `file` for another or a damaged archive, for no
/// sheet with cells, for several that hold rows (which one is meant?), and for more than
/// 512 MiB of text. About 0.3 µs a cell; memory is that of the text and of the shared
/// words.
[[nodiscard]] std::string workbook_text(std::string_view bytes, const std::string& file);

}  // namespace workbench
