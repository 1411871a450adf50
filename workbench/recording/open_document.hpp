// The sheets of an OpenDocument spreadsheet (ods).
#pragma once

#include <string>
#include <vector>

#include "workbench/recording/sheet_text.hpp"
#include "workbench/recording/zip_parts.hpp"

namespace workbench {

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
