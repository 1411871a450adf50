#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <sstream>

#include "wire/text.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/output_file.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/simulate/candump.hpp"
#include "workbench/simulate/plant.hpp"
#include "workbench/simulate/recording_csv.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench::cli {
namespace {

struct Options {
  std::string scenario;
  std::string seed;
  std::string csv;
  std::string truth;
  std::string candump;
  std::string dbc;
  bool list = false;
  bool without_position = false;
  PlantOptions plant;
  bool files = false;
};

constexpr std::string_view kPlant = "plant";

constexpr const char* kFooter = R"(
Examples:
  stickband simulate --list
  stickband simulate stiction --seed 7 -o loop.csv --truth loop.json
  stickband simulate paper-example-1 --seed 1 -o loop.csv --candump loop.log
  stickband identify loop.log --dbc loop.dbc --u LoopOP.OP --y LoopPV.PV
  stickband simulate plant --loops 40 --seed 1 -o plant/

The same scenario and seed make the same recording. The CSV file has the columns t, u,
y, sp and x, the true valve position. With --candump the DBC file that explains the log
is written too: to --dbc-out, or beside the log with the ending .dbc. `plant` writes a
folder: a wide export for each area of 20 loops, or with --files one for each loop, and
truth.json; in each area one valve sticks and shakes five neighbours, or in the first N
with --sticking N.)";

std::string replace_ending(const std::string& path, const char* ending) {
  const std::size_t name = path.find_last_of('/') + 1;
  const std::size_t dot = path.find_last_of('.');
  const bool has_ending = dot != std::string::npos && dot > name;
  return (has_ending ? path.substr(0, dot) : path) + ending;
}

// The parser's own numbers wrap around: -1 would be a seed.
std::uint64_t seed_of(const std::string& text) {
  const auto seed = wire::number_of<std::uint64_t>(text);
  if (!seed) {
    throw UsageError("--seed: expected a whole number from 0 to 2^64 - 1, found '" +
                     text + "'");
  }
  return *seed;
}

int list() {
  std::size_t widest = 0;
  for (const ScenarioInfo& s : scenarios()) widest = std::max(widest, s.name.size());
  std::string text;
  for (const ScenarioInfo& s : scenarios()) {
    text += std::string(s.name) + std::string(widest + 2 - s.name.size(), ' ') +
            wrapped(s.description, widest + 2) + '\n';
  }
  text += std::string(kPlant) + std::string(widest + 2 - kPlant.size(), ' ') +
          wrapped(
              "loops that share headers and heat, some of whose valves stick and shake "
              "their neighbours: --loops N, -o FOLDER",
              widest + 2) +
          '\n';
  print(text);
  return kDone;
}

int simulate_plant(const Options& options) {
  if (!options.candump.empty()) throw UsageError("a plant is written as CSV alone");
  PlantOptions plant = options.plant;
  plant.seed = seed_of(options.seed);
  if (plant.sticking > areas_of(plant)) {
    throw UsageError("--sticking: at most one valve in each area of " +
                     std::to_string(kLoopsPerArea) + " loops");
  }
  const std::filesystem::path folder = options.csv;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw OutputError("cannot make " + options.csv + ": " + error.message());
  nlohmann::ordered_json truth{{"schema", 1},
                               {"scenario", kPlant},
                               {"seed", plant.seed},
                               {"loops", nlohmann::ordered_json::array()}};
  for (int number = 1; number <= areas_of(plant); ++number) {
    const PlantArea area = simulate_area(plant, number);
    for (auto& loop : truth_json(area)) truth["loops"].push_back(std::move(loop));
    if (options.files) {
      for (const PlantLoop& loop : area.loops) {
        write_file(folder / (loop.tag + ".csv"), loop_csv(area, loop));
      }
    } else {
      std::string name = std::to_string(number);
      name.insert(0, 3 - std::min<std::size_t>(name.size(), 3), '0');
      write_file(folder / ("area-" + name + ".csv"), area_csv(area));
    }
  }
  write_file(options.truth.empty() ? (folder / "truth.json").string() : options.truth,
             truth.dump(1) + '\n');
  print("plant, seed " + options.seed + ": " + std::to_string(plant.loops) +
        " loops in " + options.csv + "; what is true is in truth.json\n");
  return kDone;
}

