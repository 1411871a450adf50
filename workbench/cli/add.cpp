#include <CLI/CLI.hpp>
#include <memory>

#include "workbench/analysis/identification_json.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/model_options.hpp"
#include "workbench/effects/catalogue.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/model/tell/explanation_json.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

struct Options : ModelOptions {
  std::string effect;
};

constexpr const char* kFooter = R"(
Examples:
  stickband add valve.stiction loop.csv
  stickband add valve.stiction loop.csv --model m.json -o m2.json

Adds the effect whatever `stickband explain` thinks of it, and fits everything again.)";

std::string added_text(const FittedModel& fitted, const std::string& kept) {
  const Model& model = fitted.model;
  const HistoryStep& step = model.history.back();
  const EffectTerm& term = model.effects.back();
  std::string text = "Added " + step.effect + "\n  validation error " +
                     number(step.rmse_validation_before, 4) + " to " +
                     number(step.rmse_validation_after, 4) + ", " +
                     fall(step.rmse_validation_before, step.rmse_validation_after) +
                     "\n  error            " + number(step.rmse_before, 4) + " to " +
                     number(step.rmse_after, 4) + ", " +
                     fall(step.rmse_before, step.rmse_after) + '\n' +
                     effect_table(term, 4);
  return text + caution_text(model, fitted.quality.fit_percent) +
         recordings_table(fitted.quality.recordings) + kept;
}

int add_to(const Options& options) {
  refuse_to_replace_inputs(options);
  if (standard_catalogue().find(options.effect) == nullptr) {
    throw UsageError("no effect '" + options.effect +
                     "'; known effects: " + standard_catalogue().codes());
  }
  const Work work(limits_of(options));
  const auto [model, recording] = modelled_for(options, work, options.effect);
  FittedModel next;
  try {
    next = add_effect(recording, model, options.effect, standard_catalogue(), work);
  } catch (const std::invalid_argument& error) {
    return cannot_answer(error.what());
  }
  const std::string kept = saved(next.model, options.target);
  nlohmann::ordered_json json = added_json(next.model);
  json["recordings"] = recordings_json(next.quality.recordings);
  print(options.json ? json_line(json) : added_text(next, kept));
  return kDone;
}

}  // namespace

void add_add(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("add", "Add one physical effect to a model and fit it again");
  command->add_option("EFFECT", options->effect, "its code, as `explain` names it")
      ->required();
  add_model_options(*command, *options);
  add_model_file(*command, *options);
  add_target(*command, *options);
  add_work(*command, *options, false);
  command->footer(kFooter);
  command->callback(
      [&action, options] { action = [options] { return add_to(*options); }; });
}

}  // namespace workbench::cli
