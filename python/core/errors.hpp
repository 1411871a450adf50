// The program's errors as exceptions of stickband.errors.
#pragma once

#include <stdexcept>

namespace stickband_python {

/// The recording cannot tell; becomes stickband.DataCannotAnswer.
class CannotAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Takes InputError and ConfigError to BadInput, std::invalid_argument to WrongUsage,
/// CannotAnswer to DataCannotAnswer.
void translate_errors();

}  // namespace stickband_python
