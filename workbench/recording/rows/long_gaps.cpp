#include "workbench/recording/rows/long_gaps.hpp"

#include <algorithm>
#include <limits>

#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

constexpr std::size_t kFewest = 10;  // instants
constexpr double kMoved = 0.5;       // of the standard deviation, on average …
constexpr double kAcross = 0.25;     // … and across the gap itself

double variance(const std::vector<double>& values, const std::vector<bool>& in_gap) {
  double count = 0, mean = 0, squares = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (in_gap[k]) continue;
    const double off = values[k] - mean;
    mean += off / ++count;
    squares += off * (values[k] - mean);
  }
  return count > 0 ? squares / count : 0;
}

// Mean square of what the values have moved by after `lag` samples.
double moved(const std::vector<double>& values, const std::vector<bool>& in_gap,
             std::size_t lag) {
  double count = 0, squares = 0;
  for (std::size_t k = lag; k < values.size(); ++k) {
    if (in_gap[k] || in_gap[k - lag]) continue;
    const double step = values[k] - values[k - lag];
    squares += step * step;
    ++count;
  }
  return count > 0 ? squares / count : 0;
}

// Samples after which the values are elsewhere; the largest number: never.
std::size_t samples_to_move(const std::vector<double>& values,
                            const std::vector<bool>& in_gap) {
  constexpr double kFiner = 1.1;
  const double enough = kMoved * kMoved * variance(values, in_gap);
  if (enough > 0) {
    for (std::size_t lag = 1; lag < values.size();) {
      if (moved(values, in_gap, lag) >= enough) return lag;
      lag =
          std::max(lag + 1, static_cast<std::size_t>(kFiner * static_cast<double>(lag)));
    }
  }
  return std::numeric_limits<std::size_t>::max();
}

// Whether the first value behind the gap is elsewhere than the last one before it.
bool moves_across(const std::vector<double>& values, const SampleRange& gap,
                  double enough) {
  if (gap.first == 0 || gap.last >= values.size()) return false;
  const double move = values[gap.last] - values[gap.first - 1];
  return enough > 0 && move * move >= enough;
}

}  // namespace

std::size_t shortest_gap(std::span<const double> t, const Spacing& spacing) {
  constexpr double kOrdinary = 0.95;
  constexpr double kLonger = 3;
  constexpr double kMostlyOnTime = 0.9;
  std::vector<double> intervals = intervals_of(t);
  const auto rank =
      static_cast<std::size_t>(kOrdinary * static_cast<double>(t.size() - 2));
  const double ordinary = of_rank(intervals, rank) / spacing.period_s;
  if (spacing.on_time_share < kMostlyOnTime && ordinary > kLonger) {
    return std::numeric_limits<std::size_t>::max();
  }
  return std::max(kFewest, static_cast<std::size_t>(kLonger * ordinary));
}

std::string note_on_gaps(const std::vector<SampleRange>& gaps, double period_s) {
  return counted(gaps.size(), "long gap is", "long gaps are") +
         " not judged: without samples for " +
         number(static_cast<double>(samples_in(gaps)) * period_s) +
         " s in all, so that the value before says nothing of what happened";
}

void keep_long_gaps(Recording& recording) {
  std::vector<SampleRange>& gaps = recording.resampling.gaps;
  if (gaps.empty() || (recording.u.empty() && recording.y.empty())) return;
  const std::vector<bool> in_gap = marked(gaps, recording.size());
  const std::size_t enough = std::min(samples_to_move(recording.u, in_gap),
                                      samples_to_move(recording.y, in_gap));
  const double far_in_u = kAcross * kAcross * variance(recording.u, in_gap);
  const double far_in_y = kAcross * kAcross * variance(recording.y, in_gap);
  std::erase_if(gaps, [&](const SampleRange& gap) {
    return gap.last - gap.first < enough && !moves_across(recording.u, gap, far_in_u) &&
           !moves_across(recording.y, gap, far_in_y);
  });
}

}  // namespace workbench
