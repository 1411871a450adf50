// A turn, to 15 digits: one more would change the last bits of answers in double.
#pragma once

namespace ident {

inline constexpr double kTwoPi = 6.28318530717959;

}  // namespace ident
