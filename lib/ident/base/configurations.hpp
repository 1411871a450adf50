// The sizes that ship. Everything templated on a capacity is instantiated for these.
#pragma once

#include <cstddef>

#include "ident/base/limits.hpp"

namespace ident {

/// Samples, small devices.
inline constexpr std::size_t kSmallWindow = kLeastSizes ? 384 : 512;
inline constexpr std::size_t kStandardWindow = 2048;  ///< samples, the standard device
inline constexpr std::size_t kLargeWindow = 4096;     ///< samples, gateways and the host

/// One unit of a budget of work, thousands of instructions of a Cortex-M4F. What the
/// pieces take is counted on the emulated board (docs/memory.md).
inline constexpr int kUnit = 100;

}  // namespace ident
