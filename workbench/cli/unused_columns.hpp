// Measured signals of a recording that nobody asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workbench/cli/model_options.hpp"
#include "workbench/model/base/model.hpp"
#include "workbench/model/base/work.hpp"
#include "workbench/model/judge/helpful_load.hpp"
#include "workbench/recording/recording.hpp"
#include "workbench/recording/source.hpp"

namespace workbench::cli {

/// Reads `source`, which asks for no load, and leaves in `loads` what else its file has,
/// sample by sample beside the loop; what cannot be laid beside it is left out. A file
/// that needs no repair is read once. Throws as read_recording().
[[nodiscard]] Recording read_with_unused(const RecordingSource& source);

/// Joins recordings (joined.hpp) without their loads, which `fitted` loses and, where
/// they can be joined, too, `unused` gets. Throws as joined().
[[nodiscard]] Recording joined_beside(std::vector<Recording>& fitted,
                                      std::vector<Recording> judging,
                                      std::vector<Load>& unused);

/// The signals beside those of the loop that move and are no counts of rows or time.
struct UnusedColumns {
  std::vector<std::string> names;
  std::optional<HelpfulLoad> helps;  ///< the one of them that would help most
};

/// Which were not used, the first three by name, and what tries them, or the one that
/// helps; "" where there are none.
[[nodiscard]] std::string note_on_unused(const UnusedColumns& unused);

/// Complains with that note of those of `read`, of the one that would help `model` most
/// (helpful_load.hpp). `lacks`: an effect that hides what a load does as long as the
/// model has it not; "" none is known. Returns them.
UnusedColumns complain_about_unused(const ReadRecordings& read, const Model& model,
                                    const Work& work = Work::unlimited(),
                                    const std::string& lacks = {});

}  // namespace workbench::cli
