// How often a load that comes back at its own time, or at any time, is taken for a
// sticking valve.
//
//   score_clocked [LOOPS=600] [SWITCHED=300]
//
// Draws loops whose valve follows, under loads that repeat: steps, ramps, saw teeth and
// other shapes, before or behind the process, with an exact clock or one whose periods
// vary by 2 or 5 %, as pumps between two level switches, batches and neighbours that hunt
// have. Half of them are recorded whenever the controller acts, a quarter each at every
// second and every third of its samples: what u and y did in between is lost, which makes
// fewer of them look like a valve. SWITCHED more loops have loads that are on or off for
// times of any length, as a feed or a consumer. Identifies each and prints Markdown
// tables of the verdicts. Nothing was chosen on these loops.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "clocked_loops.hpp"
#include "workbench/analysis/analysis.hpp"

namespace {

using ident::Verdict;
using score::ClockedLoop;
using score::Times;

struct Row {
  int loops = 0;
  std::map<Verdict, int> verdicts;
  void add(Verdict verdict) {
    ++loops;
    ++verdicts[verdict];
  }
};

std::string recorded(const ClockedLoop& loop) {
  return "1 in " + std::to_string(loop.every);
}

void tell(const char* title, const std::map<std::string, Row>& rows) {
  std::printf(
      "| %s | n | stiction or backlash | %% | no stiction | undecided |\n"
      "|---|---|---|---|---|---|\n",
      title);
  for (const auto& [name, row] : rows) {
    const auto of = [&row](Verdict verdict) {
      const auto found = row.verdicts.find(verdict);
      return found == row.verdicts.end() ? 0 : found->second;
    };
    const int faults = of(Verdict::kStiction) + of(Verdict::kBacklash);
    std::printf("| %s | %d | %d | %.1f | %d | %d |\n", name.c_str(), row.loops, faults,
                100.0 * faults / row.loops, of(Verdict::kNoStiction),
                row.loops - faults - of(Verdict::kNoStiction));
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const int loops = argc > 1 ? std::atoi(argv[1]) : 600;
  const int switched = argc > 2 ? std::atoi(argv[2]) : 300;
  if (loops < 1 || switched < 1) {
    std::fprintf(stderr, "score_clocked: expected numbers of loops, 1 or more\n");
    return 2;
  }
  std::map<std::string, Row> by_shape;
  std::map<std::string, Row> by_jitter;
  std::map<std::string, Row> by_every;
  const auto verdict_on = [](const ClockedLoop& loop) {
    return workbench::Analysis(loop.recording).result().verdict;
  };
  for (int seed = 1; seed <= loops; ++seed) {
    const ClockedLoop loop =
        score::clocked_loop(static_cast<std::uint64_t>(seed), Times::kItsOwn);
    const Verdict verdict = verdict_on(loop);
    by_shape[score::kShapes[loop.shape]].add(verdict);
    char jitter[32];
    std::snprintf(jitter, sizeof jitter, "%.0f %%", 100 * loop.jitter);
    by_jitter[jitter].add(verdict);
    by_jitter["all"].add(verdict);
    by_every[recorded(loop)].add(verdict);
  }
  std::map<std::string, Row> by_any;
  for (int seed = 1; seed <= switched; ++seed) {
    const ClockedLoop loop =
        score::clocked_loop(static_cast<std::uint64_t>(seed), Times::kAny);
    const Verdict verdict = verdict_on(loop);
    by_any[recorded(loop)].add(verdict);
    by_any["all"].add(verdict);
  }
  std::printf(
      "Loops whose valve follows, under a load that comes back at its own time\n\n");
  tell("shape of the load", by_shape);
  tell("its periods vary by", by_jitter);
  tell("samples of the controller that are recorded", by_every);
  std::printf("Loops whose valve follows, under a load that is switched at any time\n\n");
  tell("samples of the controller that are recorded", by_any);
}
