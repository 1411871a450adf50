// The hidden-effect benchmark: loops with a physical effect that a textbook model lacks,
// handed to the workbench's ladder as bare recordings. Prints Markdown tables; progress,
// failures and details go to stderr.
//
//   score_hidden [--seeds N] [--first-seed S] [--clean N] [--quick] [--part NAME]
//                [--only TEXT] [--details]
//     --seeds N       loops of each effect, excitation and signal-to-noise ratio; 5
//     --first-seed S  1; the engine's thresholds were chosen on seeds from 1000 on
//     --clean N       loops without any effect; 100 for each seed
//     --quick         one seed, 30 clean loops
//     --part NAME     one kind alone: one | two | clean | unexcited
//     --only TEXT     cases whose line in --details contains TEXT before the colon
//     --details       one line for each case on stderr
//   exits with 1 when the engine failed on a recording
//   score_hidden --csv EFFECT[+EFFECT]|clean steps|cycle|quiet|beyond RATIO SEED
//   [SAMPLES]
//     prints the recording of one case as CSV; 1,500 samples
//   score_hidden --list
//     the effects and pairs that have cases, as --csv takes them, one a line
//   score_hidden --explain-time SAMPLES SEED
//     processor seconds that explaining the textbook model takes, for a recording of each
//     pair of effects
//
// A case takes about one ladder and one fit; two threads.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "hidden/case_list.hpp"
#include "hidden/tables.hpp"
#include "workbench/model/base/blocks.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/ladder.hpp"

namespace {

struct Options {
  hidden::Seeds seeds;
  int clean = -1;
  std::string only;
  std::string part;
  bool details = false;
};

int usage() {
  std::fputs(
      "usage: score_hidden [--seeds N] [--first-seed S] [--clean N] [--quick] "
      "[--part one|two|clean|unexcited] [--only TEXT] [--details]\n"
      "       score_hidden --csv EFFECT[+EFFECT]|clean steps|cycle|quiet|beyond RATIO "
      "SEED [SAMPLES]\n"
      "       score_hidden --list\n"
      "       score_hidden --explain-time SAMPLES SEED\n",
      stderr);
  return 2;
}

int print_csv(const hidden::CaseKey& key) {
  try {
    const workbench::Recording recording = hidden::make_case(key).recording;
    std::puts("t,u,y,sp");
    for (std::size_t k = 0; k < recording.size(); ++k) {
      std::printf("%.17g,%.17g,%.17g,%.17g\n", recording.t[k], recording.u[k],
                  recording.y[k], recording.sp[k]);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "score_hidden: %s\n", error.what());
    return 1;
  }
  return 0;
}

int print_list() {
  std::vector<hidden::CaseKey> keys = hidden::one_effect({1, 1});
  for (hidden::CaseKey& key : hidden::two_effects({1, 1})) keys.push_back(std::move(key));
  std::string last;
  for (const hidden::CaseKey& key : keys) {
    std::string codes;
    for (const hidden::Effect effect : key.effects) {
      codes += (codes.empty() ? "" : "+") + std::string(code_of(effect));
    }
    if (codes != last) std::puts(codes.c_str());
    last = std::move(codes);
  }
  return 0;
}

int print_explain_times(std::size_t samples, std::uint64_t seed) {
  if (samples < workbench::Blocks::kFewestSamples) return usage();
  double longest = 0;
  for (hidden::CaseKey key : hidden::two_effects({seed, 1})) {
    if (key.signal_to_noise != 10) continue;
    key.samples = samples;
    try {
      const workbench::Recording recording = hidden::make_case(key).recording;
      const auto model = workbench::start_model(recording, workbench::Column::y).model;
      const std::clock_t start = std::clock();
      (void)workbench::explain(recording, model);
      const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      longest = std::max(longest, seconds);
      std::printf("%6.2f s  %s\n", seconds, describe(key).c_str());
    } catch (const std::exception& error) {
      std::printf("     –    %s: %s\n", describe(key).c_str(), error.what());
    }
  }
  std::printf("%6.2f s at most\n", longest);
  return 0;
}

/// Drops what --only does not ask for and what no loop can show.
std::vector<hidden::Outcome> run(const char* title, std::vector<hidden::CaseKey> keys,
                                 const Options& options, std::size_t& errors) {
  std::erase_if(keys, [&](const hidden::CaseKey& key) {
    return hidden::describe(key).find(options.only) == std::string::npos;
  });
  std::size_t done = 0;
  double seconds = 0;
  double longest = 0;
  auto outcomes = hidden::run_cases(keys, [&](const hidden::Outcome& outcome) {
    ++done;
    seconds += outcome.seconds;
    longest = std::max(longest, outcome.seconds);
    errors += outcome.named.error.empty() ? 0 : 1;
    if (options.details || !outcome.possible || !outcome.named.error.empty()) {
      std::fprintf(stderr, "%s\n", describe(outcome).c_str());
    } else if (done % 50 == 0) {
      std::fprintf(stderr, "%s: %zu of %zu\n", title, done, keys.size());
    }
  });
  std::erase_if(outcomes, [](const hidden::Outcome& o) { return !o.possible; });
  if (!outcomes.empty()) {
    std::fprintf(stderr, "%s: %zu ladders, %.2f s each, longest %.2f s\n", title,
                 outcomes.size(), seconds / static_cast<double>(outcomes.size()),
                 longest);
  }
  return outcomes;
}

}  // namespace

