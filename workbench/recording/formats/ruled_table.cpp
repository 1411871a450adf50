#include "workbench/recording/formats/ruled_table.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "workbench/recording/cell_reader.hpp"

namespace workbench {
namespace {

constexpr std::size_t kRulerWithin = 30;  // lines

bool is_ruler(std::string_view line) {
  line = trimmed(line);
  return line.find(' ') != std::string_view::npos && line.starts_with("--") &&
         line.find_first_not_of("- ") == std::string_view::npos;
}

// Where the groups of dashes begin, in characters.
std::vector<std::size_t> columns_of(std::string_view ruler) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < ruler.size(); ++i) {
    if (ruler[i] == '-' && (i == 0 || ruler[i - 1] != '-')) out.push_back(i);
  }
  return out;
}

// Bytes of the first `characters` of a line of UTF-8.
std::size_t bytes_of(std::string_view line, std::size_t characters) {
  std::size_t at = 0;
  for (; at < line.size(); ++at) {
    const bool begins = (static_cast<unsigned char>(line[at]) & 0xC0) != 0x80;
    if (begins && characters-- == 0) break;
  }
  return at;
}

void append_cut(std::string_view line, const std::vector<std::size_t>& columns,
                std::string& out) {
  std::size_t from = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::size_t to =
        i + 1 < columns.size() ? bytes_of(line, columns[i + 1]) : line.size();
    if (i > 0) out += '\t';
    out += trimmed(line.substr(from, to - from));
    from = to;
  }
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) lines.push_back(take_whole_line(text));
  return lines;
}

constexpr std::size_t kLongestLine = 4096;

bool is_blank(std::string_view line) {
  return trimmed(line).empty();
}

std::size_t words_in(std::string_view line) {
  std::size_t words = 0;
  bool blank = true;
  for (const char c : line) {
    words += blank && c != ' ';
    blank = c == ' ';
  }
  return words;
}

// Where the stretches begin that are not blank in some line, in characters; empty where
// the lines are too long for a table that is to be read by people.
std::vector<std::size_t> stretches_of(const std::vector<std::string_view>& lines) {
  std::vector<bool> filled;
  for (const std::string_view line : lines) {
    if (line.size() > kLongestLine) return {};
    std::size_t at = 0;
    for (const char c : line) {
      if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) continue;
      if (filled.size() <= at) filled.resize(at + 1, false);
      if (c != ' ') filled[at] = true;
      ++at;
    }
  }
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < filled.size(); ++i) {
    if (filled[i] && (i == 0 || !filled[i - 1])) out.push_back(i);
  }
  return out;
}

}  // namespace

std::optional<std::string> fixed_width_text(std::string_view text) {
  const std::string_view names = text.substr(0, text.find_first_of("\r\n"));
  const std::size_t columns = words_in(names);
  if (columns < 2 || names.find_first_of(",;\t|") != std::string_view::npos) {
    return std::nullopt;
  }
  const std::vector<std::string_view> lines = lines_of(text);
  const bool is_short = std::ranges::any_of(
      lines, [=](std::string_view l) { return !is_blank(l) && words_in(l) < columns; });
  const bool tabs = text.find('\t') != std::string_view::npos;
  if (!is_short || tabs) return std::nullopt;
  const std::vector<std::size_t> stretches = stretches_of(lines);
  if (stretches.size() != columns) return std::nullopt;
  std::string out;
  out.reserve(text.size());
  for (const std::string_view line : lines) {
    if (!is_blank(line)) append_cut(line, stretches, out);
    out += '\n';
  }
  return out;
}

std::optional<std::string> ruled_text(std::string_view text) {
  if (text.find("-- --") == std::string_view::npos &&
      text.find("--  --") == std::string_view::npos) {
    return std::nullopt;
  }
  const std::vector<std::string_view> lines = lines_of(text);
  const auto last =
      lines.begin() + static_cast<std::ptrdiff_t>(std::min(kRulerWithin, lines.size()));
  const auto ruler = std::find_if(lines.begin(), last, is_ruler);
  if (ruler == last || ruler == lines.begin() || trimmed(*(ruler - 1)).empty()) {
    return std::nullopt;
  }
  const std::vector<std::size_t> columns = columns_of(*ruler);
  const std::string_view names = *(ruler - 1);
  std::string out;
  out.reserve(text.size());
  for (auto line = lines.begin(); line != lines.end(); ++line) {
    if (line == ruler) {
      append_cut(names, columns, out);
    } else if (line < ruler - 1) {
      out += *line;
    } else if (*line != names && !is_ruler(*line) && !trimmed(*line).empty()) {
      append_cut(*line, columns, out);
    }
    out += '\n';
  }
  return out;
}

}  // namespace workbench
