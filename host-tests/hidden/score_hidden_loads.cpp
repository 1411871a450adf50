// One hidden effect under a load cut from a real recording, with few moves: does the
// ladder name it, what does `identify` say, and are the p-values of `explain` uniform
// where nothing is hidden?
// Prints Markdown tables.
//
//   score_hidden_loads [--seeds N] [--first-seed S] [--clean N] [--details]
//   score_hidden_loads --csv SEED [EFFECT steps|closed]
//     one loop as CSV, its load beside it; without an effect in turns as a step test
//     (odd seeds) and in closed loop
//
// Each seed gives every effect once as a step test (u moved by hand four to eight times)
// and once in closed loop (four to eight setpoints). The load, 3 to 15 % of the standard
// deviation of y, is added at the output, and the controller sees it; the simulator's
// white noise is left out. A draw counts only if it would have shown: the textbook model,
// refitted without the load, must miss at least as much as the load moves. Seeds from 1
// on are for reporting; whatever is chosen looks at seeds from 1001 on. Needs the
// external recordings; without them it says so and prints nothing else.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "hidden/engine.hpp"
#include "support/hidden/case.hpp"
#include "support/hidden/textbook.hpp"
#include "support/real_loads/loads.hpp"
#include "workbench/model/base/work.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/identified.hpp"
#include "workbench/model/search/ladder.hpp"

