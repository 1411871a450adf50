#include "workbench/model/judge/compare.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "workbench/analysis/identification_json.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/model_options.hpp"
#include "workbench/cli/unused_columns.hpp"
#include "workbench/model/tell/cautions.hpp"
#include "workbench/model/tell/explanation_json.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

constexpr const char* kFooter = R"(
Examples:
  stickband compare loop.csv             where does a first-order model fail?
  stickband compare loop.csv --model m.json
  stickband compare another-day.csv --model m.json --json
  stickband compare loop.csv --validate another-day.csv --model m.json

Simulates from u alone and says where the squared error lies: in time, phase, level,
direction, speed and travel of u, and frequency. On a recording that the model was not
fitted to, only the initial state is estimated; loads of the first are left out.)";

std::string comparison_text(const Comparison& comparison, const Recording& recording) {
  const FitQuality& quality = comparison.quality;
  std::string text = recording.name + ": fit " + fixed(quality.fit_percent, 1) +
                     " %, error " + number(quality.rmse, 4) + " (validation " +
                     number(quality.rmse_validation, 4) + ")\nEffects: ";
  text += comparison.effects.empty() ? "none" : listed(comparison.effects);
  if (!comparison.stayed_behind.empty()) {
    text += "\n" + wrapped(
                       "Left out, for they belong to the recording that the model was "
                       "fitted to: " +
                           listed(comparison.stayed_behind) + '.',
                       0);
  }
  if (quality.fit_percent < 0) {
    text += "\n" + wrapped(
                       "A model that says less than the mean of the output does "
                       "belongs to another loop, to other units, or to a day with "
                       "another load.",
                       0);
  }
  const Whiteness& test = comparison.residual_test;
  text += std::string("\nResidual: ") +
          (test.white ? "white" : "not white: neighbouring errors are alike") +
          (test.follows_u ? "; it still follows u" : "; it does not follow u") + "\n" +
          recordings_table(quality.recordings) + '\n';
  if (comparison.failures.empty()) {
    return text + "No place where the model fails more than elsewhere.\n";
  }
  text += "Where it fails       of the squared error   of the samples\n";
  for (const Failure& failure : comparison.failures) {
    text += padded("  " + std::string(name_of(failure.view)), 21) +
            padded(fixed(100 * failure.share_of_error, 0) + " %", 23) +
            fixed(100 * failure.share_of_samples, 0) + " %\n      " +
            wrapped(failure.where + "; worst at t = " + number(failure.t_from, 5) +
                        " to " + number(failure.t_to, 5) + " s" +
                        (failure.recording.empty() ? "" : " of " + failure.recording),
                    6) +
            '\n';
  }
  return text;
}

int compare_with(const ModelOptions& options) {
  const auto [model, read] = modelled_for(options, Work::unlimited());
  const Comparison comparison = compare(read.joined, model);
  complain_about_unused(read, model);
  const std::string mind =
      is_left_to_controller(model, read.joined)
          ? '\n' + caution_text(model, read.joined, comparison.quality, true)
          : std::string();
  print(options.json ? json_line(comparison_json(comparison))
                     : comparison_text(comparison, read.joined) + mind);
  return kDone;
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
  const auto options = std::make_shared<ModelOptions>();
  CLI::App* command =
      app.add_subcommand("compare", "Show where a model fails, largest share first");
  add_model_options(*command, *options);
  add_model_file(*command, *options);
  runs(*command, action, options, compare_with, kFooter);
}

}  // namespace workbench::cli
