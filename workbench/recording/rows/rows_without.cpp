#include "workbench/recording/rows/rows_without.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/rows/long_gaps.hpp"

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

constexpr double kBeyond = 1e29;  // no quantity of a plant in any unit
constexpr double kFar = 5;        // ranges of all other values

constexpr std::array kCodes = {
    -999.0,     999.0,        -999.25,       -999.9,      999.9,    -9999.0,   9999.0,
    -9999.9,    -99999.0,     99999.0,       -999999.0,   999999.0, -9999999., 9999999.,
    32767.0,    -32767.0,     -32768.0,      32768.0,     65535.0,  8388607.0, -8388608.,
    16777215.0, 2147483647.0, -2147483648.0, 4294967295.0};

bool is_code(double value) {
  return std::abs(value) >= kBeyond || std::ranges::find(kCodes, value) != kCodes.end();
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  std::size_t count = 0;

  // A constant signal is far from what exceeds it as many times.
  [[nodiscard]] bool far_from(double value) const {
    const double off = value > high ? value - high : low - value;
    const double size = high > low ? high - low : std::max(std::abs(high), std::abs(low));
    return off > kFar * size && off > 0;
  }
};

// Of all values that are no code.
Range range_of(const std::vector<double>& values) {
  Range out;
  for (const double value : values) {
    if (std::isnan(value) || is_code(value)) continue;
    out.low = std::min(out.low, value);
    out.high = std::max(out.high, value);
    ++out.count;
  }
  return out;
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

void take_out_codes(SignalRows& signal, ResampleReport& report) {
  if (signal.is_mode) return;
  const Range others = range_of(signal.values);
  std::map<double, std::size_t> found;
  std::size_t cells = 0;
  for (const double value : signal.values) {
    if (!is_code(value) || !others.far_from(value)) continue;
    ++found[value];
    ++cells;
  }
  if (cells == 0 || cells > others.count) return;
  for (double& value : signal.values) {
    if (found.contains(value)) value = kNoValue;
  }
  for (const auto& [code, count] : found) {
    report.notes.push_back(
        counted(count, "cell", "cells") + " of " + quoted(signal.name) + " with " +
        number(code, 8) + ", a code for a missing value far from all others (" +
        number(others.low) + " to " + number(others.high) + "): taken as no value");
    if (signal.bad == 0) signal.bad_word = number(code, 8);
    signal.bad += count;
  }
}

}  // namespace workbench
