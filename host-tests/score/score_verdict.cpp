// Scores the identifier on simulated loops and on the external recordings: how often it
// is right, how far its stick bands are off, whether its intervals hold. Prints Markdown
// tables.
//
//   score_verdict [LOOPS] [--first-seed N]
//
// LOOPS simulated sticking loops, default 500, and twice as many without stiction; their
// scenarios take turns, so a few hundred seeds are used. They begin at N, default 1:
// these are for reporting. Thresholds of judge.cpp and oscillation_cause.cpp are chosen
// on seeds from 1000 on.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"
#include "support/workbench/detectable_tally.hpp"
#include "workbench/analysis/analysis.hpp"
#include "workbench/recording/csv.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace {

using Identifier = ident::Identifier<double, ident::kLargeWindow>;
using ident::Verdict;

/// What came out for one simulated loop.
struct Outcome {
  std::string scenario;
  workbench::LoopTruth truth;
  ident::Identification<double> found;
};

double quantile(std::vector<double> values, double share) {
  if (values.empty()) {
    return std::nan("");
  }
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(std::lround(place))];
}

/// Error of the stick bands, worse stroke, in percent of the larger true band.
double band_error_percent(const Outcome& outcome) {
  const double ascending = outcome.truth.stick_band_ascending;
  const double descending = outcome.truth.stick_band_descending;
  const auto& band = outcome.found.stick_band;
  const double worse = std::max(std::abs(band.ascending.value - ascending),
                                std::abs(band.descending.value - descending));
  return 100 * worse / std::max(ascending, descending);
}

/// Identifies `count` loops, scenarios in turn, on all cores.
std::vector<Outcome> simulate_and_identify(const std::vector<std::string>& scenarios,
                                           int count, std::uint64_t first_seed) {
  std::vector<Outcome> outcomes(static_cast<std::size_t>(count));
  const unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::thread> workers;
  for (unsigned worker = 0; worker < threads; ++worker) {
    workers.emplace_back([&, worker] {
      const auto identifier = std::make_unique<Identifier>();
      for (std::size_t i = worker; i < outcomes.size(); i += threads) {
        Outcome& outcome = outcomes[i];
        outcome.scenario = scenarios[i % scenarios.size()];
        const auto loop =
            workbench::simulate(outcome.scenario, first_seed + i / scenarios.size());
        outcome.truth = loop->truth;
        outcome.found = identifier->run(loop->u, loop->y, loop->sp);
      }
    });
  }
  for (std::thread& worker : workers) {
    worker.join();
  }
  return outcomes;
}

void print_band_row(const std::string& name, const std::vector<Outcome>& outcomes) {
  std::vector<double> errors;
  std::vector<double> gaps;
  std::vector<double> valve_gaps;
  int found = 0;
  int inside = 0;
  for (const Outcome& outcome : outcomes) {
    gaps.push_back(outcome.truth.noise_ceiling_percent - outcome.found.fit_percent);
    valve_gaps.push_back(outcome.truth.noise_ceiling_percent -
                         outcome.found.fit_valve_percent);
    if (outcome.found.verdict != Verdict::kStiction) {
      continue;
    }
    ++found;
    errors.push_back(band_error_percent(outcome));
    const auto covers = [](const ident::Estimate<double>& e, double truth) {
      return e.low <= truth * (1 + 1e-9) && truth <= e.high * (1 + 1e-9) ? 1 : 0;
    };
    inside +=
        covers(outcome.found.stick_band.ascending, outcome.truth.stick_band_ascending);
    inside +=
        covers(outcome.found.stick_band.descending, outcome.truth.stick_band_descending);
  }
  std::printf("| %s | %zu | %.1f | %.2f | %.2f | %.1f | %.1f | %.0f |\n", name.c_str(),
              outcomes.size(), 100.0 * found / static_cast<double>(outcomes.size()),
              quantile(gaps, 0.5), quantile(valve_gaps, 0.5), quantile(errors, 0.5),
              quantile(errors, 0.9), found > 0 ? 50.0 * inside / found : 0.0);
}

void print_band_header(const char* title) {
  std::printf(
      "\n%s\n\n| loops | n | found %% | gap two-path | gap valve | S error median %% | "
      "90th %% | intervals that hold %% |\n|---|---|---|---|---|---|---|---|\n",
      title);
}

std::vector<Outcome> of_scenario(const std::vector<Outcome>& all,
                                 const std::string& name) {
  std::vector<Outcome> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some),
               [&](const Outcome& outcome) { return outcome.scenario == name; });
  return some;
}

void score_example(std::uint64_t first_seed) {
  print_band_header(
      "Example 5.1, 20 seeds each; gaps to the noise ceiling are medians, points");
  std::vector<Outcome> all;
  const std::vector<std::string> names{
      "paper-example-1", "paper-example-1-midway", "paper-example-1-ascending",
      "paper-example-1-descending", "paper-example-1-mixed"};
  const auto outcomes =
      simulate_and_identify(names, 20 * static_cast<int>(names.size()), first_seed);
  for (const std::string& name : names) {
    print_band_row(name, of_scenario(outcomes, name));
  }
}

