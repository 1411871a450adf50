// The forms a valve can take, from linear to sticking differently on each stroke.
#pragma once

#include <array>
#include <cstddef>

namespace ident {

/// Nested forms of the valve, simplest first.
enum class ValveForm : unsigned char {
  kLinear,      ///< no free parameter
  kBacklash,    ///< deadband only
  kAscending,   ///< sticks with rising u only
  kDescending,  ///< sticks with falling u only
  kSymmetric,   ///< deadband and one slip jump
  kMixed,       ///< deadband and a slip jump for each stroke
};
inline constexpr int kValveForms = 6;

/// Free valve parameters of a form: 0 … 3.
[[nodiscard]] constexpr int free_parameters(ValveForm form) {
  constexpr std::array<int, kValveForms> kFree = {0, 1, 1, 1, 2, 3};
  return kFree[static_cast<std::size_t>(form)];
}

}  // namespace ident
