// The forms a valve can take, from linear to sticking differently on each stroke.
#pragma once

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
[[nodiscard]] int free_parameters(ValveForm form);

}  // namespace ident
