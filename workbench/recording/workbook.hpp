// The table in a workbook, as text.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace workbench {

struct NamedSheet {
  std::string name;
  std::string_view text;
};

/// Which sheet is meant, where several hold rows.
struct SheetChoice {
  std::string name = {};  ///< given by the user; "": the one that fits
  /// Whether a sheet has the columns; without it none is preferred.
  std::function<bool(std::string_view text)> fits = {};
  /// All that hold rows as one table, where none has the columns alone; nothing: they
  /// are none.
  std::function<std::optional<std::string>(const std::vector<NamedSheet>&)> join = {};
  std::string note = {};      ///< out: which one of several was taken, or which joined
  bool joined = false;        ///< out: the lines of the text are those of no sheet
  std::stop_token stop = {};  ///< asks for an end: Stopped is thrown
};

/// True for the first bytes of a zip archive, which xlsx and ods workbooks are.
[[nodiscard]] bool is_zip(std::string_view bytes);

/// The sheet of an xlsx (ECMA-376) or ods workbook (open_document.hpp) that holds the
/// rows, as tab-separated text: a line a row of the sheet, numbers as they are stored,
/// numbers shown as dates as 2026-05-13 14:30:00.250, times of day as 14:30:00.250,
/// durations in s. Hidden sheets are left out. Throws InputError naming `file` for
/// another or a damaged archive, for no sheet with cells, for none or several that fit or
/// are so named and `join` has nothing for them, and for more than 512 MiB of text. About
/// 0.3 µs a cell; memory is that of the text and of the shared words.
[[nodiscard]] std::string workbook_text(std::string_view bytes, const std::string& file,
                                        SheetChoice& choice);

}  // namespace workbench
