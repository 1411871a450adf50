#include "workbench/recording/can/can_sampler.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/rows/long_gaps.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

constexpr double kOnTime = 0.1;          // of a period
constexpr double kMaxOversampling = 20;  // instants per frame of the slowest kind

// Part of a period between a nominal y frame and the instant of sampling: where the
// fewest frames arrive, weighted by the fourth power of closeness around the circle.
double quietest_phase(const std::vector<CanSeries>& all, double first, double period) {
  constexpr std::size_t kBins = 40;
  std::array<double, kBins> arrivals{};
  for (const CanSeries& s : all) {
    // Signals faster than that refresh within every period whatever the phase.
    if (!s.cyclic() || s.spacing.period_s < period / 2) continue;
    for (const double t : s.t) {
      const double cycles = (t - first) / period + 0.5 / kBins;
      const double phase = cycles - std::floor(cycles);
      const auto bin = static_cast<std::size_t>(phase * kBins);
      arrivals[std::min(bin, kBins - 1)] += 1 / static_cast<double>(s.t.size());
    }
  }
  std::size_t best = kBins / 2;
  double best_cost = HUGE_VAL;
  for (std::size_t candidate = 0; candidate < kBins; ++candidate) {
    double cost = 0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      const std::size_t apart = bin > candidate ? bin - candidate : candidate - bin;
      const std::size_t around = std::min(apart, kBins - apart);
      const double closeness =
          1 - 2 * static_cast<double>(around) / static_cast<double>(kBins);
      cost += arrivals[bin] * std::pow(closeness, 4);
    }
    if (cost < best_cost) {
      best_cost = cost;
      best = candidate;
    }
  }
  return static_cast<double>(best) / kBins;
}

// A quarter of the intervals are at least as long.
double later_interval(const std::vector<double>& t) {
  std::vector<double> intervals = intervals_of(t);
  return of_rank(intervals, (intervals.size() - 1) * 3 / 4);
}

class Sampler {
 public:
  Sampler(const std::vector<CanSeries>& series, const std::string& name)
      : series_(series), name_(name), reference_(reference_series(series)) {}

  void sample(std::optional<double> period_given, Recording& out) {
    choose_period(period_given);
    choose_instants();
    out.period_s = period_;
    ResampleReport& report = out.resampling;
    report.rows = reference_.t.size() + reference_.repeated;
    report.irregular = reference_.spacing.irregular;
    report.resampled = true;
    for (const CanSeries& s : series_) {
      report.repeated += s.repeated;
      if (!s.cyclic() && &s != &reference_) continue;
      for (std::size_t i = 1; i < s.t.size(); ++i) {
        report.longest_gap_s = std::max(report.longest_gap_s, s.t[i] - s.t[i - 1]);
      }
    }
    out.t.resize(count_);
    for (std::size_t k = 0; k < count_; ++k) {
      out.t[k] = first_ + static_cast<double>(k) * period_;
    }
    std::vector<bool> silent(count_, false);
    for (const CanSeries& s : series_) {
      const std::vector<std::uint32_t>& rows = rows_.emplace_back(rows_held(s));
      std::vector<double>& values = out.values(s.column);
      values.resize(count_);
      for (std::size_t k = 0; k < count_; ++k) values[k] = s.value[rows[k]];
      if (s.column == Column::u || s.column == Column::y) note_silence(s, rows, silent);
    }
    report.gaps = stretches_where(count_, [&](std::size_t k) { return silent[k]; });
    keep_long_gaps(out);
    count_missing(report);
    describe(report);
    if (!report.gaps.empty()) {
      report.notes.push_back(note_on_gaps(report.gaps, period_));
    }
  }

 private:
  static const CanSeries& reference_series(const std::vector<CanSeries>& series) {
    for (const Column column : {Column::y, Column::x, Column::u, Column::sp}) {
      for (const CanSeries& s : series) {
        if (s.column == column) return s;
      }
    }
    return series.front();
  }

  [[noreturn]] void fail(std::size_t line, std::string expected, std::string found,
                         std::string advice) const {
    throw InputError(name_, line, 0, std::move(expected), std::move(found),
                     std::move(advice));
  }

