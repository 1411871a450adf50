// Whether y is foretold by a stem that does not stick but is bounded: in its speed, or in
// its travel.
#pragma once

#include <cstdint>

#include "ident/evidence/stem_passes.hpp"

namespace ident {

/// How a stem falls behind u without sticking.
enum class Bound : std::uint8_t {
  kSpeed,   ///< it moves no faster than a limit
  kTravel,  ///< it stops at an end, or at both
};

/// (E19) Nats by which predicting y one sample ahead (E10) is better from a stem of
/// limited speed, or from one that stops at an end, than from u. Such a stem lags or
/// rests as one that sticks does; the valve that moves it has little air, a small motor,
/// or a stroke that ends where u goes on.
///
/// Life: `start`, then `step` until it says true: ten speeds and 35 pairs of ends by
/// coarse lags; then, as for a stem that sticks, u and the best of them by fine ones, by
/// which what it says in one place is left out (E14), and of both numbers of nats the
/// smaller. Cost: a pass of 12 bins for each, two of 19; some kUnit thousand instructions
/// a piece.
template <class Real>
class BoundedStem {
 public:
  void start(const EvidenceWindow<Real>& window);
  /// Some pieces, `budget` units; true when done.
  bool step(int budget);
  /// Of the best, after the cost of two parameters, when done; 0 where the window is too
  /// short or none is better than u.
  [[nodiscard]] Real nats() const { return nats_; }
  /// What bounds it.
  [[nodiscard]] Bound bound() const {
    return best_ > kSpeeds ? Bound::kTravel : Bound::kSpeed;
  }

 private:
  static constexpr int kSpeeds = 10;  // stems 1 … kSpeeds; behind them those with ends

  void lay(int stem);
  void bound_by(int stem);
  [[nodiscard]] Real moved(Real x, Real u) const;
  void take_nats();
  void take_coarse(Real nats);
  void take_parts();

  StemPasses<Real> passes_;
  int tried_ = 0;  // 0: u itself
  int best_ = 0;
  bool confirming_ = false;  // by fine lags
  Real position_ = 0;        // of the stem that is laid
  Real speed_ = 0;           // unit of u a sample; 0: any
  Real low_ = 0;             // its ends
  Real high_ = 0;
  Real fine_ = 0;  // nats of the best by fine lags
  Real nats_ = 0;
  bool done_ = true;
};

}  // namespace ident
