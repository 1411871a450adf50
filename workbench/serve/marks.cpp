#include "workbench/serve/marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

struct Run {
  std::size_t first;
  std::size_t length;
};

// Adds one sample to the run that ends before it, else a run of `length` to this sample.
void extend(std::vector<Run>& runs, std::size_t sample, std::size_t length) {
  if (!runs.empty() && runs.back().first + runs.back().length == sample) {
    ++runs.back().length;
  } else {
    runs.push_back({sample + 1 - length, length});
  }
}

// Stretches of equal values.
std::vector<Run> runs_of(const std::vector<double>& values) {
  std::vector<Run> out;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k > 0 && values[k] == values[k - 1]) {
      ++out.back().length;
    } else {
      out.push_back({k, 1});
    }
  }
  return out;
}

// Stretches in which the signal moves on by the same step from sample to sample.
std::vector<Run> straight_runs_of(const std::vector<double>& values) {
  const auto [low, high] = std::ranges::minmax_element(values);
  const double exact = 1e-9 * (*high - *low);
  std::vector<Run> out;
  for (std::size_t k = 2; k < values.size(); ++k) {
    const double step = values[k] - values[k - 1];
    const double before = values[k - 1] - values[k - 2];
    if (step != 0 && std::abs(step - before) <= exact) extend(out, k, 3);
  }
  return out;
}

// Where the signal jumps from one sample to the next; a jump over several is one.
std::vector<Run> jumps_of(const std::vector<double>& values) {
  constexpr double kOfSpan = 0.05;
  constexpr double kOfUsual = 8;
  const auto [low, high] = std::ranges::minmax_element(values);
  std::vector<double> moves;
  for (std::size_t k = 1; k < values.size(); ++k) {
    const double move = std::abs(values[k] - values[k - 1]);
    if (move > 0) moves.push_back(move);
  }
  if (moves.empty()) return {};
  const double most = of_rank(moves, moves.size() * 9 / 10);
  const double least = std::max(kOfSpan * (*high - *low), kOfUsual * most);
  std::vector<Run> out;
  for (std::size_t k = 1; k < values.size(); ++k) {
    if (std::abs(values[k] - values[k - 1]) >= least) extend(out, k, 2);
  }
  return out;
}

// More than half of it.
bool lies_in(const std::vector<SampleRange>& ranges, const Run& run) {
  std::size_t inside = 0;
  for (const SampleRange& part : clipped(ranges, {run.first, run.first + run.length})) {
    inside += part.last - part.first;
  }
  return 2 * inside > run.length;
}

// Half of all samples lie in runs at most this long.
std::size_t usual_length(std::vector<Run> runs, std::size_t samples) {
  std::ranges::sort(runs, [](const Run& a, const Run& b) { return a.length < b.length; });
  std::size_t seen = 0;
  for (const Run& run : runs) {
    seen += run.length;
    if (2 * seen >= samples) return run.length;
  }
  return 1;
}

}  // namespace

namespace {

// The marks of a recording, and how many samples each covers.
class FoundMarks {
 public:
  explicit FoundMarks(const Recording& recording) : recording_(recording) {}

  void look_at_u() {
    if (!recording_.has(Column::u)) return;
    const std::vector<double>& u = recording_.u;
    const auto [low, high] = std::ranges::minmax_element(u);
    const std::vector<Run> runs = runs_of(u);
    const std::size_t long_rest =
        std::max(kFewestMarked, 10 * usual_length(runs, u.size()));
    for (const Run& run : runs) {
      const double value = u[run.first];
      if (run.length >= kFewestMarked && (value == *low || value == *high)) {
        add(Mark::Kind::kLimit, run);
      } else if (run.length >= long_rest && !lies_in(recording_.manual, run)) {
        add(Mark::Kind::kRest, run);
      }
    }
    // Where the next recording begins u may be anywhere.
    const auto joins_pieces = [this](const Run& run) {
      return std::ranges::any_of(recording_.pieces, [&run](const Piece& piece) {
        return piece.first > run.first && piece.first < run.first + run.length;
      });
    };
    for (const Run& run : jumps_of(u)) {
      if (!joins_pieces(run)) add(Mark::Kind::kStep, run);
    }
  }

  void look_at_y() {
    if (!recording_.has(Column::y)) return;
    const std::vector<Run> runs = runs_of(recording_.y);
    const std::size_t usual = usual_length(runs, recording_.y.size());
    for (const Run& run : runs) {
      if (run.length >= std::max(kFewestMarked, 10 * usual)) add(Mark::Kind::kHeld, run);
    }
    for (const Run& run : straight_runs_of(recording_.y)) {
      if (run.length >= kFewestMarked) add(Mark::Kind::kStraight, run);
    }
  }

  void add_all(Mark::Kind kind, const std::vector<SampleRange>& ranges) {
    for (const SampleRange& range : ranges) {
      add(kind, {range.first, range.last - range.first});
    }
  }

  // The longest ones, in their order.
  std::vector<Mark> take() {
    std::ranges::sort(found_,
                      [](const Found& a, const Found& b) { return a.length > b.length; });
    if (found_.size() > kMostMarks) found_.resize(kMostMarks);
    std::ranges::sort(found_, [](const Found& a, const Found& b) {
      return a.mark.from_s < b.mark.from_s;
    });
    std::vector<Mark> out;
    for (const Found& one : found_) out.push_back(one.mark);
    return out;
  }

 private:
  struct Found {
    Mark mark;
    std::size_t length;
  };
  void add(Mark::Kind kind, const Run& run) {
    found_.push_back(
        {{kind, recording_.t[run.first], recording_.t[run.first + run.length - 1]},
         run.length});
  }

  const Recording& recording_;
  std::vector<Found> found_;
};

}  // namespace

std::vector<Mark> marks_of(const Recording& recording) {
  FoundMarks found(recording);
  found.look_at_u();
  found.add_all(Mark::Kind::kManual, recording.manual);
  found.add_all(Mark::Kind::kGap, recording.resampling.gaps);
  found.look_at_y();
  return found.take();
}

std::string_view name_of(Mark::Kind kind) {
  constexpr std::array<std::string_view, 7> kNames = {
      "limit", "rest", "held", "straight", "step", "gap", "manual"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace workbench