int main(int argc, char** argv) {
  if ((argc == 6 || argc == 7) && std::strcmp(argv[1], "--csv") == 0) {
    auto key = hidden::parse_key(argv[2], argv[3], argv[4], argv[5]);
    if (key && argc == 7) key->samples = std::strtoull(argv[6], nullptr, 10);
    return key && key->samples > 0 ? print_csv(*key) : usage();
  }
  if (argc == 2 && std::strcmp(argv[1], "--list") == 0) return print_list();
  if (argc == 4 && std::strcmp(argv[1], "--explain-time") == 0) {
    return print_explain_times(std::strtoull(argv[2], nullptr, 10),
                               std::strtoull(argv[3], nullptr, 10));
  }
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool more = i + 1 < argc;
    if (word == "--quick") {
      options.seeds.count = 1;
      options.clean = 30;
    } else if (word == "--details") {
      options.details = true;
    } else if (word == "--seeds" && more) {
      options.seeds.count = std::atoi(argv[++i]);
    } else if (word == "--first-seed" && more) {
      options.seeds.first = std::strtoull(argv[++i], nullptr, 10);
    } else if (word == "--clean" && more) {
      options.clean = std::atoi(argv[++i]);
    } else if (word == "--part" && more) {
      options.part = argv[++i];
    } else if (word == "--only" && more) {
      options.only = argv[++i];
    } else {
      return usage();
    }
  }
  if (options.seeds.count < 1) {
    return usage();
  }
  const int clean = options.clean < 0 ? 100 * options.seeds.count : options.clean;
  std::size_t errors = 0;
  const auto ask = [&](const char* part, const char* title,
                       std::vector<hidden::CaseKey> keys) {
    if (!options.part.empty() && options.part != part) keys.clear();
    return run(title, std::move(keys), options, errors);
  };
  const hidden::Results results{
      ask("one", "one effect", hidden::one_effect(options.seeds)),
      ask("two", "two effects", hidden::two_effects(options.seeds)),
      ask("clean", "clean", hidden::clean(options.seeds, clean)),
      ask("unexcited", "not excited", hidden::not_excited(options.seeds))};
  std::fputs(hidden::tables_of(results).c_str(), stdout);
  if (errors > 0) {
    std::fprintf(stderr, "score_hidden: the engine failed on %zu recordings\n", errors);
  }
  return errors > 0 ? 1 : 0;
}
