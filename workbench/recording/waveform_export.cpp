#include "workbench/recording/waveform_export.hpp"

#include <algorithm>
#include <cstddef>
#include <system_error>

#include "workbench/recording/cell_number.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr std::string_view kEndOfHead = "***End_of_Header***";

// What stands behind `key` and a separator at the start of a line; nothing without one.
std::optional<std::string_view> said(std::string_view head, std::string_view key) {
  for (std::size_t at = 0; at < head.size();) {
    const std::size_t end = std::min(head.find('\n', at), head.size());
    std::string_view line = head.substr(at, end - at);
    at = end + 1;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with(key) && line.size() > key.size() + 1) {
      return line.substr(key.size() + 1);
    }
  }
  return std::nullopt;
}

// The one number that all cells are.
std::optional<double> common_number(std::string_view cells, char separator) {
  std::string first(cells.substr(0, cells.find(separator)));
  for (std::size_t at = 0; at < cells.size();) {
    const std::size_t end = std::min(cells.find(separator, at), cells.size());
    const std::string_view cell = cells.substr(at, end - at);
    if (!cell.empty() && cell != first) return std::nullopt;
    at = end + 1;
  }
  std::replace(first.begin(), first.end(), ',', '.');
  return as_number(first);
}

}  // namespace

std::optional<std::string> waveform_text(std::string_view text) {
  const std::size_t end_of_head = text.rfind(kEndOfHead);
  if (!text.starts_with("LabVIEW Measurement") || end_of_head == std::string_view::npos) {
    return std::nullopt;
  }
  // One for the file, one for the channels; more are of further segments.
  const std::size_t first = text.find(kEndOfHead);
  if (text.find(kEndOfHead, first + 1) != end_of_head) return std::nullopt;
  const std::string_view head = text.substr(0, end_of_head);
  if (said(head, "X_Columns") != "No") return std::nullopt;
  const char separator = said(head, "Separator") == "Comma" ? ',' : '\t';
  const std::optional<std::string_view> delta = said(head, "Delta_X");
  const std::optional<double> step = common_number(delta.value_or(""), separator);
  const std::optional<double> start =
      common_number(said(head, "X0").value_or("0"), separator);
  if (!step || !start || !(*step > 0)) return std::nullopt;
  const bool comma = said(head, "Decimal_Separator") == ",";
  const std::size_t names = std::min(text.find('\n', end_of_head), text.size() - 1) + 1;
  const std::size_t rows = std::min(text.find('\n', names), text.size() - 1) + 1;
  std::string out(text.substr(0, rows));
  double row = 0;
  for (std::size_t at = rows; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    const std::string_view line = text.substr(at, end - at);
    if (line[0] == separator) {
      std::string time = number(*start + row++ * *step, 12);
      if (comma) std::replace(time.begin(), time.end(), '.', ',');
      out += time;
    }
    out += line;
    at = end;
  }
  return row > 0 ? std::optional(out) : std::nullopt;
}

}  // namespace workbench
