#include "workbench/recording/column_choice.hpp"

#include <algorithm>
#include <utility>

#include "wire/text.hpp"
#include "workbench/recording/columns/line_table.hpp"
#include "workbench/recording/columns/long_format.hpp"
#include "workbench/recording/columns/mode_column.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/spelling/quality_words.hpp"

namespace workbench {
namespace {

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
        candidates_(candidates_of(layout)),
        times_(layout, file, names, candidates_) {}

  ColumnChoice choose() {
    if (time_needed_) {
      if (auto time = times_.find()) out_.times.push_back(std::move(*time));
    }
    if (is_long()) return std::move(out_);
    hide_times();
    if (has_rows_of_loops()) return std::move(out_);
    const std::vector<PickedSignal> picked = choose_signals(
        candidates_, names_, required_,
        {file_, layout_.header_line, "columns", time_option(), layout_.cut_names});
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
  bool is_long() {
    if (out_.times.empty()) return false;
    const std::vector<std::size_t> times = columns_of(out_.times.front());
    const std::optional<LongFormat> found = long_format(layout_, times);
    if (!found) return false;
    out_.shape = ColumnChoice::Shape::kLong;
    std::vector<std::size_t> keys = {found->tag};
    if (found->parameter) keys.push_back(*found->parameter);
    out_.keys = row_keys(layout_, times, keys);
    out_.values = {{found->value, found->quality, found->whole}};
    out_.unit = found->unit;
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
      const bool is_key = std::ranges::find(out_.keys, i) != out_.keys.end();
      // 0 in all rows beside other numbers, without a name: a state of theirs.
      const auto code = wire::number_of<double>(columns_[i].first);
      const bool state = layout_.header.empty() && columns_[i].rests() && code &&
                         is_quality_code(*code) && !out_.values.empty();
      if (candidates_[i].measured && !is_key && part != Part::kQuality && !state) {
        out_.values.push_back({i, quality_of(i), {}});
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
      for (const std::size_t used : columns_of(place)) {
        candidates_[used].measured = false;
        candidates_[used].name.part = Part::kTime;
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
    // A status left of the only value, beside another column of qualities.
    const bool left = signal > 0 && columns_[signal - 1].name.part == Part::kQuality &&
                      columns_[signal - 1].name.tag.empty();
    const auto measured = std::ranges::count_if(candidates_, [](const NamedSignal& c) {
      return c.measured && c.name.part != Part::kQuality && c.name.part != Part::kTime;
    });
    return left && measured == 1 ? std::optional(signal - 1) : std::nullopt;
  }

  [[nodiscard]] bool is_plain() const {
    if (!layout_.contract_names || !names_.time.empty() || names_.names_signals()) {
      return false;
    }
    const bool seconds = out_.times.empty() || (out_.times[0].seconds_only &&
                                                out_.times[0].form == TimeForm::kNumber);
    return seconds && std::ranges::all_of(out_.signals, [this](const SignalPlace& s) {
             return s.column == Column::t || role_of(columns_[s.index].name.text);
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
      const auto known = std::ranges::find(taken, (*times)[i]);
      out_.signals[i].time = static_cast<std::size_t>(known - taken.begin());
      if (known != taken.end()) continue;
      taken.push_back((*times)[i]);
      out_.times.push_back(times_.at(taken.back()));
    }
  }

  // What is to be said of the time beside the names of the signals.
  [[nodiscard]] std::string time_option() const {
    if (!time_needed_ || !out_.times.empty()) return "";
    const std::optional<std::size_t> time = counter_of(layout_);
    return time ? "--time " + option_word(columns_[*time].name.text, *time + 1)
                : "--ts SECONDS";
  }

  [[noreturn]] void refuse_without_time() const {
    const auto unread = std::ranges::find_if(columns_, [](const LayoutColumn& column) {
      return column.name.part == Part::kTime && !column.first.empty() &&
             column.content != Content::kNumber && !is_time(column.content);
    });
    if (unread != columns_.end()) {
      throw InputError(file_, layout_.header_line, unread->column,
                       "times in column " + quoted(unread->name.text),
                       quoted(unread->first),
                       "write all times alike, in seconds or as 2026-05-03 14:30:00, or "
                       "give --ts SECONDS");
    }
    const std::optional<std::size_t> time = counter_of(layout_);
    throw InputError(
        file_, layout_.header_line, 1, with_aliases(Column::t),
        "the columns " + list_of(candidates_),
        "name the time column with --time " +
            (time ? option_word(columns_[*time].name.text, *time + 1) : "COLUMN") +
            ", or give --ts SECONDS, the time from one row to the next");
  }

  const std::vector<LayoutColumn>& columns_;
  const CsvLayout& layout_;
  const std::string& file_;
  const ColumnNames& names_;
  const std::vector<Column>& required_;
  bool time_needed_;
  std::vector<NamedSignal> candidates_;
  TimeFinder times_;
  ColumnChoice out_;
};

using Indices = std::vector<std::size_t>;

bool holds_times(const LayoutColumn& column) {
  // A setpoint that was recorded once has its time in the first row alone.
  const bool once =
      column.content == Content::kNothing && kind_of(column.first) == CellKind::kDateTime;
  return once || column.content == Content::kDateTime ||
         (column.content == Content::kNumber && column.name.part == Part::kTime);
}

bool holds_values(const LayoutColumn& column) {
  return is_measured(column) && column.name.part != Part::kTime &&
         column.name.part != Part::kQuality;
}

std::optional<Indices> named_times(const std::vector<LayoutColumn>& columns,
                                   const Indices& times, const Indices& signals) {
  Indices out;
  for (const std::size_t signal : signals) {
    const auto found = std::ranges::find_if(times, [&](std::size_t time) {
      const std::string& of = columns[time].name.tag;
      return !of.empty() && of == columns[signal].name.key;
    });
    if (found == times.end()) return std::nullopt;
    out.push_back(*found);
  }
  return out;
}

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

std::optional<std::vector<std::size_t>> own_times(const CsvLayout& layout,
                                                  const Indices& signals) {
  const std::vector<LayoutColumn>& columns = layout.columns;
  Indices times;
  Indices before;  // a number
  Indices behind;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!holds_times(columns[i])) continue;
    if (!columns[i].rests()) times.push_back(i);
    if (i + 1 < columns.size() && holds_values(columns[i + 1])) before.push_back(i);
    if (i > 0 && holds_values(columns[i - 1])) behind.push_back(i);
  }
  if (signals.empty()) {
    return before.size() > 1 ? std::optional(Indices()) : std::nullopt;
  }
  if (times.size() > 1) {
    if (auto named = named_times(columns, times, signals)) return named;
  }
  const std::size_t first = *std::ranges::min_element(signals);
  Indices out;
  if (before.size() > 1 && before.front() < first) {
    for (const std::size_t signal : signals) {
      out.push_back(*(std::ranges::lower_bound(before, signal) - 1));
    }
    return out;
  }
  const bool leads =
      std::any_of(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(first),
                  [](const LayoutColumn& c) { return is_time(c.content); });
  if (behind.size() < 2 || leads) return std::nullopt;
  for (const std::size_t signal : signals) {
    const auto time = std::ranges::lower_bound(behind, signal);
    if (time == behind.end()) return std::nullopt;
    out.push_back(*time);
  }
  return out;
}

}  // namespace workbench
