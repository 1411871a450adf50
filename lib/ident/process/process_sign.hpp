// The sign of the process gain where the controller does not tell it.
#pragma once

#include <array>
#include <span>

#include "ident/process/process_regression.hpp"

namespace ident {

/// ±1: the sign with which a linear valve and a process with one pole explain more of y.
/// A guess only: where y moves u, the other way round may fit better.
///
/// Life: new → start → step until it is true → sign. Cost: twelve passes of
/// ProcessRegression::screen.
template <class Real>
class LikelierSign {
 public:
  /// u and y as ProcessRegression wants them; `period` of the oscillation in samples;
  /// `scratch` as long as y. All must outlive the work.
  void start(std::span<const Real> u, std::span<const Real> y, Real period,
             std::span<Real> scratch);
  /// A piece of a pass; true when all processes were tried.
  bool step();
  [[nodiscard]] int sign() const { return least_[0] < least_[1] ? -1 : 1; }

 private:
  static constexpr int kProcesses = 6;  // for each sign

  std::span<const Real> u_;
  std::span<const Real> y_;
  std::span<Real> turned_;
  Real period_ = 0;
  std::array<Real, 2> least_{};  // error of the best: −1, 1
  int next_ = 0;                 // process and sign
  bool screening_ = false;
  ProcessRegression<Real> regression_;
};

}  // namespace ident
