#include "workbench/recording/csv.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include "workbench/recording/csv_header.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/text_file.hpp"

namespace workbench {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{512} << 20;

constexpr bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

class CsvParser {
 public:
  CsvParser(std::string_view text, const std::string& name, const CsvOptions& options)
      : name_(name),
        options_(options),
        at_(text.data()),
        end_(text.data() + text.size()) {}

  Recording parse() {
    recognise_encoding();
    read_header();
    read_rows();
    return finish();
  }

 private:
  [[noreturn]] void fail(std::size_t column, std::string expected, std::string found,
                         std::string advice) const {
    throw InputError(name_, line_, column, std::move(expected), std::move(found),
                     std::move(advice));
  }

  [[nodiscard]] std::size_t column_of(const char* at) const {
    return static_cast<std::size_t>(at - line_start_) + 1;
  }

  void recognise_encoding() {
    const std::string_view text(at_, static_cast<std::size_t>(end_ - at_));
    if (text.starts_with("\xEF\xBB\xBF")) at_ += 3;
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
      fail(1, "text in UTF-8 or ASCII", "UTF-16", "save the file as CSV UTF-8");
    }
    if (text.starts_with("PK\x03\x04")) {
      fail(1, "a CSV text file", "a spreadsheet or zip archive",
           "export the sheet as CSV");
    }
  }

  void next_line() {
    if (at_ < end_) {
      const bool crlf = *at_ == '\r' && at_ + 1 < end_ && at_[1] == '\n';
      at_ += crlf ? 2 : 1;
    }
    ++line_;
    line_start_ = at_;
  }

  [[nodiscard]] std::string_view rest_of_line() const {
    return {at_, static_cast<std::size_t>(std::find_if(at_, end_, is_line_end) - at_)};
  }

  void read_header() {
    line_start_ = at_;
    while (at_ < end_ && trimmed(rest_of_line()).empty()) {
      at_ += rest_of_line().size();
      next_line();
    }
    if (at_ >= end_) {
      line_ = 1;
      fail(1, "a header row with the names of the columns", "an empty file",
           "export the recording again");
    }
    const std::string_view header = rest_of_line();

    std::vector<HeaderCell> cells;
    std::size_t best = 0;
    for (const char candidate : {',', ';', '\t'}) {
      std::vector<HeaderCell> split = split_header(header, candidate);
      const auto known = static_cast<std::size_t>(std::count_if(
          split.begin(), split.end(),
          [](const HeaderCell& c) { return role_of(c.name) != kIgnoredColumn; }));
      const std::size_t merit = known * (kMostHeaderCells + 2) + split.size();
      if (merit > best) {
        best = merit;
        cells = std::move(split);
        separator_ = candidate;
      }
    }
    if (cells.size() > kMostHeaderCells) {
      fail(1, "at most " + std::to_string(kMostHeaderCells) + " columns", "more",
           "export only the columns of one loop");
    }

    std::array<std::string, kColumns> taken_by;
    std::string names;
    bool all_numbers = true;
    for (const HeaderCell& cell : cells) {
      double ignored = 0;
      all_numbers = all_numbers && parse_number(cell.name, ignored) != Parsed::kText;
      if (names.size() < 200) names += (names.empty() ? "" : " ") + quoted(cell.name);
      int role = role_of(cell.name);
      if (role != kIgnoredColumn) {
        std::string& other = taken_by[static_cast<std::size_t>(role)];
        if (!other.empty()) {
          fail(cell.column, "one column for " + std::string(name_of(Column(role))),
               "both " + quoted(other) + " and " + quoted(cell.name),
               "rename or remove one of them");
        }
        other = cell.name;
      }
      if (role == static_cast<int>(Column::t) && options_.ts) {
        notes_.push_back("column " + quoted(cell.name) +
                         " ignored: the sample period is given as " +
                         number(*options_.ts) + " s");
        role = kIgnoredColumn;
      }
      roles_.push_back(role);
      cell_names_.push_back(cell.name);
    }
    has_time_ = !options_.ts;
    std::vector<Column> required = options_.required;
    if (has_time_) required.insert(required.begin(), Column::t);
    for (const Column column : required) {
      if (!taken_by[static_cast<std::size_t>(column)].empty()) continue;
      if (column == Column::t && !has_time_) continue;
      if (all_numbers) {
        fail(1, "a header row with the names of the columns (t, u, y)", "numbers",
             "add a first line such as t,u,y");
      }
      fail(1, with_aliases(column), "the columns " + names,
           column == Column::t ? "rename the time column to t, or give --ts SECONDS"
                               : "rename the column that holds it");
    }
    decimal_points_ = decimal_commas_ = false;
    at_ += header.size();
    header_line_ = line_;
  }

