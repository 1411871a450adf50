// What gaps, and a historian that samples more seldom than the controller acts, do to the
// verdict.
//
//   score_interrupted [SEEDS=12]
//
// Takes simulated loops as they are, with 1, 3, 5 and 12 gaps at instants drawn from the
// seed, and with every second, third and fifth row alone, identifies each as `stickband
// identify` does, and prints Markdown tables of the verdicts. No threshold was chosen on
// these seeds; the widening of the intervals was, on the first 20 of each scenario,
// whole.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "workbench/analysis/analysis.hpp"
#include "workbench/model/base/joined.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace {

using ident::Verdict;
using workbench::Recording;

constexpr std::array kSticking = {"stiction",           "stiction-one-sided",
                                  "stiction-mixed",     "stiction-setpoint",
                                  "stiction-few-steps", "backlash"};
constexpr std::array kHealthy = {"external-sinusoid", "tight-tuning",   "setpoint",
                                 "random-load",       "load-and-noise", "few-steps"};

Recording recording_of(const workbench::SimulatedLoop& loop, std::size_t every) {
  Recording out;
  out.name = "loop.csv";
  out.period_s = loop.period_s * static_cast<double>(every);
  for (std::size_t k = 0; k < loop.u.size(); k += every) {
    out.t.push_back(loop.t[k]);
    out.u.push_back(loop.u[k]);
    out.y.push_back(loop.y[k]);
    if (!loop.sp.empty()) out.sp.push_back(loop.sp[k]);
  }
  return out;
}

// Holds u and y over `gaps` stretches of 15 to 80 samples, as a reader does.
void interrupt(Recording& recording, int gaps, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto drawn = [&random](std::size_t low, std::size_t high) {
    return low + static_cast<std::size_t>(random() % (high - low));
  };
  std::vector<workbench::SampleRange> found;
  for (int i = 0; i < gaps; ++i) {
    const std::size_t first = drawn(50, recording.size() - 100);
    found.push_back({first, std::min(first + drawn(15, 80), recording.size() - 10)});
  }
  recording.resampling.gaps = workbench::united(std::move(found), {});
  for (const workbench::SampleRange& gap : recording.resampling.gaps) {
    for (std::size_t k = gap.first; k < gap.last; ++k) {
      recording.u[k] = recording.u[gap.first - 1];
      recording.y[k] = recording.y[gap.first - 1];
    }
  }
}

struct Row {
  int loops = 0;
  int faults = 0;
  int healthy = 0;
  void add(Verdict verdict) {
    ++loops;
    faults += is_fault(verdict);
    healthy += verdict == Verdict::kNoStiction;
  }
};

template <class Names>
void tell(const char* title, const Names& names, int seeds) {
  std::map<std::string, Row> rows;
  for (const char* name : names) {
    for (int seed = 1; seed <= seeds; ++seed) {
      const auto loop = workbench::simulate(name, static_cast<std::uint64_t>(seed));
      if (!loop) continue;
      for (const int gaps : {0, 1, 3, 5, 12}) {
        Recording one = recording_of(*loop, 1);
        interrupt(one, gaps, static_cast<std::uint64_t>(100 * seed + gaps));
        const std::string row = "gaps " + std::string(gaps < 10 ? " " : "");
        rows[row + std::to_string(gaps)].add(workbench::Analysis(one).result().verdict);
      }
      for (const std::size_t every : {std::size_t{2}, std::size_t{3}, std::size_t{5}}) {
        const Recording one = recording_of(*loop, every);
        rows["row  1 of " + std::to_string(every)].add(
            workbench::Analysis(one).result().verdict);
      }
    }
  }
  std::printf(
      "%s\n\n| recording | n | a fault %% | no stiction %% | open %% |\n"
      "|---|---|---|---|---|\n",
      title);
  for (const auto& [name, row] : rows) {
    const double all = row.loops / 100.0;
    std::printf("| %s | %d | %.1f | %.1f | %.1f |\n", name.c_str(), row.loops,
                row.faults / all, row.healthy / all,
                (row.loops - row.faults - row.healthy) / all);
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 12;
  if (seeds < 1) {
    std::fprintf(stderr, "score_interrupted: expected a number of seeds, 1 or more\n");
    return 2;
  }
  tell("Loops that stick or have play", kSticking, seeds);
  tell("Loops that do not", kHealthy, seeds);
}
