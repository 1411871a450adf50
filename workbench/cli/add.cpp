#include <CLI/CLI.hpp>
#include <memory>

#include "workbench/analysis/identification_json.hpp"
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
#include "workbench/model/tell/harm.hpp"
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

constexpr const char* kFooterOfRemove = R"(
Example:
  stickband remove disturbance.step loop.csv --model m.json -o m2.json

Fits everything that stays again. What grows is what the effect was good for.)";

// Of an effect that was added and takes nothing away.
std::string harm_text(const Model& model, const std::string& effect) {
  const HistoryStep* harm = harm_of(model, effect);
  if (harm == nullptr) return {};
  return wrapped(is_in_doubt(*harm)
                     ? "In doubt: with it more is left than before on samples that were "
                       "not fitted."
                     : "Nothing in this recording speaks for it: with it more is left "
                       "than before. `stickband remove` takes it out again.",
                 0) +
         '\n';
}

std::string change_text(const HistoryStep& step) {
  std::string ahead;
  if (step.ahead) {
    ahead = "\n  one sample ahead " + number(step.ahead->before, 4) + " to " +
            number(step.ahead->after, 4) + ", " +
            fall(step.ahead->before, step.ahead->after) +
            "\n  and running free, where the load hides it:";
  }
  return ahead + "\n  validation error " + number(step.rmse_validation_before, 4) +
         " to " + number(step.rmse_validation_after, 4) + ", " +
         fall(step.rmse_validation_before, step.rmse_validation_after) +
         "\n  error            " + number(step.rmse_before, 4) + " to " +
         number(step.rmse_after, 4) + ", " + fall(step.rmse_before, step.rmse_after) +
         '\n';
}

int tell(const Options& options, const Recording& recording, const FittedModel& next,
         nlohmann::ordered_json json, const std::string& text) {
  const std::string kept = saved(next.model, options.target);
  json["recordings"] = recordings_json(next.quality.recordings);
  print(options.json ? json_line(json)
                     : text +
                           caution_text(next.model, recording, next.quality,
                                        is_left_to_controller(next.model, recording)) +
                           recordings_table(next.quality.recordings) + kept);
  return kDone;
}

int add_to(const Options& options) {
  refuse_to_replace_inputs(options);
  if (standard_catalogue().find(options.effect) == nullptr) {
    throw UsageError(standard_catalogue().no_effect(options.effect));
  }
  const Work work(limits_of(options));
  const auto [model, read] = modelled_for(options, work, options.effect);
  FittedModel next;
  try {
    next = add_effect(read.joined, model, options.effect, standard_catalogue(), work);
  } catch (const std::invalid_argument& error) {
    return cannot_answer(error.what());
  }
  complain_about_left_behind(next.model, read.joined);
  complain_about_unused(read, next.model, work);
  const HistoryStep& step = next.model.history.back();
  return tell(options, read.joined, next, added_json(next.model),
              "Added " + step.effect + change_text(step) +
                  effect_table(next.model.effects.back(), 4) +
                  harm_text(next.model, step.effect));
}

int remove_from(const Options& options) {
  refuse_to_replace_inputs(options);
  const Work work(limits_of(options));
  const auto [model, read] = modelled_for(options, work);
  if (!model.has(options.effect)) {
    throw UsageError(options.model + " has no " + options.effect);
  }
  const FittedModel next =
      remove_effect(read.joined, model, options.effect, standard_catalogue(), work);
  complain_about_left_behind(next.model, read.joined);
  complain_about_unused(read, next.model, work);
  return tell(options, read.joined, next, removed_json(next.model),
              "Removed " + options.effect + change_text(next.model.history.back()));
}

// A command that changes the effects of a model by one.
CLI::App& add_change(CLI::App& app, Action& action, int (*change)(const Options&),
                     const std::string& name, const std::string& what,
                     const char* footer) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand(name, what);
  command.add_option("EFFECT", options->effect, "its code, as `explain` names it")
      ->required();
  add_model_options(command, *options);
  add_model_file(command, *options);
  add_target(command, *options);
  add_work(command, *options, false);
  runs(command, action, options, change, footer);
  return command;
}

}  // namespace

void add_add(CLI::App& app, Action& action) {
  add_change(app, action, add_to, "add",
             "Add one physical effect to a model and fit it again", kFooter);
}

void add_remove(CLI::App& app, Action& action) {
  add_change(app, action, remove_from, "remove",
             "Take one physical effect out of a model and fit it again", kFooterOfRemove)
      .get_option("--model")
      ->required()
      ->description("the model file that has it");
}

}  // namespace workbench::cli
