// Least squares on the normal equations with some unknowns held non-negative.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "ident/base/limits.hpp"

namespace ident {

/// A symmetric matrix and a vector of at most `Most` rows: storage is fixed, no heap.
template <class Real, int Most = kMaxUnknowns>
using Square =
    Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, Most, Most>;
template <class Real, int Most = kMaxUnknowns>
using Column = Eigen::Matrix<Real, Eigen::Dynamic, 1, Eigen::ColMajor, Most, 1>;

/// One bit for each unknown.
using UnknownSet = std::uint64_t;

/// Non-negative least squares: minimises ½·zᵀ·Q·z − cᵀ·z subject to z_i ≥ 0 for
/// every i in `constrained`; the other unknowns are free (Lawson and Hanson,
/// Solving Least Squares Problems, 1974, chapter 23, on the normal equations).
///
/// Q must be symmetric and positive semidefinite. A column that adds nothing
/// new to the ones already chosen (relative pivot below machine precision) is
/// left at zero instead of being divided by. One object holds its own scratch,
/// about n²/2 numbers with n = Most, so that nothing large lies on the stack. At most
/// 3·n + 10 outer steps of one Cholesky factorisation (n³/6) each.
///
/// Shipped for the double and float of each `Most` that this library uses.
template <class Real, int Most = kMaxUnknowns>
class NonNegativeLeastSquares {
 public:
  using Matrix = Square<Real, Most>;
  using Vector = Column<Real, Most>;

  /// Solves for z (size n = Q.rows() ≤ Most). Returns false when the
  /// bound on the steps was met; z is then feasible but may not be optimal.
  bool solve(const Matrix& q, const Vector& c, UnknownSet constrained, Vector& z);

  /// The same in pieces, `start`, then `step` until it is true, and from a feasible z of
  /// size n: which of the constrained unknowns are positive there is the first guess of
  /// which will be. The answer of a problem much like this one saves most of the steps.
  /// All four must outlive the work.
  void start(const Matrix& q, const Vector& c, UnknownSet constrained, Vector& z);
  /// One factorisation, or the choice of what to try next; true when done.
  bool step();
  /// Of one step, thousands of instructions of a Cortex-M4F, most.
  [[nodiscard]] int cost_of_step() const;

 private:
  // From z towards the trial, as far as the bounds allow: there what blocks is taken out
  // of the passive set. True when nothing blocked.
  bool descend(Vector& z);
  // The unknown that gains most by leaving its bound; false when none does.
  bool choose_entering(const Matrix& q, const Vector& c, const Vector& z);
  // Solves the equality problem on the passive set; dependent columns get 0.
  void solve_passive(const Matrix& q, const Vector& c);
  // Row of the factor, its first element.
  [[nodiscard]] Real* row_of(Eigen::Index row) {
    return &factor_[static_cast<std::size_t>(row * (row + 1) / 2)];
  }

  std::array<Real, Most*(Most + 1) / 2> factor_;  // lower triangle, row by row
  Vector trial_;
  Vector gradient_;
  std::array<std::uint8_t, Most> order_;
  UnknownSet constrained_ = 0;
  UnknownSet passive_ = 0;
  UnknownSet refused_ = 0;      // found dependent on the passive ones: not tried again
  Eigen::Index entering_ = -1;  // the unknown that is about to leave its bound
  const Matrix* q_ = nullptr;
  const Vector* c_ = nullptr;
  Vector* z_ = nullptr;
  int entered_ = 0;       // unknowns that left their bound
  int blocked_ = 0;       // times that something blocked the present descent
  bool new_ = false;      // the entering one is in the passive set for the first time
  bool chooses_ = false;  // next
  bool optimal_ = false;
};

}  // namespace ident