std::vector<Outcome> score_sticking(int loops, std::uint64_t first_seed) {
  print_band_header("Simulated sticking loops");
  const std::vector<std::string> names{"stiction", "stiction-one-sided", "stiction-mixed",
                                       "stiction-integrating", "stiction-setpoint"};
  auto outcomes = simulate_and_identify(names, loops, first_seed);
  for (const std::string& name : names) {
    print_band_row(name, of_scenario(outcomes, name));
  }
  print_band_row("all", outcomes);
  // Not counted above: nothing promises that so little can tell.
  print_band_row("(few setpoint steps)",
                 simulate_and_identify({"stiction-few-steps"}, loops / 5, first_seed));
  return outcomes;
}

std::vector<Outcome> score_others(int loops, std::uint64_t first_seed) {
  std::printf(
      "\nSimulated loops without stiction\n\n| loops | n | stiction | backlash | "
      "no stiction | undecided |\n|---|---|---|---|---|---|\n");
  const std::vector<std::string> names{
      "external-sinusoid", "tight-tuning", "random-load",        "setpoint",
      "healthy",           "quantised",    "healthy-positioner", "load-and-noise"};
  auto outcomes = simulate_and_identify(names, loops, first_seed);
  const auto row = [](const std::string& name, const std::vector<Outcome>& some) {
    std::map<Verdict, int> count;
    for (const Outcome& outcome : some) {
      ++count[outcome.found.verdict];
    }
    std::printf("| %s | %zu | %d | %d | %d | %d |\n", name.c_str(), some.size(),
                count[Verdict::kStiction], count[Verdict::kBacklash],
                count[Verdict::kNoStiction], count[Verdict::kUndecided]);
  };
  for (const std::string& name : names) {
    row(name, of_scenario(outcomes, name));
  }
  row("all", outcomes);
  const auto playing = simulate_and_identify({"backlash"}, loops / 20, first_seed);
  row("(backlash)", playing);
  row("(few setpoint steps)",
      simulate_and_identify({"few-steps"}, loops / 5, first_seed));
  outcomes.insert(outcomes.end(), playing.begin(), playing.end());
  return outcomes;
}

void score_causes(const std::vector<Outcome>& outcomes) {
  using ident::Cause;
  std::printf(
      "\nCauses named, by what moves the simulated loop\n\n| truly | n | valve | "
      "external "
      "periodic | tight tuning | setpoint | left open "
      "|\n|---|---|---|---|---|---|---|\n");
  std::map<std::string, std::map<Cause, int>> count;
  for (const Outcome& outcome : outcomes) {
    ++count[outcome.truth.cause][outcome.found.cause];
  }
  for (auto& [truth, named] : count) {
    int all = 0;
    for (const auto& [cause, number] : named) {
      all += number;
    }
    std::printf("| %s | %d | %d | %d | %d | %d | %d |\n", truth.c_str(), all,
                named[Cause::kValve], named[Cause::kExternalPeriodic],
                named[Cause::kTightTuning], named[Cause::kSetpoint],
                named[Cause::kUnknown]);
  }
}

nlohmann::json read_labels(const std::filesystem::path& folder) {
  std::ifstream file(folder / "labels.json");
  return nlohmann::json::parse(file);
}

/// Windows of real loops that oscillate, and those of them that were left undecided.
struct Deciding {
  int oscillating = 0;
  int undecided = 0;

  void take(const ident::Identification<double>& found) {
    if (!found.oscillation.detected) return;
    ++oscillating;
    undecided += found.verdict == Verdict::kUndecided ? 1 : 0;
  }
};
Deciding deciding;

/// The verdict of `stickband identify` on the recordings of one loop; nothing, and why,
/// where one can't be read.
std::optional<ident::Identification<double>> identify_recordings(
    const std::string& name, const std::vector<std::filesystem::path>& paths) {
  try {
    std::vector<workbench::Recording> recordings;
    for (const std::filesystem::path& path : paths) {
      recordings.push_back(workbench::read_csv(path.string(), {}));
    }
    return workbench::Analysis(std::move(recordings)).result();
  } catch (const workbench::InputError&) {
    std::printf("| %s | | NOT READ | not scored | | |\n", name.c_str());
    return std::nullopt;
  }
}

std::optional<ident::Identification<double>> identify_recording(
    const std::filesystem::path& path) {
  auto found = identify_recordings(path.stem().string(), {path});
  if (found) deciding.take(*found);
  return found;
}

std::string detectable(const ident::Identification<double>& found) {
  const double share = found.evidence.ladder.detectable_band;
  if (!(share > 0)) return "–";
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.0f", 100 * share);
  return text.data();
}

