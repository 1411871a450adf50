// LabVIEW measurement files of several segments.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// The rows of all segments of an LVM file as one table under the names of the first,
/// each line where it was: X_Value counts from the first segment's Date and Time on.
/// Nothing: no such file, or one segment. Throws InputError where a segment has no
/// X_Value, no date and time, or other channels than the first. O(n).
[[nodiscard]] std::optional<std::string> lvm_segments_text(std::string_view text,
                                                           const std::string& file);

}  // namespace workbench
