#include "workbench/cli/model_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>

#include "workbench/analysis/wording.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/output_file.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/effects/catalogue.hpp"
#include "workbench/model/model_json.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

// "30" or "30s".
double seconds_of(std::string text) {
  if (text.ends_with('s')) text.pop_back();
  double seconds = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, seconds);
  if (error != std::errc{} || rest != end || !(seconds > 0) || !(seconds < 1e6)) {
    throw CLI::ValidationError("--within", "expected seconds above 0, as in 30");
  }
  return seconds;
}

}  // namespace

void add_model_options(CLI::App& command, ModelOptions& options) {
  add_recording_options(command, options.source);
  command.add_option("--output", options.output, "what is modelled: y, or x")
      ->type_name("y|x")
      ->check(CLI::IsMember({"y", "x"}));
  command.add_flag("--json", options.json, "one JSON object instead of text");
}

void add_model_file(CLI::App& command, ModelOptions& options) {
  command.add_option("--model", options.model, "the model file")
      ->type_name("M.json")
      ->required();
}

void add_target(CLI::App& command, ModelOptions& options, bool required) {
  command.add_option("-o,--output-file", options.target, "where the model goes")
      ->type_name("M.json")
      ->required(required);
}

void add_work(CLI::App& command, ModelOptions& options, bool within) {
  command
      .add_option("--threads", options.threads,
                  "threads of the search, default all cores; the answer is the same")
      ->type_name("N")
      ->check(CLI::Range(1U, 1024U));
  if (!within) return;
  command
      .add_option_function<std::string>(
          "--within",
          [&options](const std::string& text) { options.within = seconds_of(text); },
          "end the search after this time with the best answer so far")
      ->type_name("SECONDS");
}

Work::Limits limits_of(const ModelOptions& options) {
  return {.threads = options.threads > 0 ? options.threads : Work::cores(),
          .seconds = options.within};
}

void add_with(CLI::App& command, ModelOptions& options) {
  command.add_option("--with", options.with, "effects of the start, comma-separated")
      ->type_name("EFFECT,…");
}

std::vector<std::string> effects_of(const ModelOptions& options) {
  std::vector<std::string> codes;
  std::string rest = options.with;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(','), rest.size());
    const std::string code = rest.substr(0, end);
    rest.erase(0, std::min(end + 1, rest.size()));
    if (code.empty()) continue;
    if (standard_catalogue().find(code) == nullptr) {
      throw UsageError("no effect '" + code +
                       "'; known effects: " + standard_catalogue().codes());
    }
    if (std::find(codes.begin(), codes.end(), code) != codes.end()) {
      throw UsageError("--with names " + code + " twice");
    }
    codes.push_back(code);
  }
  return codes;
}

Column output_of(const ModelOptions& options, Column otherwise) {
  return options.output.empty()  ? otherwise
         : options.output == "x" ? Column::x
                                 : Column::y;
}

void refuse_to_replace(const std::string& input, const std::string& target) {
  std::error_code ignored;
  if (!input.empty() && std::filesystem::equivalent(input, target, ignored)) {
    throw UsageError("-o would replace " + input + ", which is read");
  }
}

void refuse_to_replace_inputs(const ModelOptions& options) {
  const RecordingSource& source = options.source;
  for (const std::string& input : {source.path, source.dbc, source.config}) {
    refuse_to_replace(input, options.target);
  }
}

Recording read_for(const ModelOptions& options, Column output) {
  RecordingSource source = options.source;
  source.required = {Column::u, output};
  Recording recording = read(source);
  for (const std::string& note : recording.resampling.notes) complain(note);
  return recording;
}

Model model_for(const ModelOptions& options) {
  Model model = read_model(options.model);
  if (output_of(options, model.output) != model.output) {
    throw UsageError(options.model + " models " + std::string(name_of(model.output)) +
                     ", not " + options.output);
  }
  return model;
}

void save(const Model& model, const std::string& path) {
  write_file(path, model_json(model).dump(2) + '\n');
}

std::string padded(std::string_view text, std::size_t width) {
  return std::string(text) + std::string(width - std::min(width, text.size()), ' ');
}

std::string parameter_table(const std::vector<Parameter>& parameters,
                            std::size_t indent) {
  std::string text;
  for (const Parameter& p : parameters) {
    const std::string interval =
        p.low < p.high ? number(p.low, 4) + " to " + number(p.high, 4) : std::string();
    text += std::string(indent, ' ') + padded(p.name, 24) +
            padded(number(p.value, 4), 12) + padded(interval, 26) +
            (p.unit == "1" ? "" : p.unit) + '\n';
  }
  return text;
}

std::string fall(double before, double after) {
  if (!(before > 0)) return {};
  const double percent = 100 * (1 - after / before);
  return percent >= 0 ? "down " + fixed(percent, 1) + " %"
                      : "up " + fixed(-percent, 1) + " %";
}

std::string candidate_text(const Candidate& c) {
  std::string name = c.effect;
  for (const std::string& other : c.with) name += " with " + other;
  std::string text = padded(std::string(name_of(c.status)), 13) + name + '\n';
  std::string told = c.evidence;
  if (c.status == CandidateStatus::kAccepted) {
    told += " Validation error " + number(c.rmse_validation_before, 4) + " to " +
            number(c.rmse_validation_after, 4) + ", " +
            fall(c.rmse_validation_before, c.rmse_validation_after) + ".";
  }
  if (!c.indistinguishable_from.empty()) {
    told += " This recording cannot tell it from ";
    for (std::size_t i = 0; i < c.indistinguishable_from.size(); ++i) {
      told += (i > 0 ? ", " : "") + c.indistinguishable_from[i];
    }
    told += ".";
    if (c.would_split) told += " What would: " + *c.would_split + ".";
  }
  text += std::string(13, ' ') + wrapped(told, 13) + '\n';
  if (c.status == CandidateStatus::kAccepted) text += parameter_table(c.parameters, 13);
  return text;
}

}  // namespace workbench::cli