  void choose_period(std::optional<double> given) {
    const CanSeries& r = reference_;
    if (r.t.size() < 2 && r.repeated > 0) {
      fail(r.line.front(), "frames of " + r.title() + " at different times",
           counted(r.repeated + 1, "frame", "frames") + " at the same",
           "record with time stamps: candump -l");
    }
    if (r.t.size() < 2) {
      fail(r.line.front(), "at least 2 samples of " + r.title(), "1",
           "record for longer");
    }
    double natural = r.spacing.period_s;
    for (const CanSeries& s : series_) {
      if (s.column == Column::u && s.cyclic() && r.cyclic()) {
        natural = std::max(natural, s.spacing.period_s);
      }
    }
    period_ = given.value_or(natural);
    if (!(period_ >= 1e-9) || !(period_ * kMaxOversampling >= r.spacing.period_s)) {
      fail(r.line[1],
           "frames of " + r.title() + " at most " + number(kMaxOversampling) +
               " sample periods apart",
           "a median interval of " + number(r.spacing.period_s) + " s and a period of " +
               number(period_) + " s",
           "choose a longer sample period");
    }
  }

  void choose_instants() {
    const CanSeries& r = reference_;
    double known = r.t.front();
    for (const CanSeries& s : series_) known = std::max(known, s.t.front());
    const double delay = quietest_phase(series_, r.t.front(), period_) * period_;
    const auto start =
        std::ranges::find_if(r.t, [&](double t) { return t + delay >= known; });
    double last = r.t.back();
    for (const CanSeries& s : series_) {
      if (&s == &reference_ || s.column == Column::sp || !s.cyclic()) continue;
      last = std::min(last, s.t.back() + std::max(period_, s.spacing.period_s) - delay);
    }
    const double instants =
        start == r.t.end() ? 0 : std::floor((last - *start) / period_ + kOnTime) + 1;
    if (!(instants >= 2)) {
      fail(0, "all signals during at least 2 sample periods of " + number(period_) + " s",
           "hardly any common time", "record for longer, or check the signals");
    }
    if (!(period_ > 8 * std::numeric_limits<double>::epsilon() * std::abs(last))) {
      fail(0, "times that tell samples " + number(period_) + " s apart",
           number(last) + " s since the first line", "split the log");
    }
    if (instants > most_instants(r.t.size())) {
      const double later = later_interval(r.t);
      if (later > kMaxOversampling * period_) {
        fail(r.line.front(), "frames of " + r.title() + " one after the other",
             "bursts of frames " + number(r.spacing.period_s) + " s apart, every " +
                 number(later) + " s",
             "say how often to sample: --ts " + number(later, 3));
      }
      std::size_t widest = 1;
      for (std::size_t i = 2; i < r.t.size(); ++i) {
        if (r.t[i] - r.t[i - 1] > r.t[widest] - r.t[widest - 1]) widest = i;
      }
      fail(r.line[widest], "a log without long holes",
           "a gap of " + number(r.t[widest] - r.t[widest - 1]) + " s in " + r.title() +
               " and " + number(instants) + " sample periods of " + number(period_) +
               " s",
           "split the log at the gap");
    }
    first_ = *start;
    delay_ = delay;
    count_ = static_cast<std::size_t>(instants);
  }

  [[nodiscard]] double instant(std::size_t k) const {
    return first_ + delay_ + static_cast<double>(k) * period_;
  }

  [[nodiscard]] bool should_refresh(const CanSeries& s) const {
    return &s == &reference_ || (s.column != Column::sp && s.cyclic());
  }

