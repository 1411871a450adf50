// A file that readers see in its old or its new state, never in between.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace firmware {

/// Writes `text` beside `path` and renames it. False when that fails (errno says why);
/// the old file stays. `durable`: waits until the disk has it, which may take a second.
[[nodiscard]] bool replace_file(const char* path, std::string_view text,
                                bool durable = false);

}  // namespace firmware
