// The sizes that ship. Everything templated on a capacity is instantiated for these.
#pragma once

#include <cstddef>

namespace ident {

inline constexpr std::size_t kSmallWindow = 512;      ///< samples, small devices
inline constexpr std::size_t kStandardWindow = 2048;  ///< samples, the standard device
inline constexpr std::size_t kLargeWindow = 4096;     ///< samples, gateways and the host

}  // namespace ident
