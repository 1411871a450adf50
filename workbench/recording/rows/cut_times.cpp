#include "workbench/recording/rows/cut_times.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "workbench/recording/resample.hpp"
#include "workbench/recording/statistics.hpp"
#include "workbench/recording/times/rounded_times.hpp"

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

// `uneven`: how much the rows of a stamp may differ, of the most; then a few stamps may
// have fewer still, where rows are missing.
std::string spread_groups(RowTable& table, const TimesOfRows& times, double uneven) {
  constexpr double kMostWithMissing = 0.05;  // of the stamps
  const std::vector<Group> groups = groups_of(table.t);
  if (groups.size() < kFewestStamps || groups.size() * 2 > table.t.size()) return {};
  std::size_t most = 0;
  for (const Group& group : groups) most = std::max(most, group.size());
  const double least =
      static_cast<double>(most) -
      (uneven > 0 ? std::max(1.0, uneven * static_cast<double>(most)) : 0);
  std::size_t fewest = most;
  double with_missing = 0;
  for (std::size_t g = 1; g + 1 < groups.size(); ++g) {
    if (static_cast<double>(groups[g].size()) < least) {
      ++with_missing;
    } else {
      fewest = std::min(fewest, groups[g].size());
    }
  }
  const bool even = with_missing <= (uneven > 0 ? kMostWithMissing : 0) *
                                        static_cast<double>(groups.size());
  const double step = step_of(table, groups, times);
  if (step == 0 || fewest < 2 || !even || !complete_and_no_copies(table)) {
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

// Rows share stamps, and each that does says the same: they were written twice.
bool only_copies(const RowTable& table) {
  bool repeats = false;
  for (std::size_t i = 1; i < table.t.size(); ++i) {
    if (table.t[i] != table.t[i - 1]) continue;
    repeats = true;
    for (const SignalRows& signal : table.signals) {
      if (!are_alike(signal.values[i], signal.values[i - 1])) return false;
    }
  }
  return repeats;
}

std::string spread_rounded(RowTable& table) {
  if (!complete_and_no_copies(table)) return {};
  std::optional<RoundedTimes> times = unrounded(table.t);
  if (!times) return {};
  table.t = std::move(times->t);
  return "the times are written in steps of " + number(times->step) +
         " s: taken as equally spaced, one every " + number(times->period_s) + " s";
}

}  // namespace

std::string spread_cut_times(RowTable& table, const TimesOfRows& times) {
  if ((!times.dated && !times.time_of_day) || table.t.empty()) return {};
  if (only_copies(table)) return {};
  constexpr double kUneven = 0.1;
  std::string note = spread_groups(table, times, 0);
  if (note.empty()) note = spread_rounded(table);
  return note.empty() ? spread_groups(table, times, kUneven) : note;
}

}  // namespace workbench
