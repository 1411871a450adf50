#include "workbench/recording/rows/restarts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

constexpr std::size_t kFewestOfRun = 20;  // rows, but of the last run
constexpr double kNear = 10;              // intervals between two beginnings
constexpr double kEqual = 2;              // intervals between two lengths
constexpr double kAlike = 0.1;            // of an interval, between two runs

// Where counters begin again: clocks in s, 15, 16, 31 and 32 bits of s and of ms.
constexpr std::array kFull = {1.0,     10.0,    60.0,    100.0,    1000.0,     3600.0,
                              43200.0, 86400.0, 604800., 32768.0,  65536.0,    32.768,
                              65.536,  10000.0, 100000., 2147483., 4294967.296};

double interval_of(std::span<const double> t) {
  std::vector<double> steps = intervals_of(t);
  return of_rank(steps, steps.size() / 2);
}

class Runs {
 public:
  Runs(const std::vector<double>& t, std::span<const std::size_t> headed,
       const RowTable& table)
      : t_(t), headed_(headed), table_(table) {
    for (std::size_t i = 1; i < t.size(); ++i) {
      if (t[i] < t[i - 1]) begin_.push_back(i);
    }
  }

  [[nodiscard]] const std::vector<std::size_t>& begin() const { return begin_; }
  [[nodiscard]] double interval() const { return interval_; }

  bool are_restarts() {
    if (begin_.empty() || begin_.front() < kFewestOfRun) return false;
    interval_ = interval_of(run(0));
    if (!is_even(run(0))) return false;
    for (std::size_t k = 1; k <= begin_.size(); ++k) {
      const bool last = k == begin_.size();
      if ((!last && run(k).size() < kFewestOfRun) || !is_even(run(k)) ||
          !begins_anew(k) || repeats_first(k)) {
        return false;
      }
    }
    return true;
  }

 private:
  [[nodiscard]] std::size_t first(std::size_t k) const {
    return k == 0 ? 0 : begin_[k - 1];
  }
  [[nodiscard]] std::span<const double> run(std::size_t k) const {
    const std::size_t end = k < begin_.size() ? begin_[k] : t_.size();
    return std::span(t_).subspan(first(k), end - first(k));
  }

  // Strictly rising, at the interval of the first run.
  [[nodiscard]] bool is_even(std::span<const double> run) const {
    if (run.size() < 2) return true;
    return std::ranges::adjacent_find(run, std::greater_equal<>()) == run.end() &&
           std::abs(interval_of(run) - interval_) <= kAlike * interval_;
  }

  // Whether run `k` begins where the first one did, and not because a counter was full.
  [[nodiscard]] bool begins_anew(std::size_t k) const {
    const double later = run(k).front() - t_.front();
    const bool headed = std::ranges::binary_search(headed_, first(k));
    if (headed) return later <= kNear * interval_;
    if (std::abs(later) > kNear * interval_) return false;
    const double end = run(k - 1).back() + interval_;
    const double length = end - run(k).front();
    const bool full = std::ranges::any_of(kFull, [&](double count) {
      return std::abs(end - count) <= interval_ || std::abs(length - count) <= interval_;
    });
    const double before = k < 2 ? 0 : run(k - 2).back() + interval_ - run(k - 1).front();
    return !full && std::abs(length - before) > kEqual * interval_;
  }

  // The rows of a file that was put into it twice.
  [[nodiscard]] bool repeats_first(std::size_t k) const {
    const std::size_t rows = std::min(run(0).size(), run(k).size());
    return rows > 1 && std::ranges::all_of(table_.signals, [&](const SignalRows& signal) {
             const auto from = [&](std::size_t row) {
               return std::span(signal.values).subspan(row, rows);
             };
             return std::ranges::equal(from(0), from(first(k)), are_alike);
           });
  }

  const std::vector<double>& t_;
  std::span<const std::size_t> headed_;
  const RowTable& table_;
  std::vector<std::size_t> begin_;  // of each run but the first
  double interval_ = 0;
};

}  // namespace

std::optional<Restarts> run_on(std::vector<double>& t,
                               std::span<const std::size_t> headed,
                               const RowTable& table) {
  Runs runs(t, headed, table);
  if (!runs.are_restarts()) return std::nullopt;
  const std::vector<std::size_t>& begin = runs.begin();
  const std::string after = number(t[begin[0] - 1]) + " s";
  const std::string line = std::to_string(table.line[begin[0]]);
  Restarts out;
  out.note =
      begin.size() == 1
          ? filled(
                "the times begin anew after {0} (line {1}): read as a recording of "
                "its own, behind a gap of unknown length",
                {after, line})
          : filled(
                "the times begin anew {0} times (first after {1}, line {2}): read as "
                "recordings of their own, with gaps of unknown length between",
                {std::to_string(begin.size()), after, line});
  double shift = 0;
  for (std::size_t k = 0; k < begin.size(); ++k) {
    const std::size_t end = k + 1 < begin.size() ? begin[k + 1] : t.size();
    const double before = t[begin[k] - 1];
    shift = before + kOutage * runs.interval() - t[begin[k]];
    out.between.push_back(before + kOutage * runs.interval() / 2);
    std::for_each(t.begin() + static_cast<std::ptrdiff_t>(begin[k]),
                  t.begin() + static_cast<std::ptrdiff_t>(end),
                  [shift](double& at) { at += shift; });
  }
  return out;
}

}  // namespace workbench
