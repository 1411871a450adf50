// The command line of stickbandd.
#pragma once

namespace firmware {

/// Does what the arguments say. Returns the contract's exit code: 0 done, 1 failed, 2
/// wrong usage, 3 bad input.
[[nodiscard]] int run(int argc, char** argv);

}  // namespace firmware
