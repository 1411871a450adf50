#include "workbench/recording/formats/scope_export.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "wire/text.hpp"
#include "workbench/recording/cell_reader.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMostLines = 60;
constexpr std::size_t kFileTimeDigits = 18;  // 100 ns from 1601

using Cells = std::vector<std::string_view>;

Cells cells_of(std::string_view line, char separator) {
  Cells out;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(separator, at), line.size());
    out.push_back(line.substr(at, end - at));
    at = end + 1;
  }
  return out;
}

// Some versions end lines with a separator.
void drop_blank_end(Cells& cells, std::size_t width) {
  while (cells.size() > width && cells.back().empty()) cells.pop_back();
}

// What stands above the rows: a line for each attribute, its key where the time of a
// group of signals stands below: "Name;a;Name;b;c".
class ScopeHeader {
 public:
  [[nodiscard]] bool started() const { return !names_.empty(); }
  // The name of the project stands above, alone.
  void start(Cells cells) {
    drop_blank_end(cells, 0);
    if (cells.size() > 2 && cells[0] == "Name") names_ = std::move(cells);
  }

  /// False where the line is none of an attribute.
  bool add(Cells cells) {
    drop_blank_end(cells, width());
    if (cells.size() != width()) return false;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (is_time(c) && cells[c] != cells[0]) return false;
    }
    const std::string_view key = cells[0];
    is_scope_ = is_scope_ || key == "Unit ScaleFactor" || key == "SampleTime[ms]" ||
                key == "SymbolBased";
    if (key == "Unit") {
      units_ = std::move(cells);
    } else if (key == "ScaleFactor" || key == "Unit ScaleFactor" || key == "Offset" ||
               key == "Unit Offset") {
      scales_.push_back(std::move(cells));
    }
    return true;
  }
  [[nodiscard]] bool is_scope() const { return is_scope_; }
  [[nodiscard]] std::size_t width() const { return names_.size(); }

  /// `time`: the name of the times.
  [[nodiscard]] std::string text(char separator, std::string_view time) const {
    std::string out;
    for (std::size_t c = 0; c < names_.size(); ++c) {
      if (c > 0) out += separator;
      out += is_time(c) ? std::string(time) : name_of(c);
    }
    return out;
  }

 private:
  [[nodiscard]] bool is_time(std::size_t c) const { return names_[c] == "Name"; }

  // With its unit, and with what its values may still want: to scale them is an option of
  // the export that the file does not tell.
  [[nodiscard]] std::string name_of(std::size_t c) const {
    std::string out(names_[c]);
    for (const Cells& scale : scales_) {
      const std::string_view none = scale[0].ends_with("Offset") ? "0" : "1";
      if (scale[c] != none) (((out += ' ') += scale[0]) += ' ') += scale[c];
    }
    if (!units_.empty() && !units_[c].empty() && units_[c] != "(None)") {
      ((out += " [") += units_[c].substr(0, units_[c].find(" ("))) += ']';
    }
    return out;
  }

  Cells names_;
  Cells units_;
  std::vector<Cells> scales_;
  bool is_scope_ = false;
};

std::optional<std::string> read_with(std::string_view text, char separator) {
  ScopeHeader header;
  std::size_t lines = 0;
  while (!text.empty() && lines < kMostLines) {
    const std::string_view rest = text;
    const std::string_view line = take_whole_line(text);
    Cells cells = cells_of(line, separator);
    if (header.started() && !line.empty() && wire::is_digit(line[0])) {
      drop_blank_end(cells, header.width());
      if (!header.is_scope() || cells.size() != header.width()) return std::nullopt;
      std::string out(lines - 1, '\n');
      const bool absolute = cells[0].size() >= kFileTimeDigits;
      ((out += header.text(separator, absolute ? "Time" : "t [ms]")) += '\n') += rest;
      return out;
    }
    if (!header.started()) {
      header.start(std::move(cells));
    } else if (!line.empty() && !header.add(std::move(cells))) {
      return std::nullopt;
    }
    ++lines;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> scope_text(std::string_view text) {
  if (!text.starts_with("Name")) return std::nullopt;
  for (const char separator : {';', '\t', ','}) {
    if (auto out = read_with(text, separator)) return out;
  }
  return std::nullopt;
}

}  // namespace workbench
