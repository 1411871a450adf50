#include "workbench/recording/tag_stream.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "workbench/recording/csv_source.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/rows/long_gaps.hpp"
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

// What is longer is no ordinary pause between two samples of the signal, s.
double longest_pause_s(const Stream& stream) {
  if (stream.t.size() < 3) return HUGE_VAL;
  const Spacing spacing = spacing_of(stream.t);
  return static_cast<double>(shortest_gap(stream.t, spacing)) * spacing.period_s;
}

double next_time(const Stream& stream, std::size_t row, double end) {
  return row + 1 < stream.t.size() ? stream.t[row + 1] : end;
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

// Samples without value go, with a note; the grid then holds the one before.
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
    const auto at = std::ranges::upper_bound(ends, time);
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

constexpr double kOnTime = 0.10;  // of an interval: still this instant's sample
constexpr double kLatest = 0.1;   // of the time span before an optional signal begins

class StreamGrid {
 public:
  StreamGrid(std::vector<Stream> streams, const TableContext& context,
             ResampleReport& report)
      : streams_(std::move(streams)), context_(context), report_(report) {}

  RowTable merge() {
    if (!same_times()) {
      for (Stream& stream : streams_) drop_gaps(stream, report_);
    }
    leave_out_late();
    if (streams_.empty()) {
      throw InputError(context_.file, context_.header_line, 0, "signals with values",
                       "none in the whole file", "export the values beside their times");
    }
    return merged();
  }
  [[nodiscard]] bool on_grid() const { return on_grid_; }

 private:
  [[nodiscard]] bool same_times() const {
    return std::ranges::all_of(
        streams_, [this](const Stream& stream) { return stream.t == streams_[0].t; });
  }

  void leave_out_late() {
    double first = -HUGE_VAL;
    double last = -HUGE_VAL;
    for (const Stream& stream : streams_) {
      if (!context_.requires_it(stream.signal) || stream.t.empty()) continue;
      first = std::max(first, stream.t.front());
      last = std::max(last, stream.t.back());
    }
    std::erase_if(streams_, [&](const Stream& stream) {
      const bool late =
          stream.t.empty() || stream.t.front() > first + kLatest * (last - first);
      if (context_.requires_it(stream.signal) || !late) return false;
      report_.notes.push_back(quoted(stream.signal.name) +
                              (stream.t.empty() ? " has no value at all: taken as absent"
                                                : " begins late: left out"));
      return true;
    });
  }

  // Whether how often and how long it was recorded counts for all: what is required does;
  // where nothing is, whatever has samples.
  [[nodiscard]] bool decides(const Stream& stream) const {
    return context_.required.empty() ? stream.t.size() > 1
                                     : context_.requires_it(stream.signal);
  }

  [[nodiscard]] RowTable merged() {
    double start = -HUGE_VAL;
    double end = -HUGE_VAL;
    double first_end = HUGE_VAL;
    double period = HUGE_VAL;
    std::size_t samples = 0;
    for (const Stream& stream : streams_) {
      if (stream.t.size() < 2 && context_.requires_it(stream.signal)) {
        throw InputError(context_.file, context_.header_line, 0,
                         "at least 2 samples of " + quoted(stream.signal.name),
                         std::to_string(stream.t.size()),
                         "export a longer time, or another tag");
      }
      start = std::max(start, stream.t.front());
      if (!decides(stream)) continue;
      end = std::max(end, stream.t.back());
      first_end = std::min(first_end, stream.t.back());
      period = std::min(period, spacing_of(stream.t).period_s);
      samples = std::max(samples, stream.t.size());
    }
    RowTable table;
    if (same_times()) {
      table.t = streams_[0].t;
      table.line = streams_[0].line;
      for (Stream& stream : streams_) table.signals.push_back(std::move(stream.signal));
      return table;
    }
    const double instants = std::floor((end - start) / period + kOnTime) + 1;
    if (!(start < first_end && instants >= 2 && instants <= most_instants(samples))) {
      throw InputError(context_.file, context_.header_line, 0,
                       "signals recorded over the same time, without long holes",
                       number(std::max(first_end - start, 0.0)) +
                           " s in common, samples " + number(period) + " s apart",
                       "export all tags of the loop over one stretch of time");
    }
    fill_grid(start, period, static_cast<std::size_t>(instants), table);
    return table;
  }

  void fill_grid(double start, double period, std::size_t instants, RowTable& table) {
    std::vector<bool> own(instants, false);
    table.t.resize(instants);
    for (std::size_t k = 0; k < instants; ++k) {
      table.t[k] = start + static_cast<double>(k) * period;
    }
    std::string names;
    for (Stream& stream : streams_) {
      std::vector<double> values(instants);
      std::size_t row = 0;
      std::size_t before = static_cast<std::size_t>(-1);
      const bool first = &stream == &streams_.front();
      const double silent_s = stream.is_of_loop() ? longest_pause_s(stream) : HUGE_VAL;
      if (first) table.line.resize(instants);
      for (std::size_t k = 0; k < instants; ++k) {
        const double latest = table.t[k] + kOnTime * period;
        while (row + 1 < stream.t.size() && stream.t[row + 1] <= latest) ++row;
        if (row != before && stream.is_of_loop()) own[k] = true;
        before = row;
        const bool silent =
            next_time(stream, row, table.t.back()) - stream.t[row] > silent_s;
        const bool own_instant = table.t[k] < stream.t[row] + (1 - kOnTime) * period;
        const bool nothing = silent && !own_instant;
        values[k] = nothing ? kNoValue : stream.signal.values[row];
        if (nothing) own[k] = true;  // not held: left without a value
        if (first) table.line[k] = stream.line[row];
      }
      if (names.size() < 200)
        names += (names.empty() ? "" : ", ") + quoted(stream.signal.name);
      stream.signal.values = std::move(values);
      table.signals.push_back(std::move(stream.signal));
    }
    const auto missing = static_cast<std::size_t>(std::ranges::count(own, false));
    report_.missing += missing;
    on_grid_ = true;
    report_.notes.push_back(names + " have times of their own: put on one grid every " +
                            number(period) + " s by zero-order hold; " +
                            counted(missing, "instant holds", "instants hold") +
                            " the values before");
  }

  std::vector<Stream> streams_;
  const TableContext& context_;
  ResampleReport& report_;
  bool on_grid_ = false;
};

}  // namespace

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

RowTable merged(std::vector<Stream> streams, const TableContext& context,
                ResampleReport& report, bool& on_grid) {
  StreamGrid grid(std::move(streams), context, report);
  RowTable table = grid.merge();
  on_grid = grid.on_grid();
  return table;
}

}  // namespace workbench