std::string summary(const SimulatedLoop& loop, const Options& options) {
  const LoopTruth& truth = loop.truth;
  std::string text = options.scenario + ", seed " + options.seed + ": " +
                     std::to_string(loop.t.size()) + " samples, one every " +
                     number(loop.period_s) + " s\ntruth: " + truth.kind +
                     (truth.cause == truth.kind ? "" : ", moved by " + truth.cause);
  if (truth.stick_band_ascending > 0 || truth.stick_band_descending > 0) {
    text += "; stick band " + number(truth.stick_band_ascending) + " ascending, " +
            number(truth.stick_band_descending) + " descending (units of u)";
  }
  return text + '\n';
}

int simulate_to_files(const Options& options) {
  if (options.list) return list();
  if (options.scenario.empty()) {
    throw UsageError("SCENARIO is required; stickband simulate --list names them");
  }
  const bool known = options.scenario == kPlant ||
                     std::ranges::any_of(scenarios(), [&options](const auto& scenario) {
                       return scenario.name == options.scenario;
                     });
  if (!known) {
    throw UsageError("no scenario is named '" + options.scenario +
                     "'; stickband simulate --list names them");
  }
  if (options.seed.empty() || options.csv.empty()) {
    throw UsageError("--seed and -o are required: stickband simulate " +
                     options.scenario + " --seed 1 -o loop.csv");
  }
  if (options.scenario == kPlant) return simulate_plant(options);
  if (options.candump.empty() && !options.dbc.empty()) {
    throw UsageError("--dbc-out goes with --candump");
  }
  const std::string dbc = !options.dbc.empty() ? options.dbc
                          : !options.candump.empty()
                              ? replace_ending(options.candump, ".dbc")
                              : "";
  std::set<std::string> outputs;
  for (const std::string& path : {options.csv, options.truth, options.candump, dbc}) {
    if (path.empty()) continue;
    std::error_code ignored;
    const std::string place =
        std::filesystem::weakly_canonical(std::filesystem::absolute(path), ignored)
            .string();
    if (!outputs.insert(place).second) {
      throw UsageError("two outputs would go to " + path);
    }
  }
  const SimulatedLoop loop = simulate(options.scenario, seed_of(options.seed)).value();
  std::ostringstream csv;
  write_csv(loop, csv, !options.without_position);
  write_file(options.csv, csv.str());
  if (!options.truth.empty()) {
    write_file(options.truth, truth_json(loop.truth).dump(2) + '\n');
  }
  if (!options.candump.empty()) {
    std::ostringstream log;
    write_candump(loop, log);
    write_file(options.candump, log.str());
    write_file(dbc, dbc_text());
  }
  print(summary(loop, options));
  return kDone;
}

}  // namespace

void add_simulate(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "simulate",
      "Simulate a control loop with a known valve, from a scenario and a seed");
  command->add_option("SCENARIO", options->scenario, "one of those that --list names");
  command->add_option("--seed", options->seed, "any number from 0 on")->type_name("N");
  command->add_option("-o,--output", options->csv, "the recording, CSV")
      ->type_name("REC.csv");
  command->add_option("--truth", options->truth, "what is true about it, JSON")
      ->type_name("TRUTH.json");
  command->add_option("--candump", options->candump, "the recording as a CAN log")
      ->type_name("REC.log");
  command
      ->add_option("--dbc-out", options->dbc,
                   "where the DBC file goes; beside the log by default")
      ->type_name("REC.dbc");
  command->add_flag("--without-position", options->without_position,
                    "leave column x out of the CSV file");
  command->add_flag("--list", options->list, "name the scenarios and stop");
  command->add_option("--loops", options->plant.loops, "how many")
      ->type_name("N")
      ->check(CLI::Range(1, 20'000))
      ->group("Plant");
  command
      ->add_option("--sticking", options->plant.sticking,
                   "valves that stick; one in each area by default")
      ->type_name("N")
      ->check(CLI::Range(0, 1000))
      ->group("Plant");
  command->add_option("--samples", options->plant.samples, "of each loop")
      ->type_name("N")
      ->check(CLI::Range(500, 1'000'000))
      ->group("Plant");
  command->add_flag("--files", options->files, "a file for each loop")->group("Plant");
  runs(*command, action, options, simulate_to_files, kFooter);
}

}  // namespace workbench::cli
