// A whole file in memory, with the reasons when that is impossible.
#pragma once

#include <cstddef>
#include <string>

namespace workbench {

/// Bytes of the longest recording that is read.
inline constexpr std::size_t kMostBytes = std::size_t{512} << 20;

/// Reads `path`. Throws InputError when it cannot be read, is a folder, or is
/// longer than `max_bytes`.
[[nodiscard]] std::string read_text_file(const std::string& path, std::size_t max_bytes);

/// `path` without its folders.
[[nodiscard]] std::string file_name(const std::string& path);

/// What is replaced where `path` is: a link keeps pointing where it points.
[[nodiscard]] std::string link_target(const std::string& path);

}  // namespace workbench
