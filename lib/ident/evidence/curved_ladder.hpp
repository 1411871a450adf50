// Whether a stem foretells y where a bent characteristic and the setpoint are known, too.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "ident/evidence/band_ladder.hpp"
#include "ident/evidence/stem_passes.hpp"
#include "ident/valve/stick_slip_valve.hpp"

namespace ident {

/// The valve that was fitted running free.
template <class Real>
struct FittedStem {
  StickSlipValve<Real> valve{{}, Real(0)};  ///< as it stands before the first sample
  Real band = 0;                            ///< its wider stick band, unit of u
  int parameters = 0;                       ///< free ones; 0: nothing sticks
};

/// (E23) Nats by which predicting y one sample ahead (E10) is better from a stem than
/// from u where the lags of their squares stand beside both, and once more where those of
/// the setpoint do, too. In a few turns of u a stem does what a bent characteristic does,
/// or a controller that has just been given another setpoint; beside these it does not.
/// (E24) And nats by which the lags of the square help u itself.
///
/// Life: `start`, then `step` until it says true: u and the stems of the ladder (E11)
/// between a twenty-fifth and five quarters of the swing, one that sticks again after
/// each slip at every rung, and the fitted one, whose strokes may differ, by coarse lags;
/// then all of them again where the setpoint moves. Cost: a pass of two times 12 bins for
/// each of some 70 stems, or twice as many; some kUnit thousand instructions a piece.
template <class Real>
class CurvedLadder {
 public:
  /// `setpoint`: one that moves, as long as u, in any unit; or empty.
  void start(const EvidenceWindow<Real>& window, std::span<const Real> setpoint,
             const FittedStem<Real>& fitted);
  /// Some pieces, `budget` units; true when done.
  bool step(int budget);
  /// False where the window is too short.
  [[nodiscard]] bool known() const { return known_; }
  /// Of the best stem after the cost of its parameters, two of a rung, when done: the
  /// smaller number of both.
  [[nodiscard]] Real nats() const { return smaller(&Best::nats); }
  /// Of the characteristic, after the cost of all of its lags; likewise.
  [[nodiscard]] Real curve_nats() const { return smaller(&Best::curve_nats); }
  /// The narrower and the wider stick band of the best stems, unit of u.
  [[nodiscard]] Real narrower_band() const { return smaller(&Best::band); }
  [[nodiscard]] Real wider_band() const { return std::max(best_[0].band, best_[1].band); }

 private:
  static constexpr int kKinds = kSlips + 1;  // at each rung
  struct Best {
    Real nats = std::numeric_limits<Real>::lowest();
    Real band = 0;
    Real curve_nats = 0;
  };

  bool begin(PassOf of_u);
  void take_u();
  [[nodiscard]] Real smaller(Real Best::*number) const {
    return beside_ ? std::min(best_[0].*number, best_[1].*number) : best_[0].*number;
  }
  void take_nats();
  void try_next();
  [[nodiscard]] StickSlipValve<Real> valve() const;
  [[nodiscard]] Real band() const;

  StemPasses<Real> passes_;
  std::span<const Real> setpoint_;  // empty: none that moves
  FittedStem<Real> fitted_;
  StickSlipValve<Real> valve_{{}, Real(0)};
  int first_ = 0;  // of the ladder's
  int last_ = 0;   // behind these: the fitted one
  int tried_ = 0;
  std::array<Best, 2> best_{};
  Real error_of_u_ = 0;  // without its square
  bool bent_ = false;    // with it
  bool beside_ = false;  // the setpoint
  bool known_ = false;
  bool done_ = true;
};

}  // namespace ident
