#include "workbench/serve/marks.hpp"

#include <algorithm>

namespace workbench {
namespace {

struct Run {
  std::size_t first;
  std::size_t length;
};

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

// Half of all samples lie in runs at most this long.
std::size_t usual_length(std::vector<Run> runs, std::size_t samples) {
  std::sort(runs.begin(), runs.end(),
            [](const Run& a, const Run& b) { return a.length < b.length; });
  std::size_t seen = 0;
  for (const Run& run : runs) {
    seen += run.length;
    if (2 * seen >= samples) return run.length;
  }
  return 1;
}

}  // namespace

std::vector<Mark> marks_of(const Recording& recording) {
  struct Found {
    Mark mark;
    std::size_t length;
  };
  std::vector<Found> found;
  const auto add = [&](Mark::Kind kind, const Run& run) {
    found.push_back(
        {{kind, recording.t[run.first], recording.t[run.first + run.length - 1]},
         run.length});
  };
  if (recording.has(Column::u)) {
    const auto [low, high] = std::minmax_element(recording.u.begin(), recording.u.end());
    for (const Run& run : runs_of(recording.u)) {
      const double value = recording.u[run.first];
      if (run.length >= kFewestMarked && (value == *low || value == *high)) {
        add(Mark::Kind::kLimit, run);
      }
    }
  }
  if (recording.has(Column::y)) {
    const std::vector<Run> runs = runs_of(recording.y);
    const std::size_t usual = usual_length(runs, recording.y.size());
    for (const Run& run : runs) {
      if (run.length >= std::max(kFewestMarked, 10 * usual)) add(Mark::Kind::kHeld, run);
    }
  }
  std::sort(found.begin(), found.end(),
            [](const Found& a, const Found& b) { return a.length > b.length; });
  if (found.size() > kMostMarks) found.resize(kMostMarks);
  std::sort(found.begin(), found.end(),
            [](const Found& a, const Found& b) { return a.mark.from_s < b.mark.from_s; });
  std::vector<Mark> out;
  for (const Found& one : found) out.push_back(one.mark);
  return out;
}

std::string_view name_of(Mark::Kind kind) {
  return kind == Mark::Kind::kLimit ? "limit" : "held";
}

}  // namespace workbench
