// Judges the loops that score_rules wrote, by the judge it is linked with.
//
//   judge_again FILE
//
// Prints six numbers: sticking loops found and healthy ones blamed, simulated; the same
// under loads cut from recordings; healthy ones, and sticking ones, that are said not to
// stick.
#include <cstdio>

#include "ident/verdict/doubts.hpp"
#include "ident/verdict/judge.hpp"
#include "judged_loop.hpp"

namespace {

using workbench::test::JudgedLoop;

// The bands of a window that was left open are not kept: they are no ground for a doubt.
ident::PerStroke<double> fitted(const ident::Identification<double>& found) {
  const ident::Estimate<double> unknown{false, 1, 1, 1};
  return found.stick_band.ascending.known ? found.stick_band
                                          : ident::PerStroke<double>{unknown, unknown};
}

ident::Verdict judged(const ident::Identification<double>& found) {
  if (found.evidence.reversals == 0) {
    return found.verdict;  // refused before it was judged
  }
  return verdict_of(doubted(judge(found.evidence, found.loop), found.evidence,
                            found.health, fitted(found),
                            {found.oscillation.period_samples, found.fit_percent}));
}

}  // namespace

int main(int argc, char** argv) {
  std::FILE* file = argc == 2 ? std::fopen(argv[1], "rb") : nullptr;
  if (file == nullptr) {
    std::fprintf(stderr, "judge_again: expected a file that score_rules wrote\n");
    return 2;
  }
  int faults[2][2] = {};
  int cleared[2] = {};
  JudgedLoop loop;
  while (std::fread(&loop, sizeof loop, 1, file) == 1) {
    const ident::Verdict verdict = judged(loop.found);
    faults[loop.simulated ? 0 : 1][loop.sticks ? 0 : 1] += is_fault(verdict) ? 1 : 0;
    cleared[loop.sticks ? 1 : 0] += verdict == ident::Verdict::kNoStiction ? 1 : 0;
  }
  std::fclose(file);
  std::printf("%d %d %d %d %d %d\n", faults[0][0], faults[0][1], faults[1][0],
              faults[1][1], cleared[0], cleared[1]);
}
