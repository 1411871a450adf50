// The front door of `stickband`.
#pragma once

namespace workbench::cli {

/// Parses the command line, runs one command, returns the exit code. Everything that
/// goes wrong ends as one message on stderr.
[[nodiscard]] int run(int argc, char** argv);

}  // namespace workbench::cli
