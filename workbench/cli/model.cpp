#include <CLI/CLI.hpp>
#include <memory>

#include "workbench/analysis/identification_json.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/left_behind.hpp"
#include "workbench/cli/model_options.hpp"
#include "workbench/cli/parameter_table.hpp"
#include "workbench/cli/unused_columns.hpp"
#include "workbench/effects/catalogue.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/model/tell/cautions.hpp"
#include "workbench/model/tell/explanation_json.hpp"
#include "workbench/model/tell/model_json.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

constexpr const char* kFooter = R"(
Examples:
  stickband model loop.csv -o m.json
  stickband model loop.csv -o m.json --with process.dead_time,valve.backlash
  stickband model valve.csv --output x -o stem.json
  stickband model monday.csv tuesday.csv --validate friday.csv -o m.json

Fits a first-order process behind a linear valve without dead time, and the effects
that --with names. Three samples of five are fitted, block by block; the others judge
(validation). Then: `stickband compare`, `explain`, `add`, or `ladder` for all at once.

Several recordings of one loop get one model, with an initial state each. --validate
names one that judges: nothing is fitted to it but its initial state. So it is with
the other commands.)";

std::string model_text(const FittedModel& fitted, const Recording& recording,
                       const std::string& kept) {
  std::string text = "Model of " + std::string(name_of(fitted.model.output)) +
                     " from u, " + fitted.model.fitted.name + "\n\n  process\n" +
                     parameter_table(fitted.model.process, 4);
  for (const EffectTerm& term : fitted.model.effects) {
    text += "  " + term.effect + '\n' + effect_table(term, 4);
  }
  return text + "\nFit " + fixed(fitted.quality.fit_percent, 1) + " %, error " +
         number(fitted.quality.rmse, 4) + " (validation " +
         number(fitted.quality.rmse_validation, 4) + ")\n" +
         caution_text(fitted.model, recording, fitted.quality,
                      is_left_to_controller(fitted.model, recording)) +
         recordings_table(fitted.quality.recordings) + kept;
}

int make(const ModelOptions& options) {
  refuse_to_replace_inputs(options);
  const Column output = output_of(options, Column::y);
  const std::vector<std::string> with = effects_of(options);
  const ReadRecordings read = read_for(options, output, with);
  const Recording& recording = read.joined;
  const Work work(limits_of(options));
  const FittedModel fitted =
      start_model(recording, output, with, standard_catalogue(), work);
  complain_about_unlike(recording, output, fitted.quality.recordings);
  complain_about_left_behind(fitted.model, recording);
  complain_about_unused(read, fitted.model, work);
  const std::string kept = saved(fitted.model, options.target);
  nlohmann::ordered_json json = model_json(fitted.model);
  json["recordings"] = recordings_json(fitted.quality.recordings);
  print(options.json ? json_line(json) : model_text(fitted, recording, kept));
  return kDone;
}

}  // namespace

void add_model(CLI::App& app, Action& action) {
  const auto options = std::make_shared<ModelOptions>();
  CLI::App* command =
      app.add_subcommand("model", "Make and fit a starting model of the loop");
  add_model_options(*command, *options);
  add_target(*command, *options);
  add_with(*command, *options);
  add_work(*command, *options, false);
  runs(*command, action, options, make, kFooter);
}

}  // namespace workbench::cli
