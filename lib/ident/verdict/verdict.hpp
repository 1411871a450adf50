// What the component says about a valve: the verdict, its reason and its numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ident {

/// What a window of u and y says about the valve.
enum class Verdict : std::uint8_t {
  kStiction,    ///< sticks, then slips
  kBacklash,    ///< deadband without slip jump
  kNoStiction,  ///< the data show a valve that follows its signal
  kUndecided,   ///< the data cannot tell; the reason says what would help
  kBadData,     ///< the samples themselves cannot be used
};

/// Stiction or backlash.
[[nodiscard]] constexpr bool is_fault(Verdict verdict) {
  return verdict == Verdict::kStiction || verdict == Verdict::kBacklash;
}

/// The contract's name of a verdict, e.g. "no_stiction".
[[nodiscard]] constexpr std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, 5> kNames = {
      "stiction", "backlash", "no_stiction", "undecided", "bad_data"};
  return kNames[static_cast<std::size_t>(verdict)];
}

/// A number with its 95 % interval; meaningless unless `known`.
template <class Real>
struct Estimate {
  bool known = false;  ///< false: the data cannot tell, `value` is not to be shown
  Real value = 0;      ///< best value, in the unit of the quantity
  Real low = 0;        ///< lower end of the 95 % interval
  Real high = 0;       ///< upper end of the 95 % interval
};

/// One quantity for each stroke. `ascending`: the valve is about to move with
/// rising u; `descending`: with falling u.
template <class Real>
struct PerStroke {
  Estimate<Real> ascending;
  Estimate<Real> descending;

  [[nodiscard]] bool both_known() const { return ascending.known && descending.known; }
  /// The larger one of what is known; 0: nothing is.
  [[nodiscard]] Real larger() const {
    return std::max(ascending.known ? ascending.value : Real(0),
                    descending.known ? descending.value : Real(0));
  }
  /// Of what is known; 0: nothing is.
  [[nodiscard]] Real mean() const {
    return both_known() ? (ascending.value + descending.value) / Real(2) : larger();
  }
};

}  // namespace ident
