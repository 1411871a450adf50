#include "workbench/recording/column_choice.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "wire/text.hpp"
#include "workbench/recording/date_digits.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/line_table.hpp"
#include "workbench/recording/long_format.hpp"
#include "workbench/recording/mode_column.hpp"
#include "workbench/recording/own_times.hpp"
#include "workbench/recording/row_keys.hpp"
#include "workbench/recording/time_unit.hpp"

namespace workbench {
namespace {

constexpr double kMostOfADay = 0.9;  // of the rows say the same date

class ColumnChooser {
 public:
  ColumnChooser(const CsvLayout& layout, const std::string& file,
                const ColumnNames& names, const std::vector<Column>& required,
                bool time_needed)
      : columns_(layout.columns),
        layout_(layout),
        file_(file),
        names_(names),
        required_(required),
        time_needed_(time_needed),
        candidates_(candidates_of(layout)) {}

  ColumnChoice choose() {
    find_time();
    if (is_long()) return std::move(out_);
    hide_times();
    if (has_rows_of_loops()) return std::move(out_);
    const std::vector<PickedSignal> picked =
        choose_signals(candidates_, names_, required_,
                       {file_, layout_.header_line, "columns", time_option()});
    if (const std::string note = elimination_note(picked, candidates_); !note.empty()) {
      out_.notes.push_back(note);
    }
    for (const PickedSignal& signal : picked) {
      out_.signals.push_back({signal.column, signal.index, quality_of(signal.index), {}});
    }
    if (time_needed_ && out_.times.empty()) refuse_without_time();
    out_.plain = is_plain();
    if (out_.plain) {
      for (SignalPlace& signal : out_.signals) signal.quality.reset();
    }
    find_own_times();
    if (out_.shape == ColumnChoice::Shape::kWide && !out_.signals.empty()) {
      out_.mode = mode_column(columns_, out_.signals.front().index);
    }
    return std::move(out_);
  }

 private:
  void find_time() {
    if (!time_needed_) return;
    if (!names_.time.empty()) {
      take_named_time();
      return;
    }
    const auto first = [this](auto condition) -> std::optional<std::size_t> {
      const auto found = std::find_if(columns_.begin(), columns_.end(), condition);
      if (found == columns_.end()) return std::nullopt;
      return static_cast<std::size_t>(found - columns_.begin());
    };
    std::optional<std::size_t> column = first([](const LayoutColumn& c) {
      return role_of(c.name.text) == static_cast<int>(Column::t) &&
             c.content != Content::kText;
    });
    if (column) check_single_t(*column);
    // The bounds of a query stand beside the times of its rows, the same in all of them.
    for (const bool may_rest : {false, true}) {
      for (const Content content : {Content::kDateTime, Content::kDate}) {
        if (column) break;
        column = first([content, may_rest](const LayoutColumn& c) {
          return c.content == content && (may_rest || !c.rests());
        });
      }
    }
    if (!column) {
      column = first([](const LayoutColumn& c) {
        return c.name.part == Part::kTime && is_measured(c) &&
               c.content != Content::kNothing;
      });
    }
    if (!column) {
      column = first([](const LayoutColumn& c) { return c.content == Content::kClock; });
    }
    if (!column) {
      column = first([](const LayoutColumn& c) {
        return c.name.part == Part::kMillis && c.name.tag.empty() && is_measured(c) &&
               c.content != Content::kNothing && !c.rests();
      });
    }
    // The sample period alone, in the first row, makes no times.
    if (!column) {
      column = first([](const LayoutColumn& c) {
        const bool named = role_of(c.name.text) == static_cast<int>(Column::t) ||
                           c.name.part == Part::kTime;
        return named && c.content != Content::kNothing;
      });
    }
    // Without a header, seconds or parts of them since 1970.
    if (!column && layout_.header.empty()) {
      column = first([](const LayoutColumn& c) { return counts_since_1970(c); });
    }
    if (column) take_time(*column);
  }

  // Ten digits are seconds from 2001 on, 13 milliseconds.
  [[nodiscard]] static bool counts_since_1970(const LayoutColumn& column) {
    const std::string_view whole =
        std::string_view(column.first).substr(0, column.first.find_first_of(".,"));
    const bool digits = std::all_of(whole.begin(), whole.end(), wire::is_digit);
    return column.content == Content::kNumber && !column.rests() && digits &&
           whole.starts_with('1') && (whole.size() == 10 || whole.size() == 13);
  }

  // "Ticks [ms]", "#1 [min]": with the unit of a column that names none, or a wrong one.
  void take_named_time() {
    const std::size_t open = names_.time.rfind(" [");
    double unit_s = 0;
    if (open != std::string::npos && names_.time.back() == ']') {
      unit_s = seconds_of_unit(
          std::string_view(names_.time).substr(open + 2, names_.time.size() - open - 3));
    }
    const bool numbered = unit_s > 0 && names_.time.front() == '#';
    take_time(candidate_named(numbered ? names_.time.substr(0, open) : names_.time,
                              "--time", candidates_,
                              {file_, layout_.header_line, "columns"}));
    if (unit_s <= 0) return;
    out_.times.back().unit_s = unit_s;
    out_.times.back().unit_given = true;
    out_.times.back().unknown_unit.clear();
  }

