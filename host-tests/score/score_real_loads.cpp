// Scores the identifier on closed loops under loads cut from real recordings and seen
// through historians: how many of the sticking it finds, of the healthy it blames. Prints
// Markdown tables.
//
//   score_real_loads [STICKING=200] [HEALTHY=300] [--first-seed N] [--list] [--export
//   DIR]
//
// --list prints one line a loop as well; --export writes each recording as CSV (t, u, y,
// sp and the true stem x) and all truths as truth.json. Seeds begin at N, default 1:
// these are for reporting. Whatever is chosen or tuned looks at seeds from 1001 on. The
// loops need the external recordings; without them it says so and prints nothing else.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"
#include "support/real_loads/loop.hpp"
#include "support/workbench/detectable_tally.hpp"

namespace {

using Identifier = ident::Identifier<double, ident::kLargeWindow>;
using ident::Verdict;
using workbench::test::LoopKind;
using workbench::test::RealLoad;
using workbench::test::RealLoadLoop;

struct Options {
  int sticking = 200;
  int healthy = 300;
  std::uint64_t first_seed = 1;
  bool list = false;
  std::string folder;  // of --export; empty: none
};

struct Outcome {
  std::uint64_t seed = 0;
  RealLoadLoop loop;
  ident::Identification<double> found;

