// From a window of u and y to a verdict: the identifier with memory of its own.
//
// Life: new → start(window) → step(budget) until done → result and simulations.
#pragma once

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
             int gain_sign = 0, const WindowOptions& options = {});
  /// `start`, and `step` until done.
  const Identification<Real>& run(std::span<const Real> u, std::span<const Real> y,
                                  std::span<const Real> sp, int gain_sign = 0);

 private:
  std::array<Real, Capacity> u_;
  std::array<Real, Capacity> y_;
};

}  // namespace ident
