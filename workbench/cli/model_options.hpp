// What model, compare, explain, add and ladder share: options, files and tables.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "workbench/model/base/model.hpp"
#include "workbench/model/base/work.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/recording/recording.hpp"
#include "workbench/recording/source.hpp"

namespace CLI {
class App;
}

namespace workbench::cli {

/// The recordings and the output that is modelled.
struct ModelOptions {
  RecordingSource source;            ///< REC
  std::vector<std::string> more;     ///< further recordings of the loop, read like REC
  std::vector<std::string> judging;  ///< --validate, likewise
  std::string output;  ///< "y", "x", or empty: that of the model, y without one
  std::string with;    ///< effects, separated by commas
  std::string model;   ///< --model M.json; empty: a starting model
  std::string target;  ///< -o; empty: nothing is kept
  bool json = false;
  std::optional<double> within;  ///< s; none: no limit
  unsigned threads = 0;          ///< 0: all cores
};

/// Adds REC and its options, MORE and --validate.
void add_recordings(CLI::App& command, ModelOptions& options);
/// The same with --output and --json.
void add_model_options(CLI::App& command, ModelOptions& options);
void add_model_file(CLI::App& command, ModelOptions& options);
void add_target(CLI::App& command, ModelOptions& options);
void add_with(CLI::App& command, ModelOptions& options);
/// Adds --threads and, for a search that has an answer at any time, --within.
void add_work(CLI::App& command, ModelOptions& options, bool within);

/// "stickband ladder a.csv b.csv --u OP --validate c.csv": the search on the same
/// recordings, read alike, for `output`.
[[nodiscard]] std::string ladder_words(const ModelOptions& options, Column output);

/// The effects of --with. Throws UsageError for an unknown one or one named twice.
[[nodiscard]] std::vector<std::string> effects_of(const ModelOptions& options);
/// y or x, as --output says; `otherwise` where it says nothing.
[[nodiscard]] Column output_of(const ModelOptions& options, Column otherwise);

/// What the search may use; the time limit starts now.
[[nodiscard]] Work::Limits limits_of(const ModelOptions& options);

/// Throws UsageError where the target is the recording or a file that explains it: before
/// any work, for what is overwritten is gone. The model itself may be replaced. Throws
/// OutputError where the target cannot be written.
void refuse_to_replace_inputs(const ModelOptions& options);
/// Throws UsageError where `input`, if there is one, and `target` are the same file.
void refuse_to_replace(const std::string& input, const std::string& target);

/// Reads REC and MORE with u and `output`. Throws UsageError for a file named twice.
[[nodiscard]] std::vector<Recording> recordings_for(const ModelOptions& options,
                                                    Column output);
/// What a model is made of, read once.
struct ReadRecordings {
  Recording joined;               ///< REC, MORE and what judges (joined.hpp)
  std::vector<Recording> fitted;  ///< REC and MORE, each by itself
  std::vector<Load> unused;  ///< what else is in `joined`, where no load was asked for
};
/// Reads REC, MORE and those that judge, with the columns of the measured loads among the
/// effects `codes`, asked for or not; complains about what was repaired.
[[nodiscard]] ReadRecordings read_for(ModelOptions options, Column output,
                                      const std::vector<std::string>& codes);
/// Complains about files of `recording` that seem to be of another loop (unlike.hpp).
void complain_about_unlike(const Recording& recording, Column output,
                           const std::vector<RecordingFit>& recordings);
/// Each recording with its fit and errors, as a table; "" for a single one.
[[nodiscard]] std::string recordings_table(const std::vector<RecordingFit>& recordings);
struct Modelled {
  Model model;
  ReadRecordings read;
};
/// Reads --model and the recording, or without it fits a starting model to the recording,
/// which no time limit ends. `added`: an effect that the model is to get, whose measured
/// load is read, too. Throws UsageError where --output contradicts the file, or where it
/// has `added` already.
[[nodiscard]] Modelled modelled_for(const ModelOptions& options, const Work& work,
                                    const std::string& added = {});
/// Writes a model file in one step; nothing where `path` is empty. Tells which, one line.
[[nodiscard]] std::string saved(const Model& model, const std::string& path);

/// Why a search ended early: the time, or its own limit; what it leaves is the best
/// `what` so far, "model".
[[nodiscard]] std::string ended_early(bool time_was_up, const std::string& what);
/// What to know before its numbers are used (cautions.hpp), each on lines of its own.
[[nodiscard]] std::string caution_text(const Model& model, const Recording& recording,
                                       const FitQuality& quality,
                                       bool left_to_controller);
/// Where a long recording was searched, and which of the figures told are of that.
[[nodiscard]] std::string searched_text(const Searched& searched, std::string_view which);
/// "after a step of 30 %": from one error to another, in percent down.
[[nodiscard]] std::string fall(double before, double after);
}  // namespace workbench::cli
