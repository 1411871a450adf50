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

/// What there is to say about `further`, the signals beside those of the loop: which
/// were not used, the first three by name, and what tries them, or the one that `helps`.
/// Those that never change and counts of rows or time are not named; "" where none is
/// left.
[[nodiscard]] std::string note_on_unused(
    const std::vector<Load>& further,
    const std::optional<HelpfulLoad>& helps = std::nullopt);

/// Complains with that note, of the one that would help `model` most (helpful_load.hpp).
void complain_about_unused(const ReadRecordings& read, const Model& model,
                           const Work& work = Work::unlimited());

}  // namespace workbench::cli
