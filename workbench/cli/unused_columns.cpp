#include "workbench/cli/unused_columns.hpp"

#include <exception>
#include <optional>
#include <stdexcept>
#include <utility>

#include "workbench/cli/console.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/effects/catalogue.hpp"
#include "workbench/model/base/joined.hpp"
#include "workbench/model/base/shortened.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/recording/further_signals.hpp"
#include "workbench/recording/named_signal.hpp"
#include "workbench/recording/own_readings.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

// Rows one to one, and nothing repaired that another column could have to do with.
bool is_as_written(const Recording& recording) {
  const ResampleReport& report = recording.resampling;
  return report.notes.empty() && !report.resampled && report.missing == 0 &&
         report.repeated == 0 && report.empty_cells == 0;
}

// The loads of `all`, which may begin later, beside `recording`.
std::vector<Load> laid_beside(const Recording& recording, Recording all) {
  if (all.period_s != recording.period_s || all.size() > recording.size()) return {};
  const std::size_t later = recording.size() - all.size();
  for (Load& load : all.loads) {
    load.values.insert(load.values.begin(), later, load.values.front());
  }
  return std::move(all.loads);
}

void drop_loads(std::vector<Recording>& recordings) {
  for (Recording& one : recordings) one.loads.clear();
}

}  // namespace

Recording read_with_unused(const RecordingSource& source) {
  if (!source.dbc.empty() || !source.config.empty()) return read(source);
  RecordingSource asking = source;
  asking.names.loads = {"all"};
  std::optional<Recording> all;
  try {
    all = read(asking);
    static_cast<void>(take_out_own_readings(*all));
  } catch (const std::exception&) {  // without the other columns it may be readable
  }
  if (all && is_as_written(*all)) return std::move(*all);
  Recording out = read(source);
  if (all) out.loads = laid_beside(out, std::move(*all));
  return out;
}

Recording joined_beside(std::vector<Recording>& fitted, std::vector<Recording> judging,
                        std::vector<Load>& unused) {
  try {
    unused = joined(fitted, judging).loads;
  } catch (const std::exception&) {  // of units that differ nothing is said
  }
  drop_loads(fitted);
  drop_loads(judging);
  return joined(fitted, std::move(judging));
}

std::string note_on_unused(const UnusedColumns& unused) {
  const std::vector<std::string>& names = unused.names;
  const std::optional<HelpfulLoad>& helps = unused.helps;
  if (names.empty()) return {};
  const std::string listed = first_three(names);
  const std::string if_it_is_one =
      ", if it is a cause and no other reading of the output";
  if (helps) {
    return (names.size() == 1 ? "column not used: " : "columns not used: ") + listed +
           "; as a load " + helps->name + " would take away " +
           number(100 * helps->share, 3) +
           " % of the squared error, more than chance does: --load " +
           shell_word(cut_name(helps->name)) + if_it_is_one;
  }
  return names.size() == 1
             ? "column not used: " + listed + "; --load " +
                   shell_word(cut_name(names[0])) +
                   " tries it as a load that moves the output" + if_it_is_one
             : "columns not used: " + listed +
                   "; --load COLUMN tries one as a load that moves the output" +
                   if_it_is_one + ", --load all every one";
}

UnusedColumns complain_about_unused(const ReadRecordings& read, const Model& model,
                                    const Work& work, const std::string& lacks) {
  UnusedColumns out{names_of_moving(read.unused), {}};
  if (out.names.empty()) return out;
  try {
    out.helps = helpful_load(read.joined, model, read.unused, work);
    if (!out.helps && !lacks.empty() && !is_long(read.joined)) {
      const Model next =
          add_effect(read.joined, model, lacks, standard_catalogue(), work).model;
      out.helps = helpful_load(read.joined, next, read.unused, work);
    }
  } catch (const OutOfTime&) {              // they are named, if not tried
  } catch (const std::invalid_argument&) {  // it cannot be added
  }
  complain(note_on_unused(out));
  return out;
}

}  // namespace workbench::cli