namespace {

using hidden::CaseKey;
using hidden::LoopSetup;
using workbench::Recording;
using workbench::test::RealLoad;

struct Options {
  std::uint64_t first_seed = 1;
  int seeds = 5;
  int clean = 60;
  bool details = false;
  std::optional<std::uint64_t> csv;  // only print the loop of this seed
  std::string effect;                // with this in it, if not empty,
  bool open_loop = false;            // moved by hand
};

double standard_deviation(const std::vector<double>& values) {
  double mean = 0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  double squares = 0;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

// `moves` levels within ±size, held in turns that differ by a half either way.
std::vector<double> few_moves(workbench::Random& random, std::size_t samples, int moves,
                              double size) {
  std::vector<double> out;
  double level = 0;
  for (int i = 0; i <= moves; ++i) {
    const double hold = static_cast<double>(samples) / (moves + 1);
    const auto length = static_cast<std::size_t>(hold * random.uniform(0.5, 1.5));
    out.insert(out.end(), std::max<std::size_t>(length, 1), level);
    double next = level;
    while (std::abs(next - level) < 0.4 * size) next = size * random.uniform(-1, 1);
    level = next;
  }
  out.resize(samples, out.back());
  return out;
}

// The loop of a key with few moves and a real load; nothing where the effect is too small
// to show.
struct LoadedCase {
  Recording recording;
  std::vector<double> load;  // unit standard deviation
  bool shows = false;
};

LoadedCase loaded_case(const CaseKey& key, bool open_loop,
                       const std::vector<RealLoad>& loads) {
  const hidden::HiddenCase drawn = hidden::make_case(key);
  LoopSetup setup = drawn.truth.setup;
  workbench::Random random(open_loop ? "few moves by hand" : "few setpoints", key.seed);
  const std::size_t n = setup.warm_up + setup.samples;
  const int moves = random.integer(4, 8);
  const double swing = 10;
  std::vector<double> u(n, setup.rest_u);
  if (open_loop) {
    const std::vector<double> steps = few_moves(random, setup.samples, moves, swing);
    for (std::size_t k = 0; k < steps.size(); ++k) u[setup.warm_up + k] += steps[k];
  }
  setup.setpoint = few_moves(random, n, moves, swing * std::abs(setup.process.gain));
  const RealLoad& load = loads[static_cast<std::size_t>(
      random.integer(0, static_cast<int>(loads.size()) - 1))];
  const double stretch = random.log_uniform(0.5, 4);
  setup.noise = workbench::test::cut_load(random, load, n, stretch);
  if (setup.noise.size() != n) return {};
  // A load that was stretched runs straight between its samples; no sensor is that quiet.
  constexpr double kSensorNoise = 0.05;
  for (double& value : setup.noise) value += kSensorNoise * random.normal();
  setup.noise_std = 0;
  const std::vector<double>* imposed = open_loop ? &u : nullptr;
  const double size =
      standard_deviation(recorded(setup, run_loop(setup, imposed).sensed));
  setup.noise_std = size * random.log_uniform(0.03, 0.15);
  const hidden::Trace trace = run_loop(setup, imposed);
  if (trace.ran_dry) return {};
  LoadedCase out;
  out.recording = drawn.recording;
  out.load = recorded(setup, setup.noise);
  out.recording.u = recorded(setup, trace.u);
  out.recording.y = recorded(setup, trace.y);
  out.recording.sp = recorded(setup, trace.sp);
  const std::vector<double> sensed = recorded(setup, trace.sensed);
  out.shows = standard_deviation(out.recording.u) > 0 &&
              hidden::textbook_misfit(out.recording.u, sensed) >= setup.noise_std;
  return out;
}

struct Tally {
  int cases = 0;
  int right = 0;
  int silent = 0;
  int wrong = 0;
};

// What `identify` says of the same recordings.
struct Verdicts {
  int cases = 0;
  int faults = 0;
  int cleared = 0;
};

void count(ident::Verdict verdict, Verdicts& out) {
  ++out.cases;
  out.faults += ident::is_fault(verdict) ? 1 : 0;
  out.cleared += verdict == ident::Verdict::kNoStiction ? 1 : 0;
}

void print(const char* name, const Tally& t) {
  const double n = std::max(t.cases, 1);
  std::printf("| %s | %d | %.1f | %.1f | %.1f |\n", name, t.cases, 100 * t.right / n,
              100 * t.silent / n, 100 * t.wrong / n);
}

void score_hidden(const Options& options, const std::vector<RealLoad>& loads) {
  struct Job {
    hidden::Effect effect;
    bool open_loop;
    std::uint64_t seed;
  };
  std::vector<Job> jobs;
  for (int seed = 0; seed < options.seeds; ++seed) {
    for (const hidden::Effect effect : hidden::all_effects()) {
      for (const bool open_loop : {true, false}) {
        jobs.push_back({effect, open_loop, options.first_seed + seed});
      }
    }
  }
  std::mutex mutex;
  std::map<std::string, Tally> tallies;
  std::map<std::string, Verdicts> verdicts;
  const workbench::Work work({.threads = workbench::Work::cores()});
  work.for_each(jobs.size(), [&](std::size_t i) {
    const Job& job = jobs[i];
    const std::string code(code_of(job.effect));
    LoadedCase one;
    try {
      one =
          loaded_case({.effects = {job.effect}, .seed = job.seed}, job.open_loop, loads);
    } catch (const std::runtime_error&) {  // no draw of the key matters
    }
    if (!one.shows) return;
    const hidden::Named named = hidden::name_effects(one.recording);
    const bool right =
        std::any_of(named.first.begin(), named.first.end(),
                    [&](const hidden::AddedEffect& a) { return a.names(code); });
    const bool stem = job.effect == hidden::Effect::kStiction ||
                      job.effect == hidden::Effect::kBacklash;
    const ident::Verdict verdict =
        workbench::Identified({one.recording}).result({}).verdict;
    const std::lock_guard lock(mutex);
    count(verdict, verdicts[std::string(stem ? "stiction or play" : "another effect") +
                            (job.open_loop ? ", step tests" : ", closed loops")]);
    for (const std::string& row :
         {std::string("all"), std::string(job.open_loop ? "step tests" : "closed loops"),
          code}) {
      Tally& tally = tallies[row];
      ++tally.cases;
      ++(right ? tally.right : named.first.empty() ? tally.silent : tally.wrong);
    }
    if (options.details) {
      std::fprintf(stderr, "%s %s seed %d: %s%s\n", code.c_str(),
                   job.open_loop ? "steps" : "closed", static_cast<int>(job.seed),
                   named.first.empty() ? "nothing" : named.first[0].effect.c_str(),
                   right || named.first.empty() ? "" : ", wrong");
    }
  });
  std::printf(
      "\n### One hidden effect under a real load, %% of recordings\n\n"
      "| | recordings | right first | nothing named | wrong first |\n"
      "|---|---|---|---|---|\n");
  for (const auto& [name, tally] : tallies) print(name.c_str(), tally);
  std::printf(
      "\n### What `identify` says of them\n\n"
      "| | recordings | stiction or backlash | no stiction | undecided |\n"
      "|---|---|---|---|---|\n");
  for (const auto& [name, all] : verdicts) {
    std::printf("| %s | %d | %d | %d | %d |\n", name.c_str(), all.cases, all.faults,
                all.cleared, all.cases - all.faults - all.cleared);
  }
}

// The load swings so: of its own variance the line of the candidate has this much.
bool swings_as_named(const LoadedCase& one, const workbench::Candidate& candidate) {
  constexpr double kLine = 0.3;
  if (candidate.effect != "disturbance.sinusoid" || !candidate.with.empty()) return false;
  for (const workbench::Parameter& parameter : candidate.parameters) {
    if (parameter.name != "period") continue;
    return workbench::line_share(one.load, one.recording.period_s, parameter.value) >=
           kLine;
  }
  return false;
}

// Loops without an effect are step tests and closed loops in turns.
bool is_step_test(std::uint64_t seed) {
  return seed % 2 == 1;
}

LoadedCase clean_case(std::uint64_t seed, const std::vector<RealLoad>& loads) {
  return loaded_case({.effects = {}, .seed = seed}, is_step_test(seed), loads);
}

// False where no loop could be drawn.
bool print_csv(const Options& options, const std::vector<RealLoad>& loads) {
  LoadedCase one;
  if (options.effect.empty()) one = clean_case(*options.csv, loads);
  for (const hidden::Effect effect : hidden::all_effects()) {
    if (code_of(effect) != options.effect) continue;
    one = loaded_case({.effects = {effect}, .seed = *options.csv}, options.open_loop,
                      loads);
  }
  if (one.recording.u.empty()) return false;
  std::printf("t,sp,u,y,load\n");
  for (std::size_t k = 0; k < one.recording.u.size(); ++k) {
    std::printf("%.10g,%.10g,%.10g,%.10g,%.10g\n",
                static_cast<double>(k) * one.recording.period_s, one.recording.sp[k],
                one.recording.u[k], one.recording.y[k], one.load[k]);
  }
  return true;
}

void score_clean(const Options& options, const std::vector<RealLoad>& loads) {
  std::mutex mutex;
  int named = 0;
  int swinging = 0;
  int cases = 0;
  std::map<std::string, std::pair<int, int>> below;  // of all: p < 0.05, p values
  const workbench::Work work({.threads = workbench::Work::cores()});
  work.for_each(static_cast<std::size_t>(options.clean), [&](std::size_t i) {
    const std::uint64_t seed = options.first_seed + i;
    const LoadedCase one = clean_case(seed, loads);
    if (one.recording.u.empty()) return;
    const auto model = workbench::start_model(one.recording, workbench::Column::y).model;
    const workbench::ExplainResult result = workbench::explain(one.recording, model);
    const std::lock_guard lock(mutex);
    ++cases;
    named += result.best() != nullptr;
    const bool swings = result.best() != nullptr && swings_as_named(one, *result.best());
    swinging += swings;
    if (options.details && result.best() != nullptr) {
      const workbench::Candidate& best = *result.best();
      const std::string with = best.with.empty() ? "" : " with " + best.with[0];
      std::fprintf(stderr, "clean %d: %s%s, %.0f %% of the error, p %.1g%s\n",
                   static_cast<int>(seed), best.effect.c_str(), with.c_str(),
                   best.error_reduction_percent, best.p_value,
                   swings ? ", as the load does" : "");
    }
    for (const workbench::Candidate& c : result.candidates) {
      if (c.rmse_after == c.rmse_before) continue;  // nothing was fitted
      if (swings_as_named(one, c)) continue;        // it is there
      for (const std::string& row :
           {std::string("all"),
            std::string(is_step_test(seed) ? "step tests" : "closed loops"), c.effect}) {
        auto& [low, all] = below[row];
        low += c.p_value < 0.05;
        ++all;
      }
    }
  });
  std::printf(
      "\n### No hidden effect, real load: %d recordings, %d with a name, "
      "of these %d a sinusoid that is in the load\n\n"
      "| effect | p-values | below 0.05, %% |\n|---|---|---|\n",
      cases, named, swinging);
  for (const auto& [name, counts] : below) {
    std::printf("| %s | %d | %.1f |\n", name.c_str(), counts.second,
                100.0 * counts.first / std::max(counts.second, 1));
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--details") {
      options.details = true;
    } else if (i + 1 < argc && word == "--seeds") {
      options.seeds = std::atoi(argv[++i]);
    } else if (i + 1 < argc && word == "--first-seed") {
      options.first_seed = std::strtoull(argv[++i], nullptr, 10);
    } else if (i + 1 < argc && word == "--clean") {
      options.clean = std::atoi(argv[++i]);
    } else if (i + 1 < argc && word == "--csv") {
      options.csv = std::strtoull(argv[++i], nullptr, 10);
      if (i + 2 < argc) {
        options.effect = argv[++i];
        options.open_loop = argv[++i] == std::string("steps");
      }
    } else {
      std::fprintf(stderr,
                   "usage: score_hidden_loads [--seeds N] [--first-seed S] [--clean N] "
                   "[--details] | --csv SEED [EFFECT steps|closed]\n");
      return 2;
    }
  }
  const std::vector<RealLoad> loads =
      workbench::test::read_real_loads(STICKBAND_RECORDINGS);
  if (loads.empty()) {
    std::printf("No recordings in %s: nothing to cut loads from.\n",
                STICKBAND_RECORDINGS);
    return 0;
  }
  if (options.csv) {
    try {
      if (print_csv(options, loads)) return 0;
    } catch (const std::runtime_error&) {  // no draw of the key matters
    }
    std::fprintf(stderr,
                 "score_hidden_loads: no loop of seed %d: expected an effect of the "
                 "catalogue that this seed's loop can show, found \"%s\"\n",
                 static_cast<int>(*options.csv), options.effect.c_str());
    return 1;
  }
  if (options.seeds > 0) score_hidden(options, loads);
  if (options.clean > 0) score_clean(options, loads);
  return 0;
}
