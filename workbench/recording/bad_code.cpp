#include "workbench/recording/bad_code.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "workbench/recording/input_error.hpp"

namespace workbench {
namespace {

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