  void check_single_t(std::size_t first) const {
    for (std::size_t i = first + 1; i < columns_.size(); ++i) {
      if (role_of(columns_[i].name.text) != static_cast<int>(Column::t)) continue;
      throw InputError(file_, layout_.header_line, columns_[i].column, "one column for t",
                       "both " + quoted(columns_[first].name.text) + " and " +
                           quoted(columns_[i].name.text),
                       "rename or remove one of them, or name the right one with --time");
    }
  }

  void take_time(std::size_t index) {
    TimePlace place;
    place.column = index;
    const LayoutColumn& column = columns_[index];
    place.seconds_only = role_of(column.name.text) == static_cast<int>(Column::t);
    place.unit_s = seconds_of_unit(column.name.unit);
    if (place.unit_s == 0) place.unit_s = seconds_of_unit(column.name.key);
    if (place.unit_s == 0) place.unit_s = unit_in_name(column.name.text);
    const bool names_unit = !column.name.unit.empty() && column.name.unit != "-";
    if (place.unit_s == 0 && names_unit) place.unknown_unit = quoted(column.name.unit);
    const bool once = column.content == Content::kNothing &&
                      kind_of(column.first) == CellKind::kDateTime;
    if (once || column.content == Content::kDateTime ||
        column.content == Content::kDate) {
      place.form = TimeForm::kDate;
    } else if (column.content == Content::kClock) {
      place.form = TimeForm::kClock;
    }
    if (!place.seconds_only && dates_as_numbers(column)) find_clock_beside(place);
    if (column.content == Content::kDate || is_midnight(column)) {
      for (std::size_t i = 0; i < columns_.size(); ++i) {
        const Content other = columns_[i].content;
        const bool full =
            other == Content::kDateTime && columns_[i].name.part == Part::kTime;
        if (i != index && (other == Content::kClock || full)) {
          place.clock = i;
          break;
        }
      }
    }
    if (column.content == Content::kDate && !place.clock) find_clock_beside(place);
    if (column.content == Content::kClock && !names_.time.empty()) {
      for (std::size_t i = 0; i < columns_.size(); ++i) {
        if (columns_[i].content != Content::kDate) continue;
        place.clock = index;
        place.column = i;
        place.form = TimeForm::kDate;
        break;
      }
    }
    const std::size_t last = place.clock.value_or(place.column);
    const bool whole_s = place.unit_s == 1 && column.first.find('.') == std::string::npos;
    if ((place.form != TimeForm::kNumber || whole_s) && holds_millis(last + 1, column)) {
      place.millis = last + 1;
    }
    out_.times.push_back(place);
  }

  // A date that its system writes with a time of day, always the same.
  [[nodiscard]] static bool is_midnight(const LayoutColumn& column) {
    const std::optional<WrittenTime> time = written_time(column.first);
    return column.content == Content::kDateTime && column.held >= kMostOfADay && time &&
           time->seconds == 0 && !time->has_zone;
  }

  // Milliseconds of the second before, which do not count on while that goes on.
  [[nodiscard]] bool holds_millis(std::size_t index, const LayoutColumn& seconds) const {
    if (index >= columns_.size()) return false;
    const LayoutColumn& column = columns_[index];
    return column.name.part == Part::kMillis && column.name.tag.empty() &&
           !(column.counts && !seconds.rests());
  }

  // The same number in most rows, and one that is written as dates are.
  [[nodiscard]] static bool dates_as_numbers(const LayoutColumn& column) {
    return column.content == Content::kNumber && column.name.unit.empty() &&
           column.held >= kMostOfADay && date_digits(column.first);
  }

  // The time of day as a number, or beside a date that is one, in the next column.
  void find_clock_beside(TimePlace& place) const {
    const std::size_t next = place.column + 1;
    if (next >= columns_.size()) return;
    const LayoutColumn& clock = columns_[next];
    const bool number = clock.content == Content::kNumber &&
                        clock.name.part == Part::kTime && clock.name.unit.empty();
    if (!number && clock.content != Content::kClock) return;
    place.clock = next;
    place.clock_is_number = number;
    place.form = TimeForm::kDate;
  }

  [[nodiscard]] static std::vector<std::size_t> columns_of(const TimePlace& time) {
    std::vector<std::size_t> out;
    for (const std::optional<std::size_t> used :
         {std::optional(time.column), time.clock, time.millis}) {
      if (used) out.push_back(*used);
    }
    return out;
  }

  bool is_long() {
    if (out_.times.empty()) return false;
    const std::vector<std::size_t> times = columns_of(out_.times.front());
    const std::optional<LongFormat> found = long_format(layout_, times);
    if (!found) return false;
    out_.shape = ColumnChoice::Shape::kLong;
    std::vector<std::size_t> keys = {found->tag};
    if (found->parameter) keys.push_back(*found->parameter);
    out_.keys = row_keys(layout_, times, keys);
    out_.values = {{found->value, found->quality}};
    return true;
  }

