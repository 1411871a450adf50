#include "workbench/recording/formats/record_blocks.hpp"

#include <cstddef>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/formats/named_rows.hpp"

namespace workbench {
namespace {

constexpr std::size_t kHeadWithin = 10;  // lines

bool is_head(std::string_view line) {
  if (line.starts_with('+')) line.remove_prefix(1);
  return line.starts_with("-[ RECORD ");
}

bool has_head(std::string_view text) {
  for (std::size_t i = 0; i < kHeadWithin && !text.empty(); ++i) {
    if (is_head(take_line(text))) return true;
  }
  return false;
}

// Its frame, where it has one.
std::string_view without_border(std::string_view line) {
  if (!line.starts_with('|')) return line;
  line.remove_prefix(1);
  if (line.ends_with('|')) line.remove_suffix(1);
  return line;
}

}  // namespace

std::optional<std::string> record_blocks_text(std::string_view text) {
  if (!has_head(text)) return std::nullopt;
  NamedRows rows;
  bool begun = false;
  while (!text.empty()) {
    std::string_view line = take_line(text);
    if (is_head(line)) {
      rows.end_row();
      begun = true;
      continue;
    }
    line = without_border(line);
    const std::size_t bar = line.find('|');
    if (!begun || bar == std::string_view::npos) continue;
    const std::string_view name = trimmed(line.substr(0, bar));
    if (!name.empty()) rows.put(name, trimmed(line.substr(bar + 1)));
  }
  rows.end_row();
  const bool is_table = rows.rows() > 0 && !rows.is_full();
  return is_table ? std::optional(rows.text()) : std::nullopt;
}

}  // namespace workbench
