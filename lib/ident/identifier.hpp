// From a window of u and y to a verdict: the identifier with memory of its own.
//
// Life: new → start(window) → step(budget) until done → result and simulations. An object
// serves any number of windows, one after the other.
//
//   ident::Identifier<double, ident::kLargeWindow> identifier;
//   const auto& found = identifier.run(u, y, {});   // found.verdict, found.reason
//
// Cost. A window of 2,048 samples takes some 3·10⁴ units of 100,000 instructions of a
// Cortex-M4F, on a desk a few tenths of a second at most; `step(budget)` ends about a
// unit after its budget at most. The answer does not depend on the budgets.
//
// Memory, KiB, all of it in the object but the stack: float 512: 32.1, float 2048: 51.6,
// double 2048: 100.2, double 4096: 150.2. On a desk it belongs on the heap.
//
// One thread for each object; objects know nothing of each other. No heap, exceptions,
// RTTI, OS or clock.
//
// Failures. Any samples are accepted: a window that cannot be identified, or has a value
// of u or y that is not finite, is Verdict::kUndecided or kBadData, and
// `sentence(found.reason)` says why (verdict/identification.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "ident/in_place_identifier.hpp"

namespace ident {

/// InPlaceIdentifier on a copy: the window stays as it is, and the simulations can be
/// asked for at any time after `done`. At most `Capacity` samples.
template <class Real, std::size_t Capacity>
class Identifier : public InPlaceIdentifier<Real, Capacity> {
 public:
  /// As InPlaceIdentifier::start, but u and y are copied; `sp` must stay as it is until
  /// `done`.
  void start(std::span<const Real> u, std::span<const Real> y, std::span<const Real> sp,
             int gain_sign = 0, const WindowOptions& options = {}) {
    const std::size_t count = std::min({u.size(), y.size(), Capacity});
    std::copy_n(u.begin(), count, u_.begin());
    std::copy_n(y.begin(), count, y_.begin());
    InPlaceIdentifier<Real, Capacity>::start({u_.data(), count}, {y_.data(), count}, sp,
                                             gain_sign, options);
  }
  /// `start`, and `step` until done.
  const Identification<Real>& run(std::span<const Real> u, std::span<const Real> y,
                                  std::span<const Real> sp, int gain_sign = 0) {
    start(u, y, sp, gain_sign);
    while (!this->step(kLargeBudget)) {
    }
    return this->result();
  }

 private:
  std::array<Real, Capacity> u_;
  std::array<Real, Capacity> y_;
};

}  // namespace ident
