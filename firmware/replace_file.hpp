// A file that readers see in its old or its new state, never in between.
#pragma once

#include <cstdint>
#include <string_view>

namespace firmware {

/// Who may read it, whatever the umask.
enum class Readers : std::uint8_t { kOwner, kEverybody };

/// Writes `text` beside `path`, as path.new, and renames it. False when that fails (errno
/// says why); the old file stays. What lies at path.new is removed, never followed or
/// written to. `durable`: waits until the disk has it, which may take a second.
[[nodiscard]] bool replace_file(const char* path, std::string_view text, Readers readers,
                                bool durable = false);

}  // namespace firmware
