#include "workbench/recording/rows_without.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/long_gaps.hpp"

namespace workbench {
namespace {

// Marks the rows of long stretches without a value; returns how many stretches.
std::size_t mark_stretches(const std::vector<double>& t,
                           const std::vector<double>& values,
                           std::vector<char>& without) {
  std::vector<double> known;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (!std::isnan(values[i])) known.push_back(t[i]);
  }
  if (known.size() < 2 || known.size() == t.size()) return 0;
  const Spacing spacing = spacing_of(known);
  const auto shortest = static_cast<double>(shortest_gap(known, spacing));
  std::size_t stretches = 0;
  std::size_t from = 0;  // the row behind the last one with a value
  for (std::size_t i = 0; i <= t.size(); ++i) {
    if (i < t.size() && std::isnan(values[i])) continue;
    const double until = i < t.size() ? t[i] : t.back();
    const double since = from > 0 ? t[from - 1] : until;
    if (i > from && std::round((until - since) / spacing.period_s) > shortest) {
      std::fill(without.begin() + static_cast<std::ptrdiff_t>(from),
                without.begin() + static_cast<std::ptrdiff_t>(i), 1);
      ++stretches;
    }
    from = i + 1;
  }
  return stretches;
}

template <class Value>
void take_out(std::vector<Value>& values, const std::vector<char>& out) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (out[i] == 0) values[kept++] = values[i];
  }
  values.resize(kept);
}

}  // namespace

void take_out_rows_without(RowTable& table, ResampleReport& report) {
  std::vector<char> without(table.t.size(), 0);
  for (const SignalRows& signal : table.signals) {
    if (signal.column != Column::u && signal.column != Column::y) continue;
    const auto before = std::ranges::count(without, 1);
    const std::size_t stretches = mark_stretches(table.t, signal.values, without);
    const auto rows = std::ranges::count(without, 1) - before;
    if (rows == 0) continue;
    report.notes.push_back(
        counted(static_cast<std::size_t>(rows), "row", "rows") + " in " +
        counted(stretches, "long stretch", "long stretches") + " without a value of " +
        quoted(signal.name) +
        (signal.bad > 0 ? " (" + quoted(signal.bad_word) + ")" : std::string()) +
        ": taken as missing");
  }
  if (std::ranges::count(without, 1) == 0) return;
  take_out(table.t, without);
  take_out(table.line, without);
  for (SignalRows& signal : table.signals) take_out(signal.values, without);
}

}  // namespace workbench