  [[nodiscard]] bool blamed() const {
    return found.verdict == Verdict::kStiction || found.verdict == Verdict::kBacklash;
  }
};

void write_csv(const std::filesystem::path& path,
               const workbench::SimulatedLoop& recorded) {
  std::FILE* file = std::fopen(path.string().c_str(), "w");
  if (file == nullptr) {
    std::fprintf(stderr, "%s: cannot be written; name a folder that can\n",
                 path.string().c_str());
    std::exit(3);
  }
  std::fputs("t,u,y,sp,x\n", file);
  for (std::size_t t = 0; t < recorded.t.size(); ++t) {
    std::fprintf(file, "%.12g,%.12g,%.12g,%.12g,%.12g\n", recorded.t[t], recorded.u[t],
                 recorded.y[t], recorded.sp[t], recorded.x[t]);
  }
  std::fclose(file);
}

std::string file_name(LoopKind kind, std::size_t index) {
  char text[32];
  std::snprintf(text, sizeof text, "%s-%04zu",
                kind == LoopKind::kSticking ? "sticking" : "healthy", index + 1);
  return text;
}

/// Draws and identifies `count` loops on all cores.
std::vector<Outcome> draw_and_identify(LoopKind kind, int count, const Options& options,
                                       const std::vector<RealLoad>& loads) {
  std::vector<Outcome> outcomes(static_cast<std::size_t>(count));
  const unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::thread> workers;
  for (unsigned worker = 0; worker < threads; ++worker) {
    workers.emplace_back([&, worker] {
      const auto identifier = std::make_unique<Identifier>();
      for (std::size_t i = worker; i < outcomes.size(); i += threads) {
        Outcome& outcome = outcomes[i];
        outcome.seed = options.first_seed + i;
        outcome.loop = real_load_loop(kind, outcome.seed, loads);
        const workbench::SimulatedLoop& recorded = outcome.loop.recorded;
        if (!options.folder.empty()) {
          write_csv(std::filesystem::path(options.folder) / (file_name(kind, i) + ".csv"),
                    recorded);
        }
        outcome.found = identifier->run(recorded.u, recorded.y, recorded.sp);
      }
    });
  }
  for (std::thread& worker : workers) {
    worker.join();
  }
  return outcomes;
}

void print_list(const std::vector<Outcome>& outcomes) {
  std::printf(
      "\n| seed | kind | cause or motion | strokes | historian | load | at | samples | "
      "cycles | oracle nats | verdict | error ratio | score | band/swing true | found "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Outcome& outcome : outcomes) {
    const auto& truth = outcome.loop.truth;
    const bool sticks = truth.motion != "none";
    const auto& found = outcome.found;
    std::printf(
        "| %llu | %s | %s | %s | %s | %s | %s | %zu | %.0f | %.0f | %s | %.2f | %.1f | "
        "%.2f | %.2f |\n",
        static_cast<unsigned long long>(outcome.seed), sticks ? "sticking" : "healthy",
        sticks ? truth.motion.c_str() : outcome.loop.recorded.truth.cause.c_str(),
        truth.strokes.c_str(), std::string(name(truth.historian)).c_str(),
        truth.load.c_str(), truth.load_at.c_str(), outcome.loop.recorded.u.size(),
        truth.cycles, truth.oracle_nats, std::string(ident::name(found.verdict)).c_str(),
        found.evidence.error_ratio, found.evidence.score, truth.band_over_swing,
        found.evidence.band_over_swing);
  }
}

using GroupOf = std::function<std::string(const Outcome&)>;

void print_groups(const char* title, const std::vector<Outcome>& outcomes,
                  const GroupOf& group_of) {
  struct Count {
    int all = 0, blamed = 0, none = 0, undecided = 0;
  };
  std::map<std::string, Count> groups;
  const auto add = [](Count& count, const Outcome& outcome) {
    ++count.all;
    count.blamed += outcome.blamed() ? 1 : 0;
    count.none += outcome.found.verdict == Verdict::kNoStiction ? 1 : 0;
    count.undecided += outcome.found.verdict == Verdict::kUndecided ? 1 : 0;
  };
  Count all;
  for (const Outcome& outcome : outcomes) {
    add(groups[group_of(outcome)], outcome);
    add(all, outcome);
  }
  std::printf(
      "\n%s\n\n| loops | n | stiction or backlash | %% | no stiction | undecided "
      "|\n|---|---|---|---|---|---|\n",
      title);
  const auto row = [](const std::string& name, const Count& count) {
    std::printf("| %s | %d | %d | %.1f | %d | %d |\n", name.c_str(), count.all,
                count.blamed, 100.0 * count.blamed / std::max(1, count.all), count.none,
                count.undecided);
  };
  for (const auto& [name, count] : groups) {
    row(name, count);
  }
  row("all", all);
}

// A band that sticks unseen must not be wider than the one that would have shown.
void print_detectable(const std::vector<Outcome>& sticking,
                      const std::vector<Outcome>& healthy) {
  workbench::test::DetectableTally tally;
  for (const std::vector<Outcome>* outcomes : {&sticking, &healthy}) {
    for (const Outcome& outcome : *outcomes) {
      const auto& truth = outcome.loop.recorded.truth;
      tally.add(outcome.found,
                std::max(truth.stick_band_ascending, truth.stick_band_descending));
    }
  }
  tally.print();
}

// Both strokes of each loop: how far the told band is off, and whether its interval
// holds.
void print_bands(const std::vector<Outcome>& sticking) {
  struct Bands {
    std::vector<double> errors;
    int held = 0;
  };
  std::map<std::string, Bands> groups;
  for (const Outcome& outcome : sticking) {
    if (!outcome.blamed()) continue;
    const auto& truth = outcome.loop.recorded.truth;
    const auto& told = outcome.found.stick_band;
    const double wider =
        std::max(truth.stick_band_ascending, truth.stick_band_descending);
    for (const std::string& group : {outcome.loop.truth.motion, std::string("all")}) {
      const auto add = [&](const ident::Estimate<double>& band, double true_band) {
        groups[group].errors.push_back(100 * std::abs(band.value - true_band) / wider);
        groups[group].held += band.low <= true_band && true_band <= band.high ? 1 : 0;
      };
      add(told.ascending, truth.stick_band_ascending);
      add(told.descending, truth.stick_band_descending);
    }
  }
  std::printf(
      "\nStick bands of the found, %% of the wider\n\n| motion | bands | error median %% "
      "| 90th %% | intervals that hold %% |\n|---|---|---|---|---|\n");
  for (auto& [name, bands] : groups) {
    std::ranges::sort(bands.errors);
    const std::size_t count = bands.errors.size();
    std::printf("| %s | %zu | %.1f | %.1f | %.0f |\n", name.c_str(), count,
                bands.errors[count / 2], bands.errors[count * 9 / 10],
                100.0 * bands.held / static_cast<double>(count));
  }
}

std::string historian_of(const Outcome& outcome) {
  return std::string(name(outcome.loop.truth.historian));
}

void write_truths(const std::string& folder, const std::vector<Outcome>& sticking,
                  const std::vector<Outcome>& healthy) {
  nlohmann::json truths = nlohmann::json::object();
  for (std::size_t i = 0; i < sticking.size(); ++i) {
    truths[file_name(LoopKind::kSticking, i)] = truth_json(sticking[i].loop);
  }
  for (std::size_t i = 0; i < healthy.size(); ++i) {
    truths[file_name(LoopKind::kHealthy, i)] = truth_json(healthy[i].loop);
  }
  std::ofstream(std::filesystem::path(folder) / "truth.json") << truths.dump(1) << "\n";
}

Options read_options(int argc, char** argv) {
  Options options;
  int counts = 0;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool more = i + 1 < argc;
    if (word == "--first-seed" && more) {
      options.first_seed = std::strtoull(argv[++i], nullptr, 10);
    } else if (word == "--export" && more) {
      options.folder = argv[++i];
    } else if (word == "--list") {
      options.list = true;
    } else if (counts < 2 && word.find_first_not_of("0123456789") == std::string::npos) {
      (counts++ == 0 ? options.sticking : options.healthy) = std::atoi(word.c_str());
    } else {
      std::fprintf(stderr,
                   "score_real_loads: expected [STICKING] [HEALTHY] [--first-seed N] "
                   "[--list] [--export DIR], found %s\n",
                   word.c_str());
      std::exit(2);
    }
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  const auto loads = workbench::test::read_real_loads(STICKBAND_RECORDINGS);
  if (loads.empty()) {
    std::printf("SKIPPED: the recordings are not on this machine (%s)\n",
                STICKBAND_RECORDINGS);
    return 0;
  }
  if (!options.folder.empty()) std::filesystem::create_directories(options.folder);
  const auto sticking =
      draw_and_identify(LoopKind::kSticking, options.sticking, options, loads);
  const auto healthy =
      draw_and_identify(LoopKind::kHealthy, options.healthy, options, loads);
  if (!options.folder.empty()) write_truths(options.folder, sticking, healthy);

  std::printf("Loops under %zu real loads, seeds from %llu\n", loads.size(),
              static_cast<unsigned long long>(options.first_seed));
  print_groups("Sticking, by motion of the valve", sticking,
               [](const Outcome& outcome) { return outcome.loop.truth.motion; });
  print_groups("Sticking, by strokes", sticking,
               [](const Outcome& outcome) { return outcome.loop.truth.strokes; });
  print_groups("Sticking, by historian", sticking, historian_of);
  print_detectable(sticking, healthy);
  print_bands(sticking);
  print_groups("Healthy, by cause", healthy,
               [](const Outcome& outcome) { return outcome.loop.recorded.truth.cause; });
  // A neighbour's stiction is hard to tell from the loop's own; what is left without it.
  std::vector<Outcome> others;
  std::ranges::copy_if(healthy, std::back_inserter(others), [](const Outcome& outcome) {
    return outcome.loop.recorded.truth.cause != "neighbour";
  });
  print_groups("Healthy, without a neighbour that sticks", others, historian_of);
  print_groups("Healthy, by historian", healthy, historian_of);
  if (options.list) {
    print_list(sticking);
    print_list(healthy);
  }
  return 0;
}
