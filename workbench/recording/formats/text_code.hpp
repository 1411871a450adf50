// Texts in the codes of systems that do not write UTF-8.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// Of a text whose first 64 KiB are no UTF-8: the whole of it in UTF-8, from the code in
/// which most of its cells beyond ASCII are words for columns or qualities, or times with
/// words in them: Shift-JIS, EUC-JP, GBK,
/// Big5, Korean, Windows-1250, -1251 and -1254, code page 866, KOI8-R, ISO 8859-2.
/// Nothing: it is UTF-8, or no other code makes more words than Windows-1252, or the
/// system lacks the code.
[[nodiscard]] std::optional<std::string> recoded_text(std::string_view bytes);

}  // namespace workbench