void print_recording(const std::string& name, bool label,
                     const ident::Identification<double>& found) {
  const bool said = found.verdict == Verdict::kStiction;
  std::printf("| %s | %s | %s | %s | %.1f | %.1f | %.0f | %s |\n", name.c_str(),
              label ? "stiction" : "other",
              std::string(ident::name(found.verdict)).c_str(),
              said == label ? "right" : "wrong", found.evidence.fit_percent,
              found.evidence.fit_linear_percent,
              found.evidence.stem_weighed
                  ? std::max(found.evidence.stem_nats, found.evidence.ladder.nats)
                  : found.evidence.ladder.nats,
              detectable(found).c_str());
}

constexpr const char* kRecordingHeader =
    "| recording | label | verdict | | valve fit % | linear fit % | evidence, nats | "
    "detectable band, % of swing |\n|---|---|---|---|---|---|---|---|\n";

void score_isdb(const std::filesystem::path& folder) {
  std::printf("\nInternational Stiction Data Base, recordings of the 26-loop set\n\n%s",
              kRecordingHeader);
  int right = 0;
  int count = 0;
  const nlohmann::json labels = read_labels(folder);
  for (const auto& [name, label] : labels.items()) {
    if (!label.contains("stiction") || !label["stiction"].is_boolean()) {
      continue;
    }
    const auto found = identify_recording(folder / (name + ".csv"));
    if (!found) {
      continue;
    }
    const bool stiction = label["stiction"].get<bool>();
    right += (found->verdict == Verdict::kStiction) == stiction ? 1 : 0;
    ++count;
    print_recording(name, stiction, *found);
  }
  std::printf("\n%d of %d right\n", right, count);
}

void score_plant(const std::filesystem::path& folder) {
  std::printf(
      "\nPlant recordings, the windows of each loop judged together\n\n"
      "| loop | label | windows alone: sticks, does not, undecided | together | "
      "|\n|---|---|---|---|---|\n");
  struct Loop {
    bool stiction = false;
    std::vector<std::filesystem::path> paths;
    std::map<Verdict, int> alone;
  };
  std::map<std::string, Loop> loops;
  const nlohmann::json labels = read_labels(folder);
  for (const auto& [name, label] : labels.items()) {
    const std::filesystem::path path = folder / (name + ".csv");
    const auto found = identify_recording(path);
    if (!found) {
      continue;
    }
    Loop& loop = loops[label["loop"].get<std::string>()];
    loop.stiction = label["stiction"].get<bool>();
    loop.paths.push_back(path);
    ++loop.alone[found->verdict];
  }
  int right = 0;
  for (auto& [name, loop] : loops) {
    const auto found = identify_recordings(name, loop.paths);
    const bool said = found->verdict == Verdict::kStiction;
    right += said == loop.stiction ? 1 : 0;
    std::printf("| %s | %s | %d, %d, %d | %s | %s |\n", name.c_str(),
                loop.stiction ? "stiction" : "other", loop.alone[Verdict::kStiction],
                loop.alone[Verdict::kNoStiction] + loop.alone[Verdict::kBacklash],
                loop.alone[Verdict::kUndecided],
                std::string(ident::name(found->verdict)).c_str(),
                said == loop.stiction ? "right" : "wrong");
  }
  std::printf("\n%d of %zu loops right\n", right, loops.size());
}

void score_detectable(const std::vector<Outcome>& outcomes) {
  workbench::test::DetectableTally tally;
  for (const Outcome& outcome : outcomes) {
    const double band =
        std::max(outcome.truth.stick_band_ascending, outcome.truth.stick_band_descending);
    if (band > 0 && outcome.truth.cause != "stiction") continue;
    tally.add(outcome.found, band);
  }
  tally.print();
}

void score_sacac(const std::filesystem::path& folder) {
  std::printf("\nSACAC recordings\n\n%s", kRecordingHeader);
  const nlohmann::json labels = read_labels(folder);
  for (const auto& [name, label] : labels.items()) {
    const bool stiction = label["cause"].get<std::string>() == "stiction";
    if (const auto found = identify_recording(folder / (name + ".csv"))) {
      print_recording(name, stiction, *found);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  int loops = 500;
  std::uint64_t first_seed = 1;
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "--first-seed" && i + 1 < argc) {
      first_seed = std::strtoull(argv[++i], nullptr, 10);
    } else {
      loops = std::max(10, std::atoi(argv[i]));
    }
  }
  score_example(first_seed);
  std::vector<Outcome> outcomes = score_sticking(loops, first_seed);
  const std::vector<Outcome> others = score_others(2 * loops, first_seed);
  outcomes.insert(outcomes.end(), others.begin(), others.end());
  score_causes(outcomes);
  score_detectable(outcomes);
  const std::filesystem::path recordings(STICKBAND_RECORDINGS);
  const auto with = [&](const char* folder, auto&& score) {
    if (std::filesystem::exists(recordings / folder / "labels.json")) {
      score(recordings / folder);
    } else {
      std::printf("\n%s: SKIPPED, the recordings are not on this machine\n", folder);
    }
  };
  with("isdb", score_isdb);
  with("plant", score_plant);
  with("sacac", score_sacac);
  std::printf(
      "\nWindows of these recordings in which u oscillates: %d, left undecided %d\n",
      deciding.oscillating, deciding.undecided);
  return 0;
}
