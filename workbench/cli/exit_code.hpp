// The contract's exit codes, and the errors that lead to them.
#pragma once

#include <stdexcept>

namespace workbench::cli {

enum ExitCode : int {
  kDone = 0,
  kFailed = 1,         ///< anything that the others are not
  kWrongUsage = 2,     ///< UsageError, or what the parser refuses
  kBadInput = 3,       ///< InputError
  kCannotAnswer = 4,   ///< CannotAnswer: the data cannot answer
  kInterrupted = 130,  ///< ended by Ctrl-C
};

/// Options that are well-formed but do not make sense.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file or stream that cannot be written.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace workbench::cli
