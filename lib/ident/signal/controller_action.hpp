// Which way the controller acts, and so which sign the process gain has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace ident {

/// What the controller does, seen from Δu against Δe and e, e = sp − y.
template <class Real>
struct ControllerAction {
  int sign = 0;  ///< of the process gain, as negative feedback needs it; 0 unknown
  Real proportional = 0;  ///< Δu for Δe, units of u per unit of y
  Real integral = 0;      ///< Δu per sample for e, units of u per unit of y
  Real r_squared = 0;     ///< share of Δu that the PI law explains, 0 … 1
};

/// Fits Δu(t) = Kc·Δe(t) + Ki·e(t) + c by least squares (M4). A valve and a process never
/// act on y within the sample, so this is the controller, not the plant, read from the
/// same data. Samples at the lowest or highest u are left out: there a controller that
/// saturates does not follow its law. `sign` is given only if the law explains nearly all
/// of Δu, or most of it and clearly more than the same law one sample later, and its two
/// parts do not disagree. `sp` may be empty (constant setpoint). Cost: six passes.
///
/// Life: start → step until true → action; or `controller_action`, all at once.
template <class Real>
class ControllerRecognition {
 public:
  /// Equal lengths; the spans must outlive the work.
  void start(std::span<const Real> u, std::span<const Real> y, std::span<const Real> sp);
  /// One or two passes; true when done.
  bool step();
  [[nodiscard]] const ControllerAction<Real>& action() const { return action_; }

 private:
  enum class Stage : std::uint8_t { kMeans, kSums, kDone };
  struct Law {
    Real proportional = 0;
    Real integral = 0;
    Real r_squared = 0;
    Real proportional_share = 0;  // of the variance of Δu
    Real integral_share = 0;
  };

  [[nodiscard]] Real error(std::size_t t) const {
    return (sp_.empty() ? Real(0) : sp_[t]) - y_[t];
  }
  // A controller at its limit does not follow its law.
  [[nodiscard]] bool moves(std::size_t t) const {
    return u_[t] > lowest_ && u_[t] < highest_;
  }
  bool find_means();
  [[nodiscard]] Law fit() const;
  void take(const Law& law);

  std::span<const Real> u_;
  std::span<const Real> y_;
  std::span<const Real> sp_;
  ControllerAction<Real> action_;
  Real lowest_ = 0;  // u between these moves
  Real highest_ = 0;
  Real mean_ = 0;  // of e, Δu and Δe
  Real move_ = 0;
  Real drift_ = 0;
  std::size_t lag_ = 0;  // samples by which the law is late
  int likely_ = 0;       // the sign, if the law fits worse a sample later
  Stage stage_ = Stage::kDone;
};

template <class Real>
[[nodiscard]] ControllerAction<Real> controller_action(std::span<const Real> u,
                                                       std::span<const Real> y,
                                                       std::span<const Real> sp);

}  // namespace ident
