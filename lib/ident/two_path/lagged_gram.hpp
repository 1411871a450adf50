// All sums that the identification needs, from one pass over the data.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>

#include "ident/base/limits.hpp"
#include "ident/base/nnls.hpp"
#include "ident/two_path/two_path_model.hpp"

namespace ident {

/// Sums over hats, ascending path first.
template <class Real>
using HatSquare = Square<Real, kMaxHats>;
template <class Real>
using HatColumn = Column<Real, kMaxHats>;

/// The two hat functions (M5) that are not zero at one sample: x(t) is the weighted mean
/// of the path's value at two neighbouring knots.
template <class Real>
struct HatPair {
  int first = 0;   ///< index of the lower knot's hat; the upper one is first + 1
  Real upper = 0;  ///< weight of the upper knot, 0 … 1
};

/// The hats at work for u on one path, whose first hat has the number `offset`. Cost: one
/// search.
template <class Real>
[[nodiscard]] HatPair<Real> hats_at(const Path<Real>& path, int offset, Real u);

/// The knots of both paths; the x of a Path are not used here.
template <class Real>
struct KnotGrid {
  Path<Real> ascending;
  Path<Real> descending;

  /// Hats of both paths together.
  [[nodiscard]] int hats() const { return ascending.segments + descending.segments + 2; }
  /// The hats at work for u in the given direction. Cost: one search.
  [[nodiscard]] HatPair<Real> at(Real u, bool is_ascending) const;
};

/// Samples of one window, oldest first. All spans have the same length N.
template <class Real>
struct WindowView {
  std::span<const Real> u;
  std::span<const Real> y;
  std::span<const unsigned char> ascending;
};

/// Lagged sums of products of y and of the valve's basis (M6).
///
/// The paths are written with hat functions (the values of x at the knots), of which
/// at most two are not zero at a time; the paper's slopes g are the differences of
/// those values. Sums depend on the difference of the lags but for a few samples at
/// the ends, which are added and taken away exactly. So one pass, 4·kMaxNb + about 60
/// multiplications a sample, serves every (na, nb, nk) and, for knots that are subsets
/// of these, every number of knots. All sums run over t = kFirst … N − 1.
/// Memory: kMaxNb·26² + 20·26 + 50 numbers and the hats at work in the 2·kFirst samples
/// at the ends.
template <class Real>
class LaggedGram {
 public:
  /// First sample that is predicted, the same for every structure.
  static constexpr int kFirst = kMaxNk + kMaxNb > kMaxNa ? kMaxNk + kMaxNb : kMaxNa;

  /// The pass: `start`, then `step` until it returns true, at most `samples` ≥ 1 samples
  /// each. The spans must outlive the object's use; N > kFirst.
  void start(const KnotGrid<Real>& grid, const WindowView<Real>& window);
  bool step(int samples);

  /// Samples predicted: N − kFirst.
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] const KnotGrid<Real>& grid() const { return grid_; }

  /// Σ y(t−i)·y(t−j), 0 ≤ i, j ≤ kMaxNa.
  [[nodiscard]] Real yy(int i, int j) const { return i < j ? yy_[j][i] : yy_[i][j]; }
  /// Σ y(t−i).
  [[nodiscard]] Real y_sum(int i) const { return y_sum_[i]; }
  /// out += weight · Σ y(t−i)·H(t−p), with 0 ≤ i ≤ kMaxNa and 1 ≤ p ≤ kFirst.
  void add_y_hats(int i, int p, Real weight, HatColumn<Real>& out) const;
  /// out += weight · Σ H(t−p).
  void add_hat_sum(int p, Real weight, HatColumn<Real>& out) const;
  /// out = Σ_ij b_i·b_j·H(t−nk−i)·H(t−nk−j)ᵀ, i, j = 1 … nb; `out` has its size.
  void filtered(int nk, int nb, const std::array<Real, kMaxNb>& b,
                HatSquare<Real>& out) const;
  /// Σ x(t−p)·x(t−q) for x given by its values at the hats.
  [[nodiscard]] Real xx(int p, int q, const HatColumn<Real>& x) const;

 private:
  static constexpr int kLeads = kMaxNa - 1;  // y(t−i) may be older than x(t−p)
  using Hats = Eigen::Matrix<Real, kMaxHats, 1>;
  using Block = Eigen::Matrix<Real, kMaxHats, kMaxHats>;

  // The hats at work at sample t, one of the first or last kFirst.
  [[nodiscard]] const HatPair<Real>& pair_at(std::ptrdiff_t t) const {
    return t < kFirst ? head_[t] : tail_[t - rows_];
  }
  template <class Remove>
  void at_ends(std::ptrdiff_t first, int p, const Remove& remove) const;
  void add(std::ptrdiff_t s);
  void add_outputs(std::ptrdiff_t t);

  [[nodiscard]] static Real x_at(const HatPair<Real>& pair, const HatColumn<Real>& x) {
    return x(pair.first) + (x(pair.first + 1) - x(pair.first)) * pair.upper;
  }

  KnotGrid<Real> grid_;
  WindowView<Real> window_;
  int rows_ = 0;
  std::ptrdiff_t next_ = 0;                 // sample that is added next
  std::array<HatPair<Real>, kMaxNb> past_;  // past_[τ] is the pair of the sample τ before
  std::array<HatPair<Real>, kFirst> head_;
  std::array<HatPair<Real>, kFirst> tail_;
  std::array<Block, kMaxNb> hat_hat_;            // Σ_s H(s)·H(s−τ)ᵀ, all s
  std::array<Hats, kFirst + kLeads + 1> y_hat_;  // Σ_s y(s+L)·H(s), L = −kLeads …
  Hats hat_sum_;
  std::array<std::array<Real, kMaxNa + 1>, kMaxNa + 1> yy_;  // lower triangle
  std::array<Real, kMaxNa + 1> y_sum_;
};

}  // namespace ident
