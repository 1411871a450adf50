#include "workbench/recording/own_times.hpp"

#include <algorithm>

#include "workbench/recording/line_table.hpp"
#include "workbench/recording/long_format.hpp"

namespace workbench {
namespace {

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
      out.push_back(*(std::lower_bound(before.begin(), before.end(), signal) - 1));
    }
    return out;
  }
  const bool leads =
      std::any_of(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(first),
                  [](const LayoutColumn& c) { return is_time(c.content); });
  if (behind.size() < 2 || leads) return std::nullopt;
  for (const std::size_t signal : signals) {
    const auto time = std::lower_bound(behind.begin(), behind.end(), signal);
    if (time == behind.end()) return std::nullopt;
    out.push_back(*time);
  }
  return out;
}

}  // namespace workbench
