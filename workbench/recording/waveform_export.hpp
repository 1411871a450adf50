// LabVIEW measurement files whose rows have no times: the heads say how far apart they
// are.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// The same lines, each row with the time that X0 and Delta_X give it; nothing where
/// `text` is no such file, has times, or channels of different ones. O(bytes).
[[nodiscard]] std::optional<std::string> waveform_text(std::string_view text);

}  // namespace workbench
