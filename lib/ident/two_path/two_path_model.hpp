// The paper's extended Hammerstein model: an ARX process behind a two-path valve.
#pragma once

#include <array>

#include "ident/base/limits.hpp"

namespace ident {

/// The linear process, equation (1): a_i on past outputs, b_j on x(t − n_k − j).
template <class Real>
struct Process {
  int na = 1;  ///< output lags, 1 … kMaxNa
  int nb = 1;  ///< input lags, 1 … kMaxNb
  int nk = 0;  ///< dead time beyond one sample, samples, 0 … kMaxNk
  std::array<Real, kMaxNa> a{};
  std::array<Real, kMaxNb> b{};
  Real d = 0;  ///< constant input, in units of y
};

/// One path of the valve, equation (2): x at `segments` + 1 rising knots of u,
/// straight between them and constant outside.
template <class Real>
struct Path {
  int segments = 1;  ///< 1 … kMaxSegments
  std::array<Real, kMaxKnots> knots{};
  std::array<Real, kMaxKnots> x{};

  /// x at u. Cost: one search over the knots.
  [[nodiscard]] Real at(Real u) const {
    if (u <= knots[0]) {
      return x[0];
    }
    for (int i = 0; i < segments; ++i) {
      if (u < knots[i + 1]) {
        return x[i] + (x[i + 1] - x[i]) * (u - knots[i]) / (knots[i + 1] - knots[i]);
      }
    }
    return x[segments];
  }
};

/// Process and valve together. The gauge: x_D at the first knot is 0 and ‖b‖ = 1
/// with Σb > 0, equation (6); a negative process gain is carried by the sign of y.
template <class Real>
struct TwoPathModel {
  Process<Real> process;
  Path<Real> ascending;
  Path<Real> descending;
};

/// True when every root of 1 + a_1 z⁻¹ + … lies inside the unit circle by at least
/// `margin` (step-down recursion, Schur–Cohn). Cost: na² operations.
template <class Real>
[[nodiscard]] bool is_stable(const Process<Real>& process, Real margin = Real(1e-6));

}  // namespace ident
