// What `explain` names in loops that nothing but their controller moves, under loads that
// nobody recorded: nothing between u and y can be told there.
//
//   score_explained [LOOPS=200] [FIRST_SEED=1]
//
// Half of the loops have loads that come back at their own time, half have loads that are
// switched at any time (clocked_loops.hpp). The valve follows u in all of them. A name
// counts as false where it lies between u and y: of 23 dead times that were named without
// (W31) the intervals of three held the true one. Loads and what the record shows may be
// there. The rule that is counted was chosen on seeds from 1001 on.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <string>

#include "clocked_loops.hpp"
#include "workbench/model/base/work.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/ladder.hpp"

namespace {

using score::Times;

struct Row {
  int loops = 0;
  int named = 0;
  int false_names = 0;
  int valves = 0;  // of the false names
};

bool is_between(const std::string& code) {
  const workbench::Effect* effect = workbench::standard_catalogue().find(code);
  return effect->description().needs_u;
}

void count(const workbench::ExplainResult& result, Row& row) {
  ++row.loops;
  const workbench::Candidate* best = result.best();
  if (best == nullptr) return;
  ++row.named;
  bool between = false;
  bool valve = false;
  for (const std::string& code : members_of(*best)) {
    between |= is_between(code);
    valve |= code.starts_with("valve.");
  }
  row.false_names += between;
  row.valves += valve;
}

}  // namespace

int main(int argc, char** argv) {
  const int loops = argc > 1 ? std::atoi(argv[1]) : 200;
  const int first = argc > 2 ? std::atoi(argv[2]) : 1;
  if (loops < 2 || first < 0) {
    std::fprintf(stderr, "score_explained: expected 2 loops or more, and a seed\n");
    return 2;
  }
  const workbench::Work work({.threads = workbench::Work::cores()});
  std::mutex mutex;
  std::map<std::string, Row> rows;
  work.for_each(static_cast<std::size_t>(loops), [&](std::size_t i) {
    const Times times = i % 2 == 0 ? Times::kItsOwn : Times::kAny;
    const std::uint64_t seed = static_cast<std::uint64_t>(first) + i / 2;
    const workbench::Recording recording = score::clocked_loop(seed, times).recording;
    const workbench::Model model =
        workbench::start_model(recording, workbench::Column::y).model;
    const workbench::ExplainResult result = workbench::explain(recording, model);
    const std::lock_guard lock(mutex);
    count(result, rows["all"]);
    count(result,
          rows[times == Times::kAny ? "switched at any time" : "at its own time"]);
  });
  std::printf(
      "Nothing but the controller moves u: what explain names\n\n"
      "| load | loops | named | between u and y, which is false | %% | of these a valve "
      "|\n"
      "|---|---|---|---|---|---|\n");
  for (const auto& [name, row] : rows) {
    std::printf("| %s | %d | %d | %d | %.1f | %d |\n", name.c_str(), row.loops, row.named,
                row.false_names, 100.0 * row.false_names / row.loops, row.valves);
  }
}
