// The one exception of the readers: bad input, said so that it can be repaired.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace workbench {

/// Bad input (exit code 3 of `stickband`). what() is one printable line:
/// `file:line:column: expected …, found …; do …`. Line and column count from 1,
/// columns in bytes; 0 means that the whole file (or line) is meant and the
/// number is left out of the message.
class InputError : public std::runtime_error {
 public:
  InputError(std::string file, std::size_t line, std::size_t column, std::string expected,
             std::string found, std::string advice);

  /// The same of a text that was put together: its lines are those of no file.
  [[nodiscard]] InputError without_line() const {
    return {file, 0, 0, expected, found, advice};
  }

  std::string file;
  std::size_t line;
  std::size_t column;
  std::string expected;
  std::string found;
  std::string advice;  ///< what to do about it
};

/// A recording that is well written, but whose data cannot answer (exit code 4).
class CannotAnswer : public InputError {
 public:
  using InputError::InputError;
};

/// `text` in quotes, cut after about 40 bytes; what is not printable UTF-8 becomes '?'.
[[nodiscard]] std::string quoted(std::string_view text);

}  // namespace workbench
