#include "workbench/recording/csv_header.hpp"

#include <array>
#include <utility>

namespace workbench {

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

int role_of(std::string_view name) {
  std::string lower(name);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  constexpr std::array<std::pair<std::string_view, Column>, 9> kNames = {{
      {"t", Column::t},
      {"u", Column::u},
      {"op", Column::u},
      {"y", Column::y},
      {"pv", Column::y},
      {"sp", Column::sp},
      {"x", Column::x},
      {"mv", Column::x},
      {"pos", Column::x},
  }};
  for (const auto& [known, column] : kNames) {
    if (lower == known) return static_cast<int>(column);
  }
  return kIgnoredColumn;
}

std::string with_aliases(Column column) {
  switch (column) {
    case Column::u:
      return "a column u (or OP)";
    case Column::y:
      return "a column y (or PV)";
    case Column::x:
      return "a column x (or MV, POS)";
    case Column::sp:
      return "a column sp";
    case Column::t:
      break;
  }
  return "a column t (time in seconds)";
}

std::vector<HeaderCell> split_header(std::string_view line, char separator) {
  std::vector<HeaderCell> cells;
  std::size_t at = 0;
  while (cells.size() <= kMostHeaderCells) {
    const std::size_t start = at;
    bool in_quotes = false;
    while (at < line.size() && (in_quotes || line[at] != separator)) {
      if (line[at] == '"') in_quotes = !in_quotes;
      ++at;
    }
    std::string_view raw = trimmed(line.substr(start, at - start));
    if (raw.size() >= 2 && raw.front() == '"' && raw.back() == '"') {
      raw = trimmed(raw.substr(1, raw.size() - 2));
    }
    cells.push_back({std::string(raw), start + 1});
    if (at >= line.size()) break;
    ++at;
  }
  return cells;
}

}  // namespace workbench