  // Rows of several loops in turn.
  bool has_rows_of_loops() {
    std::vector<std::size_t> times;
    if (out_.times.size() > 1) return false;
    if (!out_.times.empty()) times = columns_of(out_.times.front());
    out_.keys = row_keys(layout_, times, {});
    if (out_.keys.empty()) return false;
    if (time_needed_ && out_.times.empty()) refuse_without_time();
    out_.shape = ColumnChoice::Shape::kLong;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const Part part = candidates_[i].name.part;
      const bool is_key =
          std::find(out_.keys.begin(), out_.keys.end(), i) != out_.keys.end();
      if (candidates_[i].measured && !is_key && part != Part::kQuality) {
        out_.values.push_back({i, quality_of(i)});
      }
    }
    return !out_.values.empty();
  }

  void hide_times() {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      NamedSignal& candidate = candidates_[i];
      const bool time = is_time(columns_[i].content);
      if (!is_measured(columns_[i]) || time) candidate.measured = false;
    }
    for (const TimePlace& place : out_.times) {
      for (const std::optional<std::size_t> used :
           {std::optional(place.column), place.clock, place.millis}) {
        if (!used) continue;
        candidates_[*used].measured = false;
        candidates_[*used].name.part = Part::kTime;
      }
    }
  }

  [[nodiscard]] std::optional<std::size_t> quality_of(std::size_t signal) const {
    const std::string& key = columns_[signal].name.key;
    std::optional<std::size_t> bare;
    std::size_t all = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const ColumnName& name = columns_[i].name;
      if (name.part != Part::kQuality) continue;
      if (!name.tag.empty() && name.tag == key) return i;
      if (!name.tag.empty()) continue;
      ++all;
      if (!bare || i == signal + 1) bare = i;
    }
    if (all == 1 || (bare && *bare == signal + 1)) return bare;
    return std::nullopt;
  }

  [[nodiscard]] bool is_plain() const {
    if (!layout_.contract_names || !names_.time.empty() || names_.names_signals()) {
      return false;
    }
    const bool seconds = out_.times.empty() || (out_.times[0].seconds_only &&
                                                out_.times[0].form == TimeForm::kNumber);
    return seconds &&
           std::all_of(out_.signals.begin(), out_.signals.end(),
                       [this](const SignalPlace& s) {
                         return s.column == Column::t ||
                                role_of(columns_[s.index].name.text) != kIgnoredColumn;
                       });
  }

  void find_own_times() {
    if (out_.times.empty() || out_.plain || !names_.time.empty()) return;
    std::vector<std::size_t> signals;
    for (const SignalPlace& signal : out_.signals) signals.push_back(signal.index);
    const auto times = own_times(layout_, signals);
    if (!times) return;
    out_.shape = ColumnChoice::Shape::kOwnTimes;
    out_.times.clear();
    std::vector<std::size_t> taken;
    for (std::size_t i = 0; i < times->size(); ++i) {
      const auto known = std::find(taken.begin(), taken.end(), (*times)[i]);
      out_.signals[i].time = static_cast<std::size_t>(known - taken.begin());
      if (known != taken.end()) continue;
      taken.push_back((*times)[i]);
      take_time(taken.back());
    }
  }

  // What is to be said of the time beside the names of the signals.
  [[nodiscard]] std::string time_option() const {
    if (!time_needed_ || !out_.times.empty()) return "";
    const std::optional<std::size_t> time = counter_of(layout_);
    return time ? "--time " + shell_word(columns_[*time].name.text) : "--ts SECONDS";
  }

  [[noreturn]] void refuse_without_time() const {
    const std::optional<std::size_t> time = counter_of(layout_);
    throw InputError(file_, layout_.header_line, 1, with_aliases(Column::t),
                     "the columns " + list_of(candidates_),
                     "name the time column with --time " +
                         (time ? shell_word(columns_[*time].name.text) : "COLUMN") +
                         ", or give --ts SECONDS, the time from one row to the next");
  }

  const std::vector<LayoutColumn>& columns_;
  const CsvLayout& layout_;
  const std::string& file_;
  const ColumnNames& names_;
  const std::vector<Column>& required_;
  bool time_needed_;
  std::vector<NamedSignal> candidates_;
  ColumnChoice out_;
};

}  // namespace

std::vector<NamedSignal> candidates_of(const CsvLayout& layout) {
  std::vector<NamedSignal> out;
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    const LayoutColumn& column = layout.columns[i];
    out.push_back({column.name, i + 1, column.column, is_measured(column), column.counts,
                   column.held, column.content == Content::kNothing});
  }
  return out;
}

ColumnChoice choose_columns(const CsvLayout& layout, const std::string& file,
                            const ColumnNames& names, const std::vector<Column>& required,
                            bool time_needed) {
  return ColumnChooser(layout, file, names, required, time_needed).choose();
}

}  // namespace workbench
