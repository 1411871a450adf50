// LabVIEW measurement files (LVM) of several segments, or without times in their rows.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// Ends each head: that of the file, then those of its segments.
inline constexpr std::string_view kEndOfLabviewHead = "***End_of_Header***";

/// The rows of an LVM file as one table, each line where it was. Of several segments
/// under the names of the first, X_Value counted from its Date and Time on; of one
/// without times, with those that X0 and Delta_X give. Nothing: no such file, or one
/// segment that has times or channels of different ones. Throws InputError where a
/// segment of several has no X_Value, no date and time, or other channels than the first.
/// O(bytes).
[[nodiscard]] std::optional<std::string> labview_text(std::string_view text,
                                                      const std::string& file);

}  // namespace workbench
