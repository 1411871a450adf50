#include "workbench/recording/tag_stream.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/long_gaps.hpp"

namespace workbench {
namespace {

template <class Value>
void permute(std::vector<Value>& values, const std::vector<std::size_t>& order) {
  std::vector<Value> out;
  out.reserve(order.size());
  for (const std::size_t i : order) out.push_back(values[i]);
  values = std::move(out);
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

}  // namespace workbench
