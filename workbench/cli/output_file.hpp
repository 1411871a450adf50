// Output files that are either complete or not there.
#pragma once

#include <string>
#include <string_view>

namespace workbench::cli {

/// Replaces the file `path` with `text` in one step: a temporary file beside it, renamed.
/// What is not a regular file (/dev/stdout, a pipe) is written directly. Throws
/// OutputError.
void write_file(const std::string& path, std::string_view text);

/// Throws OutputError where write_file(path) cannot succeed as the folders are now: asked
/// before the work whose result goes there. An empty path asks nothing.
void expect_writable(const std::string& path);

}  // namespace workbench::cli
