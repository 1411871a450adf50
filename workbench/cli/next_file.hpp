// A name for the next of a row of files.
#pragma once

#include <string>

namespace workbench::cli {

/// A file that is not there yet, beside `path` and named as it: m2.json after m.json,
/// m3.json after m2.json, loop-2026-2.json after loop-2026.json. Where `path` is empty or
/// no regular file: m.json, or the next one free, in the present folder.
[[nodiscard]] std::string next_file(const std::string& path);

}  // namespace workbench::cli
