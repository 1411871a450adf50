#include "workbench/recording/cut_times.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr std::size_t kFewestStamps = 4;
constexpr double kCopies = 0.5;  // share of rows that repeat the row before whole

// Rows first to last - 1 share a stamp.
struct Group {
  std::size_t first;
  std::size_t last;
  [[nodiscard]] std::size_t size() const { return last - first; }
};

std::vector<Group> groups_of(const std::vector<double>& t) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (i == 0 || t[i] != t[i - 1]) groups.push_back({i, i});
    groups.back().last = i + 1;
  }
  return groups;
}

// The step of the stamps, 60 or 1 s; 0: another, or not throughout.
double step_of(const RowTable& table, const std::vector<Group>& groups,
               const TimesOfRows& times) {
  const double step = table.t[groups[1].first] - table.t[groups[0].first];
  if (step != 60 && step != 1) return 0;
  const double phase = clock_time(times, table.t[0]).seconds / step;
  if (phase != std::floor(phase)) return 0;
  for (std::size_t g = 1; g < groups.size(); ++g) {
    if (table.t[groups[g].first] - table.t[groups[g - 1].first] != step) return 0;
  }
  return step;
}

bool complete_and_no_copies(const RowTable& table) {
  std::size_t copies = 0;
  for (std::size_t i = 0; i < table.t.size(); ++i) {
    bool same = i > 0;
    for (const SignalRows& signal : table.signals) {
      if (signal.column == Column::t) continue;
      if (std::isnan(signal.values[i])) return false;
      same = same && signal.values[i] == signal.values[i - 1];
    }
    if (same && table.t[i] == table.t[i - 1]) ++copies;
  }
  return static_cast<double>(copies) < kCopies * static_cast<double>(table.t.size());
}

}  // namespace

std::string spread_cut_times(RowTable& table, const TimesOfRows& times) {
  if ((!times.dated && !times.time_of_day) || table.t.empty()) return {};
  const std::vector<Group> groups = groups_of(table.t);
  if (groups.size() < kFewestStamps || groups.size() * 2 > table.t.size()) return {};
  std::size_t fewest = table.t.size();
  std::size_t most = 0;
  for (std::size_t g = 1; g + 1 < groups.size(); ++g) {
    fewest = std::min(fewest, groups[g].size());
    most = std::max(most, groups[g].size());
  }
  const double step = step_of(table, groups, times);
  const bool even = most - fewest <= std::max<std::size_t>(1, most / 10);
  const bool ends_fit = groups.front().size() <= most && groups.back().size() <= most;
  if (step == 0 || fewest < 2 || !even || !ends_fit || !complete_and_no_copies(table)) {
    return {};
  }
  for (const Group& group : groups) {
    const bool first = group.first == 0;
    const bool last = group.last == table.t.size();
    const std::size_t rows = first || last ? most : group.size();
    const std::size_t before = first ? most - group.size() : 0;
    const double stamp = table.t[group.first];
    for (std::size_t i = group.first; i < group.last; ++i) {
      table.t[i] = stamp + step * static_cast<double>(before + i - group.first) /
                               static_cast<double>(rows);
    }
  }
  return "the times are cut to whole " + std::string(step == 60 ? "minutes" : "seconds") +
         ": the " +
         (fewest == most ? std::to_string(most)
                         : std::to_string(fewest) + " to " + std::to_string(most)) +
         " rows of each are taken as equally spaced";
}

}  // namespace workbench
