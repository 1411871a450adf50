#include "workbench/cli/model_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "wire/text.hpp"
#include "workbench/analysis/signal_notes.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/output_file.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/cli/unused_columns.hpp"
#include "workbench/effects/catalogue.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/base/joined.hpp"
#include "workbench/model/judge/unlike.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/model/tell/cautions.hpp"
#include "workbench/model/tell/model_json.hpp"
#include "workbench/recording/option_words.hpp"
#include "workbench/recording/own_readings.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

// "30" or "30s".
double seconds_of(std::string text) {
  if (text.ends_with('s')) text.pop_back();
  const std::optional<double> seconds = wire::number_of<double>(text);
  if (!(seconds > 0.0 && seconds < 1e6)) {
    throw CLI::ValidationError("--within", "expected seconds above 0, as in 30");
  }
  return *seconds;
}

}  // namespace

void add_recordings(CLI::App& command, ModelOptions& options) {
  add_recording_options(command, options.source);
  command.add_option("MORE", options.more,
                     "further recordings of the same loop: one model of all, an initial "
                     "state each");
  command
      .add_option("--validate", options.judging,
                  "a recording that judges and is not fitted, repeatable")
      ->type_name("REC")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_model_options(CLI::App& command, ModelOptions& options) {
  add_recordings(command, options);
  command.add_option("--output", options.output, "what is modelled: y, or x")
      ->type_name("y|x")
      ->check(CLI::IsMember({"y", "x"}));
  command.add_flag("--json", options.json, "one JSON object instead of text");
}

void add_model_file(CLI::App& command, ModelOptions& options) {
  command
      .add_option("--model", options.model,
                  "the model file; without it, a starting model of REC")
      ->type_name("M.json");
}

void add_target(CLI::App& command, ModelOptions& options) {
  command
      .add_option("-o,--output-file", options.target,
                  "where the model goes; without it, nothing is kept")
      ->type_name("M.json");
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
  for (std::string_view rest = options.with; !rest.empty();) {
    const std::string code(wire::take_until(rest, ','));
    if (code.empty()) continue;
    if (standard_catalogue().find(code) == nullptr) {
      throw UsageError(standard_catalogue().no_effect(code));
    }
    if (std::ranges::find(codes, code) != codes.end()) {
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

std::string ladder_words(const ModelOptions& options, Column output) {
  std::string out = "stickband ladder " + file_word(options.source.path);
  for (const std::string& file : options.more) out += ' ' + file_word(file);
  out += option_words(options.source);
  for (const std::string& file : options.judging) out += " --validate " + file_word(file);
  return out + (output == Column::x ? " --output x" : "");
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
  for (const std::string& input : options.more) refuse_to_replace(input, options.target);
  for (const std::string& input : options.judging) {
    refuse_to_replace(input, options.target);
  }
  expect_writable(options.target);
}

namespace {

void refuse_twice(const std::vector<std::string>& paths) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::error_code ignored;
      if (std::filesystem::equivalent(paths[i], paths[j], ignored)) {
        throw UsageError(paths[i] +
                         " is named twice: it would count twice, or judge "
                         "what was fitted to it");
      }
    }
  }
}

std::vector<Recording> read_each(const ModelOptions& options, Column output,
                                 const std::vector<std::string>& paths,
                                 Recording (*read_one)(const RecordingSource&) = read) {
  RecordingSource source = options.source;
  source.required = {Column::u, output};
  std::vector<Recording> out;
  for (const RecordingSource& one : sources_of(source, paths)) {
    out.push_back(read_one(one));
  }
  return out;
}

std::vector<std::string> fitted_paths(const ModelOptions& options) {
  std::vector<std::string> paths = {options.source.path};
  paths.insert(paths.end(), options.more.begin(), options.more.end());
  std::vector<std::string> all = paths;
  all.insert(all.end(), options.judging.begin(), options.judging.end());
  refuse_twice(all);
  return paths;
}

}  // namespace

std::vector<Recording> recordings_for(const ModelOptions& options, Column output) {
  return read_each(options, output, fitted_paths(options));
}

ReadRecordings read_for(ModelOptions options, Column output,
                        const std::vector<std::string>& codes) {
  std::vector<std::string>& loads = options.source.names.loads;
  std::string needed;                 // by the effects, not asked for
  std::vector<std::string> in_model;  // loads that stay, whatever they are
  for (const std::string& code : codes) {
    if (!code.starts_with(effects::kMeasuredLoad)) continue;
    const std::string column = code.substr(effects::kMeasuredLoad.size());
    in_model.push_back(column);
    const bool asked = std::ranges::any_of(
        loads, [&](const auto& load) { return load == column || load == "all"; });
    if (asked) continue;
    loads.push_back(column);
    needed += (needed.empty() ? "" : ", ") + code;
  }
  ReadRecordings out;
  try {
    const auto read_one = loads.empty() ? read_with_unused : read;
    out.fitted = read_each(options, output, fitted_paths(options), read_one);
    std::vector<Recording> judging =
        read_each(options, output, options.judging, read_one);
    if (loads.empty()) {
      out.joined = joined_beside(out.fitted, std::move(judging), out.unused);
    } else {
      for (std::vector<Recording>* some : {&out.fitted, &judging}) {
        for (Recording& one : *some) leave_out_own_readings(one, in_model);
      }
      out.joined = joined(out.fitted, std::move(judging));
    }
  } catch (const std::invalid_argument& error) {
    if (needed.empty()) throw;
    throw std::invalid_argument("the model has " + needed +
                                ", read as with --load: " + error.what());
  }
  for (const std::string& note : out.joined.resampling.notes) complain(note);
  for (const Recording& one : out.fitted) {
    for (const std::string& note : notes_for_model(one)) complain(note);
  }
  return out;
}

namespace {

Model read_as_asked(const ModelOptions& options) {
  Model model = read_model(options.model);
  if (output_of(options, model.output) != model.output) {
    throw UsageError(options.model + " models " + std::string(name_of(model.output)) +
                     ", not " + options.output);
  }
  return model;
}

}  // namespace

Modelled modelled_for(const ModelOptions& options, const Work& work,
                      const std::string& added) {
  std::vector<std::string> codes;
  if (!added.empty()) codes.push_back(added);
  if (options.model.empty()) {
    const Column output = output_of(options, Column::y);
    ReadRecordings recordings = read_for(options, output, codes);
    const Work::WritingDown to_the_end(work);
    Model model =
        start_model(recordings.joined, output, {}, standard_catalogue(), work).model;
    complain("no --model: begins with a first-order model of " + recordings.joined.name +
             "; `stickband model` keeps one");
    return {std::move(model), std::move(recordings)};
  }
  Model model = read_as_asked(options);
  if (!added.empty() && model.has(added)) {
    throw UsageError(options.model + " already has " + added);
  }
  const std::vector<std::string> own = model.effect_codes();
  codes.insert(codes.begin(), own.begin(), own.end());
  ReadRecordings recordings = read_for(options, model.output, codes);
  return {std::move(model), std::move(recordings)};
}

std::string saved(const Model& model, const std::string& path) {
  if (path.empty()) return "Not kept; -o M.json keeps it.\n";
  write_file(path, model_json(model).dump(2) + '\n');
  return "Written to " + path + '\n';
}

std::string ended_early(bool time_was_up, const std::string& what) {
  return std::string("Ended early: ") +
         (time_was_up ? "the time was up" : "the search has a limit of its own") +
         ". This is the best " + what + " so far" +
         (time_was_up ? "; allow more with --within." : ".");
}

std::string caution_text(const Model& model, const Recording& recording,
                         const FitQuality& quality, bool left_to_controller) {
  std::string text;
  for (const std::string& caution :
       cautions(model, recording, quality, left_to_controller)) {
    text += wrapped(caution, 0) + '\n';
  }
  return text;
}

std::string searched_text(const Searched& searched, std::string_view which) {
  const std::string from = ", from t = " + instant(searched.from_s, searched.period_s) +
                           " s on, where u moves most";
  return wrapped("Searched in " + std::to_string(searched.samples) +
                     " samples, one every " + number(searched.period_s) + " s" +
                     (searched.is_excerpt ? from : std::string()) + ": " +
                     std::string(which),
                 0) +
         '\n';
}

void complain_about_unlike(const Recording& recording, Column output,
                           const std::vector<RecordingFit>& recordings) {
  for (const Unlike& one : unlike(recording, output, recordings)) {
    complain(
        one.file + ": a first-order model of its own explains " +
        fixed(one.fit_alone, 0) + " % of it, the common one " + fixed(one.fit_shared, 0) +
        " %: is it another loop, or were range, units or load changed? Fit it alone");
  }
}

std::string recordings_table(const std::vector<RecordingFit>& recordings) {
  if (recordings.size() < 2) return {};
  std::string text = padded("  recording", 34) + padded("fit", 10) + padded("error", 10) +
                     "validation\n";
  for (const RecordingFit& one : recordings) {
    text += padded("  " + one.file + " ", 34) +
            padded(fixed(one.fit_percent, 1) + " % ", 10) +
            padded(number(one.rmse, 4), 10) +
            (one.rmse_validation > 0 ? number(one.rmse_validation, 4) : "all fitted") +
            (one.judges ? ", not fitted" : "") + '\n';
  }
  return text;
}

std::string fall(double before, double after) {
  if (!(before > 0)) return {};
  const double percent = 100 * (1 - after / before);
  return percent >= 0 ? "down " + fixed(percent, 1) + " %"
                      : "up " + fixed(-percent, 1) + " %";
}

}  // namespace workbench::cli
