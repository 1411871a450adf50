// What the residuals of two simulations say: how many of their samples count, and whether
// one simulation beats the other in every cycle.
#pragma once

#include <array>
#include <span>

namespace ident {

/// Independent samples in the residual y − simulated, at most all of them: what a valve
/// changes lies at the frequency of the oscillation, so the density of an AR(1) residual
/// there is what counts (E1). `period` in samples. Cost: one pass.
template <class Real>
[[nodiscard]] Real independent_observations(std::span<const Real> y,
                                            std::span<const Real> simulated, Real period);

/// How the gain of one model over another spreads over the window.
template <class Real>
struct CycleGain {
  int cycles = 0;        ///< stretches of about one period
  int better = 0;        ///< of those, with a smaller squared error
  Real consistency = 0;  ///< mean gain of a stretch over its standard error; 0: no spread
};

/// Compares two simulations of one window stretch by stretch, each about one period long:
/// a valve that is really there explains nearly every cycle better, not a lucky few.
/// Memory: 49 numbers.
template <class Real>
class CycleComparison {
 public:
  static constexpr int kFewest = 4;  ///< stretches, however long the period is
  static constexpr int kMost = 48;   ///< stretches, however short the period is

  /// `period` in samples, above 0.
  CycleComparison(std::span<const Real> y, Real period);
  /// One of the two models; `weight`: 1 for the one to beat, −1 for the one that may be
  /// better. Cost: one pass.
  void add(std::span<const Real> simulated, Real weight);
  /// Meaningful once each was added.
  [[nodiscard]] CycleGain<Real> gain() const;

 private:
  std::span<const Real> y_;
  int count_;
  std::array<Real, kMost> gains_{};  // Σ e² of the reference less that of the candidate
};

}  // namespace ident