  // The newest row of `s` at each instant.
  [[nodiscard]] std::vector<std::uint32_t> rows_held(const CanSeries& s) const {
    std::vector<std::uint32_t> rows(count_);
    std::uint32_t row = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      while (row + 1 < s.t.size() && s.t[row + 1] <= instant(k)) ++row;
      rows[k] = row;
    }
    return rows;
  }

  // Marks the instants in pauses that are no ordinary ones of `s`.
  void note_silence(const CanSeries& s, const std::vector<std::uint32_t>& rows,
                    std::vector<bool>& silent) const {
    if (!should_refresh(s) || s.t.size() < 3) return;
    const std::size_t shortest = shortest_gap(s.t, s.spacing);
    for (std::size_t k = 0; k < count_ && rows[k] + 1 < s.t.size(); ++k) {
      const double before = s.t[rows[k]];
      const double passed = (s.t[rows[k] + 1] - before) / s.spacing.period_s - 1;
      const bool fresh = instant(k) < before + std::max(period_, s.spacing.period_s);
      silent[k] = silent[k] || (!fresh && passed >= static_cast<double>(shortest));
    }
  }

  void refuse_mostly_held(const CanSeries& s, std::size_t unrefreshed,
                          const std::vector<bool>& in_gap) const {
    constexpr double kMostHeld = 0.5;
    const auto judged =
        count_ - static_cast<std::size_t>(std::ranges::count(in_gap, true));
    if (static_cast<double>(unrefreshed) <= kMostHeld * static_cast<double>(judged)) {
      return;
    }
    fail(0, "a frame of " + s.title() + " at most instants",
         std::to_string(unrefreshed) + " of " + std::to_string(judged) +
             " instants without one",
         "record where none are lost, or choose a longer period with --ts");
  }

  // Instants that a frame should have refreshed; those in gaps are told as such.
  void count_missing(ResampleReport& report) const {
    const std::vector<bool> in_gap = marked(report.gaps, count_);
    std::vector<bool> stale = in_gap;
    for (std::size_t i = 0; i < series_.size(); ++i) {
      const CanSeries& s = series_[i];
      if (!should_refresh(s) || s.spacing.period_s > 1.5 * period_) continue;
      std::size_t unrefreshed = 0;
      for (std::size_t k = 1; k < count_; ++k) {
        if (rows_[i][k] != rows_[i][k - 1]) continue;
        stale[k] = true;
        unrefreshed += !in_gap[k];
      }
      refuse_mostly_held(s, unrefreshed, in_gap);
      if (unrefreshed == 0) continue;
      report.notes.push_back(
          filled("{0} instants without a new frame of {1}: the value before is held",
                 {std::to_string(unrefreshed), s.title()}));
    }
    report.missing = static_cast<std::size_t>(std::ranges::count(stale, true));
  }

  void describe(ResampleReport& report) const {
    std::vector<std::string>& notes = report.notes;
    notes.push_back(filled("sampled every {0} s by zero-order hold", {number(period_)}));
    for (const CanSeries& s : series_) notes.push_back(values_of(s));
    if (reference_.spacing.irregular > 0) {
      notes.push_back(
          filled("{0} intervals of {1} are more than 1 % off",
                 {std::to_string(reference_.spacing.irregular), reference_.title()}));
    }
    for (const CanSeries& s : series_) {
      const auto say = [&](std::size_t count, const char* what) {
        if (count == 0) return;
        notes.push_back(filled(
            what, {std::to_string(count), s.title(), number(s.signal.signal.minimum),
                   number(s.signal.signal.maximum)}));
      };
      say(s.repeated, "{0} frames of {1} repeat the time of the one before: dropped");
      say(s.short_frames, "{0} frames of {1} are too short for the signal: ignored");
      say(s.not_available,
          "{0} frames of {1} hold the highest raw number, not available: left out");
      say(s.outside_limits,
          "{0} frames of {1} hold a value far outside its limits, {2} to {3}: left out");
      say(s.just_outside,
          "{0} frames of {1} hold a value just outside its limits, {2} to {3}: kept "
          "here, not by the gateway; correct the limits");
    }
  }

  static std::string values_of(const CanSeries& s) {
    const std::string count = std::to_string(s.t.size());
    if (s.t.size() < 2) return filled("{0}: {1} values", {s.title(), count});
    return filled(s.cyclic() ? "{0}: {1} values, median interval {2} s"
                             : "{0}: {1} values, median interval {2} s, not cyclic",
                  {s.title(), count, number(s.spacing.period_s)});
  }

  const std::vector<CanSeries>& series_;
  const std::string& name_;
  const CanSeries& reference_;
  double period_ = 0;
  double first_ = 0;  // nominal time of the first instant
  double delay_ = 0;  // from there to the instant of sampling
  std::size_t count_ = 0;
  std::vector<std::vector<std::uint32_t>> rows_;  // of each series, rows_held()
};

}  // namespace

void sample_series(const std::vector<CanSeries>& series, const std::string& name,
                   std::optional<double> period_s, Recording& out) {
  Sampler(series, name).sample(period_s, out);
}

}  // namespace workbench
