// Refinement on the simulation error: what least squares leaves biased.
#pragma once

#include <array>
#include <span>

#include "ident/lagged_gram.hpp"
#include "ident/nnls.hpp"
#include "ident/two_path_model.hpp"

namespace ident {

/// What the process remembered before the first sample, as additions to the first
/// na outputs; zero: at rest.
template <class Real>
using InitialState = std::array<Real, kMaxNa>;

/// Minimises the squared error of the free simulation over the process, the initial
/// state and, if asked, both valve paths, by Levenberg–Marquardt steps in which the
/// slopes stay non-negative. The equation-error estimate of the iteration is biased
/// when noise enters at y, as it does in a real loop; this one is not.
///
/// Only stable processes are accepted, so the result is never worse than the start
/// and never unstable. Cost of one step: one pass with n(n+1)/2 + n·na
/// multiplications a sample, n the number of unknowns, at most
/// na + nb + na + 2 + 2·kMaxSegments; at most `max_steps` passes and as many plain
/// simulations again.
template <class Real>
class OutputErrorFit {
 public:
  /// What is estimated beside the process and its initial state.
  enum class Valve : unsigned char {
    kPaths,  ///< both paths of the model, at their knots
    kFixed,  ///< nothing: x is given
  };

  /// Refines `model` and `initial` on the window. With Valve::kFixed the valve
  /// position is `x` (length N) and the model's paths are not touched. `scratch` has
  /// length N and holds the simulated output afterwards. `damping` carries over from one
  /// call to the next; it is above kWorstDamping when nothing more is to be gained.
  /// Returns Σ(y − ŷ)².
  Real refine(const WindowView<Real>& window, Valve valve, std::span<const Real> x,
              int max_steps, TwoPathModel<Real>& model, InitialState<Real>& initial,
              Real& damping, std::span<Real> scratch);
  static constexpr Real kFirstDamping = Real(1e-3);
  static constexpr Real kWorstDamping = Real(1e6);

  /// Σ(y − ŷ)² of a free simulation, ŷ left in `simulated`.
  static Real simulate(const WindowView<Real>& window, Valve valve,
                       std::span<const Real> x, const TwoPathModel<Real>& model,
                       const InitialState<Real>& initial, std::span<Real> simulated);

 private:
  void normal_equations(const WindowView<Real>& window, Valve valve,
                        std::span<const Real> x, const TwoPathModel<Real>& model,
                        std::span<const Real> simulated);
  void read(const TwoPathModel<Real>& model, const InitialState<Real>& initial,
            Valve valve);
  void write(TwoPathModel<Real>& model, InitialState<Real>& initial, Valve valve) const;

  static constexpr int kRows = 4;  // added to the sums together
  static constexpr int kRing = 8;  // a power of two > kMaxNa

  void add_rows();

  NonNegativeLeastSquares<Real> nnls_;
  // Sensitivities of ŷ to the unknowns, and y − ŷ, at kRows samples.
  std::array<std::array<Real, kMaxUnknowns>, kRows> rows_;
  std::array<Real, kRows> errors_;
  // Of the hats through 1/A, the last samples.
  std::array<std::array<Real, kMaxHats>, kRing> of_hat_;
  Square<Real> hessian_;
  Column<Real> diagonal_;  // of the Hessian, while its own is damped
  Column<Real> gradient_;
  Column<Real> now_;
  Column<Real> next_;
  Column<Real> rhs_;
};

}  // namespace ident