  enum class Parsed { kOk, kText, kNotFinite, kMixedMarks };

  // The whole of `text` as a number; with a separator other than the comma, the
  // decimal mark may be a comma.
  Parsed parse_number(std::string_view text, double& value) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    std::array<char, 64> copy;
    if (separator_ != ',') {
      const std::size_t comma = text.find(',');
      const bool point = text.find('.') != std::string_view::npos;
      if (comma != std::string_view::npos) {
        if (point || text.size() > copy.size()) return Parsed::kText;
        std::copy(text.begin(), text.end(), copy.begin());
        copy[comma] = '.';
        text = {copy.data(), text.size()};
      }
      if (point) decimal_points_ = true;
      if (comma != std::string_view::npos) decimal_commas_ = true;
    }
    const auto [stop, status] =
        std::from_chars(text.data(), text.data() + text.size(), value);
    if (status == std::errc::invalid_argument || stop != text.data() + text.size()) {
      return Parsed::kText;
    }
    if (status != std::errc{} || !std::isfinite(value)) return Parsed::kNotFinite;
    return decimal_points_ && decimal_commas_ ? Parsed::kMixedMarks : Parsed::kOk;
  }

  // Consumes one cell up to the separator or the end of the line.
  std::string_view take_cell() {
    const char blank = separator_ == '\t' ? ' ' : '\t';
    while (at_ < end_ && (*at_ == ' ' || *at_ == blank)) ++at_;
    cell_start_ = at_;
    if (at_ < end_ && *at_ == '"') {
      const char* close = at_ + 1;
      while (close < end_ && !is_line_end(*close)) {
        if (*close == '"') {
          if (close + 1 < end_ && close[1] == '"') {
            ++close;
          } else {
            break;
          }
        }
        ++close;
      }
      if (close >= end_ || *close != '"') {
        fail(column_of(at_), "a closing quote on the same line", "the end of the line",
             "close the quote");
      }
      const std::string_view inside(at_ + 1, static_cast<std::size_t>(close - at_ - 1));
      at_ = close + 1;
      while (at_ < end_ && (*at_ == ' ' || *at_ == blank)) ++at_;
      if (at_ < end_ && *at_ != separator_ && !is_line_end(*at_)) {
        fail(column_of(at_), "a separator after the closing quote", quoted({at_, 1}),
             "write a quote inside a value twice");
      }
      return trimmed(inside);
    }
    while (at_ < end_ && *at_ != separator_ && !is_line_end(*at_)) ++at_;
    return trimmed({cell_start_, static_cast<std::size_t>(at_ - cell_start_)});
  }

  double take_number(std::string_view cell, std::size_t index) {
    double value = 0;
    const Parsed parsed = parse_number(cell, value);
    if (parsed == Parsed::kOk) return value;
    const std::string expected = "a number in column " + quoted(cell_names_[index]);
    const std::size_t column = column_of(cell_start_);
    if (parsed == Parsed::kNotFinite) {
      fail(column, "a finite number in column " + quoted(cell_names_[index]),
           quoted(cell), "leave the cell empty where the value is missing");
    }
    if (parsed == Parsed::kMixedMarks) {
      fail(column, "one decimal mark in the whole file",
           "both '.' and ',' up to " + quoted(cell),
           "export without thousands separators");
    }
    if (separator_ == ',' && cell.find(',') != std::string_view::npos) {
      fail(column, expected, quoted(cell),
           "write a decimal point, or separate the columns with semicolons");
    }
    fail(column, expected, quoted(cell), "repair the cell, or leave it empty if missing");
  }

  void read_rows() {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    std::array<double, kColumns> held;
    held.fill(nothing);
    std::array<std::size_t, kColumns> filled{};
    std::size_t empty_line = 0;
    const auto cells = roles_.size();
    const std::size_t likely = likely_rows();
    rows_.line.reserve(likely);
    rows_.t.reserve(likely);
    for (const int role : roles_) {
      if (role > 0) rows_.values[static_cast<std::size_t>(role)].reserve(likely);
    }

    while (at_ < end_) {
      next_line();
      if (at_ >= end_) break;
      std::size_t index = 0;
      bool all_empty = true;
      std::uint32_t empty_roles = 0;
      std::array<double, kColumns> now = held;
      const char* time_cell = nullptr;
      while (true) {
        const std::string_view cell = take_cell();
        if (!cell.empty()) all_empty = false;
        if (index < cells && roles_[index] != kIgnoredColumn) {
          const auto role = static_cast<std::size_t>(roles_[index]);
          if (role == 0) time_cell = cell_start_;
          if (cell.empty()) {
            empty_roles |= 1U << role;
          } else {
            now[role] = take_number(cell, index);
          }
        }
        ++index;
        if (at_ >= end_ || *at_ != separator_) break;
        ++at_;
      }
      if (all_empty && (index == cells || index == 1)) {
        if (empty_line == 0) empty_line = line_;
        continue;
      }
      if (empty_line != 0) {
        line_ = empty_line;
        fail(1, "values", "an empty line between rows",
             "remove the line, or write the values");
      }
      if (index != cells) {
        fail(column_of(at_), std::to_string(cells) + " cells as in the header",
             std::to_string(index), "make every row as long as the header");
      }
      if (has_time_) {
        if ((empty_roles & 1U) != 0) {
          fail(column_of(time_cell), "a time in seconds", "an empty cell",
               "write the time, or remove the row");
        }
        check_time(now[0], time_cell, held[0]);
      }
      ++rows_seen_;
      for (std::size_t role = 1; role < kColumns; ++role) {
        if (!std::isnan(now[role])) ++filled[role];
      }
      const bool repeated = has_time_ && rows_seen_ > 1 && now[0] == held[0];
      if (repeated) {
        ++report_.repeated;
        if (first_repeat_ == 0) first_repeat_ = line_;
        complete_last(now, empty_roles, held);
        continue;
      }
      held = now;
      append(now);
      report_.empty_cells += static_cast<std::size_t>(std::popcount(empty_roles));
      last_empty_ = empty_roles;
    }
    drop_incomplete(filled);
  }

  // The first row of an instant stands; one that repeats its time only supplies
  // the values it lacks, as a logger with one signal per row does.
  void complete_last(const std::array<double, kColumns>& now, std::uint32_t empty_roles,
                     std::array<double, kColumns>& held) {
    for (std::size_t role = 1; role < kColumns; ++role) {
      const std::uint32_t bit = 1U << role;
      if ((last_empty_ & bit) == 0 || (empty_roles & bit) != 0) continue;
      rows_.values[role].back() = held[role] = now[role];
      last_empty_ &= ~bit;
      --report_.empty_cells;
    }
  }

  void check_time(double time, const char* cell, double previous) const {
    if (time < previous) {
      fail(column_of(cell), "a time not before " + number(previous, 12) + " s",
           number(time, 12) + " s",
           "sort the rows by time, or split the recording there");
    }
  }

  void append(const std::array<double, kColumns>& now) {
    if (rows_.line.size() >= kMaxSamples) {
      fail(0, "at most " + std::to_string(kMaxSamples) + " rows", "more",
           "split the recording");
    }
    rows_.line.push_back(static_cast<std::uint32_t>(line_));
    rows_.t.push_back(has_time_ ? now[0]
                                : static_cast<double>(rows_.t.size()) * *options_.ts);
    for (const int role : roles_) {
      if (role > 0) {
        rows_.values[static_cast<std::size_t>(role)].push_back(
            now[static_cast<std::size_t>(role)]);
      }
    }
  }

  // A column without any value is absent; rows before every column has one go.
  void drop_incomplete(const std::array<std::size_t, kColumns>& filled) {
    std::size_t start = 0;
    for (std::size_t role = 1; role < kColumns; ++role) {
      std::vector<double>& values = rows_.values[role];
      if (values.empty()) continue;
      if (filled[role] == 0) {
        const auto column = static_cast<Column>(role);
        if (std::find(options_.required.begin(), options_.required.end(), column) !=
            options_.required.end()) {
          line_ = header_line_;
          fail(0, "values in column " + std::string(name_of(column)), "only empty cells",
               "export the column with its values");
        }
        notes_.push_back("column " + std::string(name_of(column)) +
                         " has no value at all: taken as absent");
        report_.empty_cells -= rows_.t.size();
        values = {};
        continue;
      }
      const auto known = std::find_if(values.begin(), values.end(),
                                      [](double v) { return !std::isnan(v); });
      start = std::max(start, static_cast<std::size_t>(known - values.begin()));
    }
    if (start == 0) return;
    notes_.push_back("the first " + std::to_string(start) +
                     " rows lack a value in some column: dropped");
    const auto erase = [start](auto& values) {
      if (!values.empty()) {
        values.erase(
            values.begin(),
            values.begin() + static_cast<std::ptrdiff_t>(std::min(start, values.size())));
      }
    };
    erase(rows_.t);
    erase(rows_.line);
    for (auto& values : rows_.values) erase(values);
  }

  [[nodiscard]] std::size_t likely_rows() const {
    const auto bytes = static_cast<std::size_t>(end_ - at_);
    const std::size_t head = std::min<std::size_t>(bytes, 4096);
    const auto lines =
        static_cast<std::size_t>(std::count_if(at_, at_ + head, is_line_end));
    return std::min(kMaxSamples,
                    bytes / std::max<std::size_t>(head / (lines + 1), 2) + 16);
  }

  Recording finish() {
    Recording out;
    out.name = name_;
    if (report_.empty_cells > 0) {
      notes_.push_back(std::to_string(report_.empty_cells) +
                       " empty cells: the value before is held");
    }
    if (report_.repeated > 0) {
      notes_.push_back(std::to_string(report_.repeated) +
                       " rows repeat the time of the row before (first in line " +
                       std::to_string(first_repeat_) + "): dropped");
    }
    report_.notes = std::move(notes_);
    report_.rows = report_.repeated;
    out.resampling = std::move(report_);
    resample(std::move(rows_), name_, out);
    if (options_.ts) out.period_s = *options_.ts;
    return out;
  }

  const std::string& name_;
  const CsvOptions& options_;
  const char* at_;
  const char* end_;
  const char* line_start_ = nullptr;
  const char* cell_start_ = nullptr;
  std::size_t line_ = 1;
  std::size_t header_line_ = 1;
  char separator_ = ',';
  bool has_time_ = true;
  bool decimal_points_ = false;
  bool decimal_commas_ = false;
  std::vector<int> roles_;
  std::vector<std::string> cell_names_;
  std::vector<std::string> notes_;
  TimedRows rows_;
  ResampleReport report_;
  std::size_t rows_seen_ = 0;
  std::size_t first_repeat_ = 0;
  std::uint32_t last_empty_ = 0;  // by role: cells without a value in the last row
};

}  // namespace

Recording parse_csv(std::string_view text, const std::string& name,
                    const CsvOptions& options) {
  if (options.ts && !(std::isfinite(*options.ts) && *options.ts > 0)) {
    throw std::invalid_argument("the sample period must be a positive number of seconds");
  }
  return CsvParser(text, name, options).parse();
}

Recording read_csv(const std::string& path, const CsvOptions& options) {
  Recording recording = parse_csv(read_text_file(path, kMaxBytes), path, options);
  recording.name = file_name(path);
  return recording;
}

}  // namespace workbench
