// Least squares on the normal equations with some unknowns held non-negative.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace ident {

/// Most unknowns of one least-squares problem in this library.
inline constexpr int kMaxUnknowns = 40;

/// A symmetric matrix and a vector of bounded size: storage is fixed, no heap.
template <class Real>
using Square = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                             kMaxUnknowns, kMaxUnknowns>;
template <class Real>
using Column = Eigen::Matrix<Real, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxUnknowns, 1>;

/// One bit for each unknown.
using UnknownSet = std::uint64_t;

/// Non-negative least squares: minimises ½·zᵀ·Q·z − cᵀ·z subject to z_i ≥ 0 for
/// every i in `constrained`; the other unknowns are free (Lawson and Hanson,
/// Solving Least Squares Problems, 1974, chapter 23, on the normal equations).
///
/// Q must be symmetric and positive semidefinite. A column that adds nothing
/// new to the ones already chosen (relative pivot below machine precision) is
/// left at zero instead of being divided by. One object holds its own scratch,
/// about 3·n² numbers, so that nothing large lies on the stack. At most
/// 3·n + 10 outer steps of one Cholesky factorisation (n³/6) each.
template <class Real>
class NonNegativeLeastSquares {
 public:
  /// Solves for z (size n = Q.rows() ≤ kMaxUnknowns). Returns false when the
  /// bound on the steps was met; z is then feasible but may not be optimal.
  bool solve(const Square<Real>& q, const Column<Real>& c, UnknownSet constrained,
             Column<Real>& z);

 private:
  // Solves the equality problem on the passive set; dependent columns get 0.
  void solve_passive(const Square<Real>& q, const Column<Real>& c);

  Square<Real> factor_;
  Column<Real> trial_;
  Column<Real> gradient_;
  std::array<std::uint8_t, kMaxUnknowns> order_;
  UnknownSet constrained_ = 0;
  UnknownSet passive_ = 0;
};

}  // namespace ident
