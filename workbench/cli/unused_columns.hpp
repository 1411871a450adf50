// Measured signals of a recording that nobody asked for.
#pragma once

#include <string>
#include <vector>

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
/// were not used, the first three by name, and what tries them. Those that never change
/// do not count; "" where none is left.
[[nodiscard]] std::string note_on_unused(const std::vector<Load>& further);

/// Complains with that note.
void complain_about_unused(const std::vector<Load>& unused);

}  // namespace workbench::cli
