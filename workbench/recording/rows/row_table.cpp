#include "workbench/recording/rows/row_table.hpp"

#include <cmath>
#include <string_view>
#include <utility>

#include "workbench/recording/column_name.hpp"
#include "workbench/recording/columns/mode_column.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/rows/rows_without.hpp"
#include "workbench/recording/spelling/instrument_tag.hpp"

namespace workbench {
namespace {

constexpr double kMostBad = 0.5;        // share of the rows of a required signal
constexpr double kMostStrangers = 0.1;  // share of the rows with words nobody knows
constexpr double kLatestLoad = 0.1;     // share of the rows before a load begins
constexpr std::string_view kBadQuality = "bad quality";

std::string named(const SignalRows& signal) {
  return signal.column == Column::t ? quoted(signal.name)
                                    : std::string(name_of(signal.column));
}

std::size_t first_value(const SignalRows& signal) {
  const auto known =
      std::ranges::find_if(signal.values, [](double v) { return !std::isnan(v); });
  return static_cast<std::size_t>(known - signal.values.begin());
}

template <class Vector>
void erase_front(Vector& values, std::size_t count) {
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
}

// The longest stretch without values of a signal of the loop, s.
double longest_hold_s(const RowTable& table) {
  double longest = 0;
  for (const SignalRows& signal : table.signals) {
    if (signal.column == Column::t) continue;
    std::size_t last = 0;
    for (std::size_t i = 1; i < table.t.size(); ++i) {
      if (std::isnan(signal.values[i])) continue;
      if (i - last > 1) longest = std::max(longest, table.t[i] - table.t[last]);
      last = i;
    }
  }
  return longest;
}

void hold_mode(std::vector<double>& codes) {
  double held = kNoMode;
  for (double& code : codes) {
    if (std::isnan(code)) code = held;
    held = code;
  }
}

}  // namespace

void turn(RowTable& table) {
  std::ranges::reverse(table.line);
  for (SignalRows& signal : table.signals) {
    std::ranges::reverse(signal.values);
    std::ranges::reverse(signal.quality);
  }
}

void refuse_fractions(std::span<const SignalRows> signals,
                      std::optional<std::size_t> behind_time) {
  if (behind_time && signals[*behind_time].fractions.are_likely()) {
    throw InputError(*signals[*behind_time].fraction);
  }
  std::size_t numbers = 0;
  std::size_t likely = 0;
  const SignalRows* first = nullptr;
  for (const SignalRows& signal : signals) {
    if (signal.is_mode) continue;
    if (!signal.fractions.are_digits()) return;
    ++numbers;
    if (!signal.fractions.are_likely()) continue;
    ++likely;
    if (first == nullptr) first = &signal;
  }
  // Numbers of a fixed width have it in all columns.
  if (first != nullptr && likely < numbers) throw InputError(*first->fraction);
}

void refuse_doubtful(std::span<const SignalRows> signals, bool points_group) {
  const bool settled = std::ranges::any_of(
      signals, [](const SignalRows& signal) { return signal.marks.settled(); });
  for (const SignalRows& signal : signals) {
    const double most = kMostStrangers * static_cast<double>(signal.values.size());
    if (static_cast<double>(signal.strangers.total()) > most) {
      throw InputError(*signal.stranger);
    }
    if (signal.brackets.likely_marks()) throw InputError(*signal.bracket);
    if (signal.scaled.thousands() > 0 && !signal.scaled.are_thousands(signal.values)) {
      throw InputError(*signal.thousand);
    }
    if (!signal.doubt) continue;
    const bool open = points_group && !settled && signal.marks.open();
    if (open || signal.marks.likely_thousands()) throw InputError(*signal.doubt);
  }
}

void take_out_bad(RowTable& table, const TableContext& context) {
  for (SignalRows& signal : table.signals) {
    for (std::size_t i = 0; i < signal.quality.size(); ++i) {
      if (std::isnan(signal.values[i])) continue;
      const Quality quality = signal.scale.meaning(signal.quality[i]);
      signal.uncertain += quality == Quality::kUncertain;
      if (quality != Quality::kBad) continue;
      signal.values[i] = kNoValue;
      if (signal.bad++ == 0) signal.bad_word = kBadQuality;
    }
    const auto rows = static_cast<double>(signal.values.size());
    if (!context.requires_it(signal) ||
        static_cast<double>(signal.bad) <= kMostBad * rows) {
      continue;
    }
    throw InputError(context.file, context.header_line, 0,
                     "values in most rows of " + quoted(signal.name),
                     std::to_string(signal.bad) + " of " +
                         std::to_string(signal.values.size()) + " saying " +
                         quoted(signal.bad_word) + " or the like",
                     signal.bad_word == kBadQuality
                         ? "export a time when the signal was good, or, if the qualities "
                           "mean something else, without their column"
                         : "export a time when the signal was good");
  }
}

void note_words(const SignalRows& signal, ResampleReport& report) {
  if (signal.strangers.total() > 0) {
    report.notes.push_back("words among the numbers of " + quoted(signal.name) +
                           ", taken as no value: " + signal.strangers.list());
  }
  if (const std::size_t negative = signal.brackets.total(); negative > 0) {
    report.notes.push_back(counted(negative, "cell", "cells") + " of " +
                           quoted(signal.name) + " in brackets: taken as negative");
  }
  if (const std::size_t thousands = signal.scaled.thousands(); thousands > 0) {
    report.notes.push_back(counted(thousands, "cell", "cells") + " of " +
                           quoted(signal.name) + " with a K: taken as thousands");
  }
  if (const std::size_t prefixed = signal.scaled.prefixed(); prefixed > 0) {
    report.notes.push_back(counted(prefixed, "cell", "cells") + " of " +
                           quoted(signal.name) + " in " + quoted(signal.scaled.unit()) +
                           ": brought to the unit of the others");
  }
  if (signal.uncertain > 0) {
    report.notes.push_back(
        filled("{0} of {1} marked as questionable: taken as they are",
               {counted(signal.uncertain, "value", "values"), quoted(signal.name)}));
  }
  if (signal.scale.unknown().total() > 0) {
    report.notes.push_back("unknown qualities of " + quoted(signal.name) +
                           ", taken as good: " + signal.scale.unknown().list());
  }
}

void merge_repeats(RowTable& table, ResampleReport& report) {
  std::size_t kept = 0;
  std::size_t first_line = 0;
  for (std::size_t i = 1; i < table.t.size(); ++i) {
    if (table.t[i] == table.t[kept]) {
      ++report.repeated;
      if (first_line == 0) first_line = table.line[i];
      for (SignalRows& signal : table.signals) {
        if (std::isnan(signal.values[kept])) signal.values[kept] = signal.values[i];
      }
      continue;
    }
    if (++kept == i) continue;
    table.t[kept] = table.t[i];
    table.line[kept] = table.line[i];
    for (SignalRows& signal : table.signals) signal.values[kept] = signal.values[i];
  }
  if (report.repeated == 0) return;
  table.t.resize(kept + 1);
  table.line.resize(kept + 1);
  for (SignalRows& signal : table.signals) signal.values.resize(kept + 1);
  std::string note = counted(report.repeated, "row repeats", "rows repeat") +
                     " the time of the row before (first in line " +
                     std::to_string(first_line) + "): dropped";
  if (report.repeated > kept) {
    note += "; if the export cut the seconds off, export them, or give --ts SECONDS";
  }
  report.notes.push_back(std::move(note));
  report.rows += report.repeated;
}

namespace {

// Takes out signals without a value and loads that begin late.
void drop_empty(RowTable& table, const TableContext& context, ResampleReport& report) {
  const std::size_t rows = table.t.size();
  for (auto signal = table.signals.begin(); signal != table.signals.end();) {
    const std::size_t first = first_value(*signal);
    const bool late_load =
        signal->column == Column::t && first > 0 &&
        static_cast<double>(first) > kLatestLoad * static_cast<double>(rows);
    if (rows > 0 && (first == rows || late_load)) {
      if (context.requires_it(*signal)) {
        throw InputError(context.file, context.header_line, 1,
                         "values in column " + named(*signal), "only empty cells",
                         "export the column with its values");
      }
      report.notes.push_back("column " + named(*signal) +
                             (first == rows ? " has no value at all: taken as absent"
                                            : " begins late: left out"));
      signal = table.signals.erase(signal);
      continue;
    }
    ++signal;
  }
}

// From which on all signals have, or had, a value.
std::size_t first_whole_row(const RowTable& table) {
  std::size_t first = 0;
  for (const SignalRows& signal : table.signals) {
    first = std::max(first, first_value(signal));
  }
  return first;
}

struct HeldCells {
  std::size_t empty = 0;
  std::size_t bad = 0;                  // of those, marked by a word
  const SignalRows* example = nullptr;  // the first signal with one of these
};

// Each empty cell holds the value before.
HeldCells hold_empty(RowTable& table) {
  HeldCells out;
  for (SignalRows& signal : table.signals) {
    const auto gaps = static_cast<std::size_t>(
        std::ranges::count_if(signal.values, [](double v) { return std::isnan(v); }));
    out.empty += gaps;
    if (gaps == 0) continue;
    out.bad += std::min(signal.bad, gaps);
    if (signal.bad > 0 && out.example == nullptr) out.example = &signal;
    double held = kNoValue;
    for (double& value : signal.values) {
      if (std::isnan(value)) value = held;
      held = value;
    }
  }
  return out;
}

}  // namespace

void hold_values(RowTable& table, const TableContext& context, ResampleReport& report) {
  for (SignalRows& signal : table.signals) {
    if (signal.is_mode) hold_mode(signal.values);
  }
  drop_empty(table, context, report);
  take_out_rows_without(table, report);
  const std::size_t start = first_whole_row(table);
  const double longest_s = longest_hold_s(table);
  const HeldCells held = hold_empty(table);
  if (start > 0) {
    report.notes.push_back(
        "the first " +
        (start == 1 ? std::string("row lacks") : std::to_string(start) + " rows lack") +
        " a value in some column: dropped");
    erase_front(table.t, start);
    erase_front(table.line, start);
    for (SignalRows& signal : table.signals) erase_front(signal.values, start);
  }
  report.empty_cells += held.empty;
  if (held.empty == 0) return;
  const std::string how_long =
      longest_s > 0 ? " for at most " + number(longest_s) + " s" : std::string();
  if (held.bad > 0) {
    report.notes.push_back(counted(held.empty, "cell", "cells") + " without a value, " +
                           std::to_string(held.bad) + " of them marked (first " +
                           quoted(held.example->bad_word) + " in " +
                           quoted(held.example->name) + "): the value before is held" +
                           how_long);
  } else {
    report.notes.push_back(counted(held.empty, "empty cell", "empty cells") +
                           ": the value before is held");
  }
}

namespace {

std::string tags_of(const std::vector<SignalRows>& signals) {
  std::string tags;
  bool own_names = false;
  for (const SignalRows& signal : signals) {
    if (signal.is_mode || signal.column == Column::t) continue;
    own_names = own_names || !role_of(signal.name);
    tags += (tags.empty() ? "" : ", ") + std::string(name_of(signal.column)) + ' ' +
            signal.name;
  }
  return own_names ? tags : "";
}

std::string loop_of(const std::vector<SignalRows>& signals) {
  const auto y = std::ranges::find(signals, Column::y, &SignalRows::column);
  if (y == signals.end()) return {};
  return loop_of_instrument(column_name(y->name).pieces).value_or("");
}

}  // namespace

void resample(RowTable&& table, const std::string& file, Recording& out) {
  out.tags = tags_of(table.signals);
  out.loop = loop_of(table.signals);
  TimedRows rows;
  rows.t = std::move(table.t);
  rows.line = std::move(table.line);
  rows.between = std::move(table.between);
  const SignalRows* mode = nullptr;
  for (SignalRows& signal : table.signals) {
    if (signal.is_mode) {
      mode = &signal;
    } else if (signal.column == Column::t) {
      out.loads.push_back({signal.name, signal.unit, {}});
      rows.loads.push_back(std::move(signal.values));
    } else {
      const auto column = static_cast<std::size_t>(signal.column);
      out.units[column] = signal.unit;
      rows.values[column] = std::move(signal.values);
    }
  }
  // Held as a load is.
  if (mode != nullptr) {
    out.loads.push_back({mode->name, "", {}});
    rows.loads.push_back(mode->values);
  }
  resample(std::move(rows), file, out);
  if (mode != nullptr) {
    out.manual = manual_stretches(out.loads.back().values, out.u, mode->name);
    out.loads.pop_back();
  }
}

}  // namespace workbench
