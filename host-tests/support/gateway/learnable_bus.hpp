// A bus with a simulated loop on it among other traffic, as a candump log.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "workbench/simulate/candump.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace support {

/// The loop of a scenario; a counter with a checksum, a temperature that drifts, and a
/// status that stands still besides.
inline std::string learnable_log(const char* scenario, std::uint64_t seed = 1) {
  const workbench::SimulatedLoop loop = *workbench::simulate(scenario, seed);
  std::ostringstream own;
  workbench::write_candump(loop, own);
  std::vector<std::pair<double, std::string>> lines;
  std::istringstream in(own.str());
  for (std::string line; std::getline(in, line);) {
    lines.emplace_back(std::stod(line.substr(1)), line);
  }
  std::mt19937 random(7);
  const auto other = [&](double t, const char* format, unsigned a, unsigned b) {
    char data[32];
    std::snprintf(data, sizeof data, format, a, b);
    char line[96];
    std::snprintf(line, sizeof line, "(%.6f) can0 %s", t, data);
    lines.emplace_back(t, line);
  };
  const double start = lines.front().first;
  const double end = lines.back().first;
  unsigned count = 0;
  double warm = 400;
  for (double t = start; t < end; t += loop.period_s) {
    ++count;
    warm += std::sin(static_cast<double>(count) / 300) +
            (static_cast<double>(random() % 100) - 49.5) / 50;
    other(t + 0.0011, "300#%02X%02XAA55", count & 0xFF,
          static_cast<unsigned>(random()) & 0xFF);
    const auto raw = static_cast<unsigned>(std::clamp(warm, 0.0, 65535.0));
    other(t + 0.0017, "301#%02X%02X", raw & 0xFF, raw >> 8);
    other(t + 0.0023, "302#01%02X", 0x7FU, 0U);
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string text;
  for (const auto& [t, line] : lines) text += line + '\n';
  return text;
}

}  // namespace support
