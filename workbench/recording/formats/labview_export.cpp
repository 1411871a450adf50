#include "workbench/recording/formats/labview_export.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "wire/text.hpp"
#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/spelling/cell_number.hpp"
#include "workbench/recording/written_time.hpp"

namespace workbench {
namespace {

// What stands behind `key` and a separator at the start of a line; nothing without one.
std::optional<std::string_view> said(std::string_view head, std::string_view key) {
  while (!head.empty()) {
    const std::string_view line = take_whole_line(head);
    if (line.starts_with(key) && line.size() > key.size() + 1) {
      return line.substr(key.size() + 1);
    }
  }
  return std::nullopt;
}

// The one number that all cells are.
std::optional<double> common_number(std::string_view cells, char separator) {
  std::string first(cells.substr(0, cells.find(separator)));
  while (!cells.empty()) {
    const std::string_view cell = wire::take_until(cells, separator);
    if (!cell.empty() && cell != first) return std::nullopt;
  }
  std::ranges::replace(first, ',', '.');
  return wire::number_of<double>(first);
}

// Each row with the time that X0 and Delta_X of the head give it.
std::optional<std::string> with_times(std::string_view text) {
  const std::size_t end_of_head = text.rfind(kEndOfLabviewHead);
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
      if (comma) std::ranges::replace(time, '.', ',');
      out += time;
    }
    out += line;
    at = end;
  }
  return row > 0 ? std::optional(out) : std::nullopt;
}

// The rows of all segments under the names of the first, each line where it was.
class Segments {
 public:
  Segments(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

  std::string joined() {
    for (; !rest_.empty(); ++line_) read_line(take_whole_line(rest_));
    return std::move(out_);
  }

 private:
  void read_line(std::string_view line) {
    if (line.starts_with(kEndOfLabviewHead)) {
      ++heads_;
      names_next_ = heads_ > 1;
    } else if (names_next_) {
      begin_segment(line);
      names_next_ = false;
      in_rows_ = true;
    } else if (in_rows_ && trimmed(line).empty()) {
      in_rows_ = false;
      date_ = clock_ = {};
    } else if (in_rows_) {
      add_row(line);
    } else {
      read_head(line);
    }
    out_ += '\n';
  }

  void read_head(std::string_view line) {
    const std::vector<LineCell> cells = split_line(line, separator_);
    if (line.starts_with("Separator")) separator_ = line.ends_with("Comma") ? ',' : '\t';
    if (cells.size() < 2) return;
    if (cells[0].text == "Decimal_Separator")
      comma_ = line.ends_with("Comma") || cells[1].text == ",";
    if (cells[0].text == "Date") date_ = cells[1].text;
    if (cells[0].text == "Time") clock_ = cells[1].text;
  }

  void begin_segment(std::string_view names) {
    const auto time = written_time(std::string(date_) + ' ' + std::string(clock_));
    if (!names.starts_with("X_Value") || !time || !time->has_clock ||
        (!names_.empty() && names != names_)) {
      throw InputError(file_, line_, 1,
                       "segments of the same channels with X_Value, Date and Time",
                       quoted(names), "export one segment");
    }
    if (names_.empty()) {
      names_ = names;
      first_ = *time;
      out_ += names;
    }
    offset_s_ = 86400.0 * (time->day - first_.day) + (time->seconds - first_.seconds);
  }

  void add_row(std::string_view line) {
    const std::size_t end = std::min(line.find(separator_), line.size());
    std::string cell(trimmed(line.substr(0, end)));
    std::ranges::replace(cell, ',', '.');
    constexpr int kDigits = 12;
    if (const auto x = wire::number_of<double>(cell))
      cell = number(*x + offset_s_, kDigits);
    if (comma_) std::ranges::replace(cell, '.', ',');
    out_ += cell;
    out_ += line.substr(end);
  }

  std::string_view rest_;
  const std::string& file_;
  std::size_t line_ = 1;
  std::size_t heads_ = 0;  // of the file, then of segments
  bool names_next_ = false;
  bool in_rows_ = false;
  char separator_ = '\t';
  bool comma_ = false;
  std::string_view date_;
  std::string_view clock_;
  std::string_view names_;
  WrittenTime first_;
  double offset_s_ = 0;
  std::string out_;
};

}  // namespace

std::optional<std::string> labview_text(std::string_view text, const std::string& file) {
  if (!text.starts_with("LabVIEW Measurement")) return std::nullopt;
  // One head for the file, one for each segment.
  std::size_t heads = 0;
  for (std::size_t at = text.find(kEndOfLabviewHead);
       at != std::string_view::npos && heads < 3;
       at = text.find(kEndOfLabviewHead, at + 1)) {
    ++heads;
  }
  if (heads == 0) return std::nullopt;
  return heads < 3 ? with_times(text) : Segments(text, file).joined();
}

}  // namespace workbench
