#include "workbench/recording/resample.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/rows/long_gaps.hpp"
#include "workbench/recording/statistics.hpp"
#include "workbench/recording/times/rounded_times.hpp"

namespace workbench {
namespace {

constexpr double kOnTime = 0.10;            // of a period: still this instant's sample
constexpr double kRegular = 0.01;           // of a period: not worth a word
constexpr double kLongestRefiningStep = 3;  // periods: longer ones say little about one
constexpr double kMostlyOnTime = 0.9;  // share above which the mean replaces the median
constexpr double kShortestPeriodS = 1e-9;

// Twelve significant digits: 0.1 stays 0.1 after a mean over thousands of stamps.
double tidy(double value) {
  return std::strtod(number(value, 12).c_str(), nullptr);
}

// Of one recording.
std::size_t longest_interval(const TimedRows& rows) {
  const std::vector<double>& t = rows.t;
  std::size_t worst = 1;
  double longest = 0;
  auto between = rows.between.begin();
  for (std::size_t i = 1; i < t.size(); ++i) {
    between = std::find_if(between, rows.between.end(),
                           [&](double time) { return time > t[i - 1]; });
    const bool apart = between != rows.between.end() && *between < t[i];
    if (apart || t[i] - t[i - 1] <= longest) continue;
    longest = t[i] - t[i - 1];
    worst = i;
  }
  return worst;
}

}  // namespace

std::string number(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string instant(double t_s, double period_s, int digits) {
  constexpr double kUsual = 1e6;
  if (std::abs(t_s) < kUsual * std::max(period_s, 1.0)) return number(t_s, digits);
  char text[64];
  const int decimals = static_cast<int>(std::ceil(-std::log10(period_s)));
  std::snprintf(text, sizeof text, "%.*f", std::clamp(decimals, 0, 9), t_s);
  return text;
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

double most_instants(std::size_t rows) {
  constexpr double kGrowth = 20;
  constexpr double kFreeGrowth = 1000;
  return std::min(static_cast<double>(kMaxSamples),
                  kGrowth * static_cast<double>(rows) + kFreeGrowth);
}

Spacing spacing_of(std::span<const double> t) {
  std::vector<double> intervals = intervals_of(t);
  const double median = of_rank(intervals, intervals.size() / 2);

  double span = 0;
  double steps = 0;
  std::size_t agreeing = 0;
  for (const double interval : intervals) {
    const double multiple = std::round(interval / median);
    const bool short_enough = multiple >= 1 && multiple <= kLongestRefiningStep;
    if (!short_enough || std::abs(interval / median - multiple) > kOnTime) continue;
    ++agreeing;
    span += interval;
    steps += multiple;
  }
  const auto total = static_cast<double>(intervals.size());
  Spacing spacing;
  spacing.period_s = tidy(
      static_cast<double>(agreeing) >= kMostlyOnTime * total ? span / steps : median);

  std::size_t on_time = 0;
  for (const double interval : intervals) {
    const double ratio = interval / spacing.period_s;
    const double multiple = std::max(1.0, std::round(ratio));
    const double off = std::abs(ratio - multiple);
    if (!(off <= kRegular)) ++spacing.irregular;
    if (off <= kOnTime) ++on_time;
  }
  spacing.on_time_share = static_cast<double>(on_time) / total;
  return spacing;
}

namespace {

// Refuses what is no recording in samples.
void check_span(const TimedRows& rows, const std::string& file, double period,
                std::size_t widest) {
  const double first = rows.t.front();
  const double last = rows.t.back();
  const double coarseness = 8 * std::numeric_limits<double>::epsilon() *
                            std::max(std::abs(first), std::abs(last));
  if (!(period >= kShortestPeriodS) || !(period > coarseness)) {
    throw InputError(
        file, rows.line[1], 0, "time stamps in seconds that tell samples apart",
        "a median interval of " + number(period) + " s near t = " + number(last),
        "write the time with more digits, or from 0");
  }
  const double instants = std::round((last - first) / period) + 1;
  const double limit = most_instants(rows.t.size());
  if (!(instants <= limit)) {
    throw InputError(file, rows.line[widest], 0,
                     "a recording of at most " + number(limit, 9) + " instants",
                     number(instants, 9) + " instants, with a gap of " +
                         number(rows.t[widest] - rows.t[widest - 1]) +
                         " s where samples are " + number(period) + " s apart",
                     "split the recording at the gap");
  }
}

void note_gap(std::size_t from, std::size_t to, std::size_t shortest,
              ResampleReport& report) {
  if (to - from >= shortest) report.gaps.push_back({from, to});
}

// The row whose values hold at each instant, of rows that lie on the grid; empty where
// each instant has its own.
std::vector<std::uint32_t> rows_on_grid(const std::vector<double>& t, double period,
                                        std::size_t shortest_gap,
                                        ResampleReport& report) {
  std::vector<std::uint32_t> index;
  index.reserve(
      static_cast<std::size_t>(std::round((t.back() - t.front()) / period) + 1));
  index.push_back(0);
  for (std::size_t i = 1; i < t.size(); ++i) {
    const auto steps = static_cast<std::size_t>(std::round((t[i] - t[i - 1]) / period));
    const std::size_t since = index.size();
    index.insert(index.end(), std::max<std::size_t>(steps, 1) - 1,
                 static_cast<std::uint32_t>(i - 1));
    note_gap(since, index.size(), shortest_gap, report);
    index.push_back(static_cast<std::uint32_t>(i));
  }
  report.missing += index.size() - t.size();
  if (index.size() == t.size()) index.clear();
  return index;
}

// The same of rows beside the grid.
std::vector<std::uint32_t> rows_held(const std::vector<double>& t, double period,
                                     std::size_t shortest_gap, ResampleReport& report) {
  const double first = t.front();
  const auto total =
      static_cast<std::size_t>(std::floor((t.back() - first) / period + kOnTime)) + 1;
  std::vector<std::uint32_t> index;
  index.reserve(total);
  std::size_t row = 0;
  std::size_t since = 0;
  for (std::size_t k = 0; k < total; ++k) {
    const double latest = first + (static_cast<double>(k) + kOnTime) * period;
    const std::size_t before = row;
    while (row + 1 < t.size() && t[row + 1] <= latest) ++row;
    if (k > 0 && row == before) {
      ++report.missing;
    } else {
      note_gap(since, k, shortest_gap, report);
      since = k + 1;
    }
    index.push_back(static_cast<std::uint32_t>(row));
  }
  if (index.size() < 2) index.push_back(static_cast<std::uint32_t>(t.size() - 1));
  return index;
}

// The instants between recordings. `index` ascends.
std::vector<SampleRange> gaps_between(const TimedRows& rows,
                                      const std::vector<std::uint32_t>& index) {
  const auto place_of = [&index](std::size_t row) {
    return static_cast<std::size_t>(std::ranges::lower_bound(index, row) - index.begin());
  };
  std::vector<SampleRange> out;
  for (const double time : rows.between) {
    const auto next = std::ranges::upper_bound(rows.t, time);
    if (next == rows.t.begin() || next == rows.t.end()) continue;
    const std::size_t end = place_of(static_cast<std::size_t>(next - rows.t.begin()));
    if (end == 0 || end == index.size()) continue;
    const std::size_t first = place_of(index[end - 1]) + 1;
    if (first < end) out.push_back({first, end});
  }
  return out;
}

// Values and times at the instants; an empty index leaves them as they are.
void take_rows(TimedRows&& rows, const std::vector<std::uint32_t>& index,
               const Spacing& spacing, Recording& out) {
  const auto take = [&](std::vector<double>& from, std::vector<double>& to) {
    if (index.empty() || from.empty()) {
      to = std::move(from);
      return;
    }
    to.resize(index.size());
    for (std::size_t i = 0; i < index.size(); ++i) to[i] = from[index[i]];
  };
  for (const Column column : kLoopColumns) {
    take(rows.values[static_cast<std::size_t>(column)], out.values(column));
  }
  for (std::size_t i = 0; i < rows.loads.size(); ++i) {
    take(rows.loads[i], out.loads[i].values);
  }
  if (index.empty() && spacing.irregular == 0) {
    out.t = std::move(rows.t);
    return;
  }
  out.t.resize(index.empty() ? rows.t.size() : index.size());
  for (std::size_t i = 0; i < out.t.size(); ++i) {
    out.t[i] = rows.t.front() + static_cast<double>(i) * spacing.period_s;
  }
}

// Where the longest interval is, in words.
struct Widest {
  std::size_t line = 0;
  std::string text;
};

void refuse_mostly_held(const Widest& widest, const std::string& file,
                        std::size_t missing, std::size_t instants) {
  constexpr double kMostHeld = 0.5;
  if (static_cast<double>(missing) <= kMostHeld * static_cast<double>(instants)) return;
  throw InputError(file, widest.line, 0, "a sample of its own at most instants",
                   std::to_string(missing) + " of " + std::to_string(instants) +
                       " instants without one (" + widest.text + ")",
                   "split the recording at the gap, or export it at a fixed period");
}

// What was mended, in words.
void note_spacing(const Spacing& spacing, bool on_grid,
                  const std::optional<ScatteredTimes>& scattered,
                  const std::string& where, ResampleReport& report) {
  const std::string period = number(spacing.period_s);
  if (scattered) {
    report.notes.push_back(counted(spacing.irregular, "interval is", "intervals are") +
                           " irregular, and no stamp is more than " +
                           number(scattered->most_off_s, 2) + " s off steps of " +
                           period + " s: taken as equally spaced");
    return;
  }
  const std::size_t held =
      report.missing - std::min(report.missing, samples_in(report.gaps));
  if (!on_grid) {
    report.notes.push_back(counted(spacing.irregular, "interval is", "intervals are") +
                           " irregular (" + where + "): resampled every " + period +
                           " s by zero-order hold; " +
                           counted(held, "instant has", "instants have") +
                           " no sample: the value before is held");
  } else if (held > 0 && report.resampled) {
    report.notes.push_back(counted(held, "sample is", "samples are") + " missing (" +
                           where + "): the value before is held");
  }
  if (!report.gaps.empty()) {
    report.notes.push_back(note_on_gaps(report.gaps, spacing.period_s));
  }
  if (on_grid && spacing.irregular > 0) {
    report.notes.push_back(counted(spacing.irregular, "interval is", "intervals are") +
                           " more than 1 % and at most 10 % off " + period +
                           " s: taken as equally spaced");
  }
}

}  // namespace

void resample(TimedRows&& rows, const std::string& file, Recording& out) {
  const std::size_t count = rows.t.size();
  if (count < 2) {
    throw InputError(file, count == 0 ? 0 : rows.line[0], 0, "at least 2 samples",
                     count == 0 ? "none" : "1 at different times",
                     "record for longer, or check the time column");
  }
  const std::size_t widest = longest_interval(rows);
  Spacing spacing = spacing_of(rows.t);
  std::optional<ScatteredTimes> scattered;
  if (spacing.on_time_share < 1 && rows.between.empty())
    scattered = scattered_times(rows.t);
  if (scattered) spacing.period_s = tidy(scattered->period_s);
  check_span(rows, file, spacing.period_s, widest);

  ResampleReport& report = out.resampling;
  report.rows += count;
  report.irregular += spacing.irregular;
  report.longest_gap_s = rows.t[widest] - rows.t[widest - 1];
  out.period_s = spacing.period_s;
  const Widest longest{rows.line[widest], "longest gap " + number(report.longest_gap_s) +
                                              " s before " + std::string(rows.place) +
                                              ' ' + std::to_string(rows.line[widest])};
  const std::size_t missing_before = report.missing;
  const bool on_grid = spacing.on_time_share >= 1;
  const std::size_t shortest = shortest_gap(rows.t, spacing);
  const std::vector<std::uint32_t> index =
      scattered ? std::vector<std::uint32_t>{}
      : on_grid ? rows_on_grid(rows.t, spacing.period_s, shortest, report)
                : rows_held(rows.t, spacing.period_s, shortest, report);
  report.resampled = !index.empty();
  const std::vector<SampleRange> between = gaps_between(rows, index);
  std::erase_if(report.gaps, [&between](const SampleRange& gap) {
    return std::ranges::find(between, gap.last, &SampleRange::last) != between.end();
  });
  report.missing -= samples_in(between);
  take_rows(std::move(rows), index, spacing, out);
  keep_long_gaps(out);
  const std::size_t in_gaps = samples_in(report.gaps);
  refuse_mostly_held(longest, file, report.missing - missing_before - in_gaps,
                     out.size() - in_gaps - samples_in(between));
  note_spacing(spacing, on_grid, scattered, longest.text, report);
  report.gaps.insert(report.gaps.end(), between.begin(), between.end());
  std::ranges::sort(report.gaps, {}, &SampleRange::first);
}

}  // namespace workbench
