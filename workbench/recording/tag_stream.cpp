#include "workbench/recording/tag_stream.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "workbench/recording/csv_source.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/long_gaps.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

template <class Value>
void permute(std::vector<Value>& values, const std::vector<std::size_t>& order) {
  std::vector<Value> out;
  out.reserve(order.size());
  for (const std::size_t i : order) out.push_back(values[i]);
  values = std::move(out);
}

constexpr double kMostAstray = 0.01;  // of the rows; two are always allowed
constexpr double kFewestRuns = 0.05;  // of the rows: no order at all
constexpr double kMostSame = 0.9;     // of the rows that repeat a stretch

struct Run {
  double first;
  double last;
};

std::vector<Run> runs_of(const std::vector<double>& t) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (i == 0 || t[i] < t[i - 1]) runs.push_back({t[i], t[i]});
    runs.back().last = t[i];
  }
  return runs;
}

bool overlap(std::vector<Run> runs) {
  std::ranges::sort(runs, [](const Run& a, const Run& b) { return a.first < b.first; });
  for (std::size_t i = 1; i < runs.size(); ++i) {
    if (runs[i].first < runs[i - 1].last) return true;
  }
  return false;
}

// The fewest rows without which the others rise.
std::size_t rows_astray(const std::vector<double>& t) {
  std::vector<double> ends;  // of the rising rows of each length, the lowest last one
  for (const double time : t) {
    const auto at = std::upper_bound(ends.begin(), ends.end(), time);
    if (at == ends.end()) {
      ends.push_back(time);
    } else {
      *at = time;
    }
  }
  return t.size() - ends.size();
}

std::size_t rows_behind(const std::vector<double>& t) {
  std::size_t behind = 0;
  double latest = -HUGE_VAL;
  for (const double time : t) {
    if (time <= latest) ++behind;
    latest = std::max(latest, time);
  }
  return behind;
}

// Of sorted samples those that repeat the one before.
std::size_t copies_in(const Stream& stream) {
  const std::vector<double>& values = stream.signal.values;
  std::size_t copies = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    copies += stream.t[i] == stream.t[i - 1] && are_alike(values[i], values[i - 1]);
  }
  return copies;
}

void note_once(const char* note, ResampleReport& report) {
  if (std::ranges::find(report.notes, note) == report.notes.end()) {
    report.notes.emplace_back(note);
  }
}

}  // namespace

double longest_pause_s(const Stream& stream) {
  if (stream.t.size() < 3) return HUGE_VAL;
  const Spacing spacing = spacing_of(stream.t);
  return static_cast<double>(shortest_gap(stream.t, spacing)) * spacing.period_s;
}

double next_time(const Stream& stream, std::size_t row, double end) {
  return row + 1 < stream.t.size() ? stream.t[row + 1] : end;
}

void add_to_tag(std::string& tag, std::string_view part) {
  if (!tag.empty() && !part.empty()) tag += '.';
  tag += part;
}

std::string_view tag_of(const RowScanner& rows, const std::vector<std::size_t>& keys,
                        std::string& tag) {
  if (keys.size() == 1) return rows.cell(keys.front());
  tag.clear();
  for (const std::size_t key : keys) add_to_tag(tag, rows.cell(key));
  return tag;
}

void add_tags(std::string_view key, const ColumnChoice& choice, const CsvLayout& layout,
              std::size_t column, std::vector<NamedSignal>& tags) {
  for (const ColumnChoice::Value& value : choice.values) {
    std::string tag(key);
    if (choice.values.size() > 1) {
      add_to_tag(tag, layout.columns[value.column].name.text);
    }
    tags.push_back({column_name(tag), tags.size() + 1, column, true});
  }
}

void sort(Stream& stream) {
  std::vector<std::size_t> order(stream.t.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&stream](std::size_t a, std::size_t b) {
    return stream.t[a] < stream.t[b];
  });
  permute(stream.t, order);
  permute(stream.line, order);
  permute(stream.signal.values, order);
  if (!stream.signal.quality.empty()) permute(stream.signal.quality, order);
}

void drop_gaps(Stream& stream, ResampleReport& report) {
  SignalRows& signal = stream.signal;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < stream.t.size(); ++i) {
    if (std::isnan(signal.values[i])) continue;
    stream.t[kept] = stream.t[i];
    stream.line[kept] = stream.line[i];
    signal.values[kept++] = signal.values[i];
  }
  const std::size_t gaps = stream.t.size() - kept;
  if (gaps == 0) return;
  report.empty_cells += gaps;
  report.notes.push_back(
      counted(gaps, "sample", "samples") + " of " + quoted(signal.name) +
      " without a value" +
      (signal.bad > 0 ? " (" + quoted(signal.bad_word) + ")" : std::string()) +
      ": the one before is held");
  stream.t.resize(kept);
  stream.line.resize(kept);
  signal.values.resize(kept);
  signal.bad = 0;
}

void put_in_order(Stream& stream, const TimesOfRows& times, const std::string& file,
                  ResampleReport& report) {
  const std::vector<double>& t = stream.t;
  const auto rows = static_cast<double>(t.size());
  const auto back = static_cast<std::size_t>(
      std::ranges::adjacent_find(t, std::greater<>()) - t.begin());
  if (back == t.size()) return;
  const std::vector<Run> runs = runs_of(t);
  const double before = t[back];
  const double after = t[back + 1];
  const std::uint32_t line = stream.line[back + 1];
  const auto astray = static_cast<double>(rows_astray(t));
  const char* note = nullptr;
  if (!overlap(runs)) {
    note = "parts of the rows come in another order than their times: sorted";
  } else if (astray <= std::max(2.0, kMostAstray * rows)) {
    note = "a few rows stand out of the order of their times: sorted";
  } else if (static_cast<double>(runs.size()) > kFewestRuns * rows) {
    note = "the rows come in no order of their times: sorted";
  }
  const std::size_t behind = rows_behind(t);
  sort(stream);
  if (note == nullptr &&
      static_cast<double>(copies_in(stream)) >= kMostSame * static_cast<double>(behind)) {
    note = "stretches of the rows come twice: sorted";
  }
  if (note == nullptr) {
    refuse_step_back(times, stream.times.form(), file,
                     {line, stream.first_cell.column, {}}, before, after);
  }
  note_once(note, report);
}

}  // namespace workbench
