// What the name of a column or tag says: tag, signal, unit.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/recording.hpp"
#include "workbench/recording/spelling/column_words.hpp"

namespace workbench {

/// A name taken apart. Keys are in lower case without anything but letters and digits,
/// with ä, ö, ü, ß written ae, oe, ue, ss: FIC-101/PV and fic101.pv have one key.
struct ColumnName {
  std::string text;    ///< as written, in UTF-8, without quotes
  std::string unit;    ///< in brackets or behind a blank: m3/h, %, °C; "" if none
  std::string key;     ///< whole name without unit and without .Value, .CV, avg
  std::string prefix;  ///< what stands before the part, as written: FIC-101
  std::string tag;     ///< its key: fic101; "" where the name is only a part
  std::string loop;    ///< what loop_of_tag() makes of it: f101 for FIC101.PIDA and FT101
  std::vector<std::string> pieces;  ///< keys of the pieces between separators
  Part part = Part::kNone;
  std::size_t words_cut = 0;  ///< of .Value, .CV, avg, raw behind the part
  bool by_letters = false;    ///< FT-211, FV-211: the letters of the instrument say so
};

/// Takes a name apart: pieces between . / \ : _ - | and blanks; a trailing unit in [],
/// (), {}, after a comma, " in " or a blank; trailing words for "the value" go.
[[nodiscard]] ColumnName column_name(std::string_view text);

/// The Column that a bare name of the contract means: t, u, OP, y, PV, sp, x, MV, POS, in
/// any case.
[[nodiscard]] std::optional<Column> role_of(std::string_view name);

/// "a column u (or OP)", for messages.
[[nodiscard]] std::string with_aliases(Column column);

}  // namespace workbench
