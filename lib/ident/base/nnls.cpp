#include "ident/base/nnls.hpp"

#include <cmath>
#include <limits>

#include "ident/base/limits.hpp"

namespace ident {
namespace {

constexpr UnknownSet bit(Eigen::Index i) {
  return UnknownSet{1} << i;
}

}  // namespace

template <class Real, int Most>
void NonNegativeLeastSquares<Real, Most>::solve_passive(const Matrix& q,
                                                        const Vector& c) {
  const Eigen::Index n = q.rows();
  const Real tolerance = Real(16) * std::numeric_limits<Real>::epsilon();
  trial_.setZero(n);
  // Cholesky rows of the passive unknowns, free ones first: of dependent columns it is
  // a constrained one that leaves the set, never a free one.
  Eigen::Index count = 0;
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    const Eigen::Index i = k < n ? k : k - n;
    const bool constrained = (constrained_ & bit(i)) != 0;
    if (!(passive_ & bit(i)) || constrained != (k >= n)) {
      continue;
    }
    Real pivot = q(i, i);
    Real rhs = c(i);
    Real* const mine = row_of(count);
    for (Eigen::Index row = 0; row < count; ++row) {
      const Eigen::Index j = order_[row];
      const Real* const other = row_of(row);
      Real sum = q(i, j);
      for (Eigen::Index column = 0; column < row; ++column) {
        sum -= mine[column] * other[column];
      }
      mine[row] = sum / other[row];
      pivot -= mine[row] * mine[row];
      rhs -= mine[row] * trial_(j);
    }
    if (!(pivot > tolerance * q(i, i)) || !(q(i, i) > Real(0))) {
      passive_ &= ~bit(i);
      continue;
    }
    mine[count] = std::sqrt(pivot);
    trial_(i) = rhs / mine[count];
    order_[count++] = static_cast<std::uint8_t>(i);
  }
  for (Eigen::Index row = count - 1; row >= 0; --row) {
    const Real* const mine = row_of(row);
    Real& value = trial_(order_[row]);
    value /= mine[row];
    for (Eigen::Index column = 0; column < row; ++column) {
      trial_(order_[column]) -= mine[column] * value;
    }
  }
}

template <class Real, int Most>
bool NonNegativeLeastSquares<Real, Most>::descend(Vector& z) {
  const Eigen::Index n = z.size();
  Real fraction = 1;
  Eigen::Index blocking = -1;
  for (Eigen::Index i = 0; i < n; ++i) {
    if ((constrained_ & passive_ & bit(i)) && trial_(i) < Real(0)) {
      const Real reach = z(i) / (z(i) - trial_(i));
      if (reach < fraction || blocking < 0) {
        fraction = reach < fraction ? reach : fraction;
        blocking = i;
      }
    }
  }
  if (blocking < 0) {
    z = trial_;
    return true;
  }
  z += fraction * (trial_ - z);
  for (Eigen::Index i = 0; i < n; ++i) {
    const bool at_bound = (constrained_ & passive_ & bit(i)) &&
                          (i == blocking || (i != entering_ && z(i) <= Real(0)));
    if (at_bound) {
      passive_ &= ~bit(i);
      z(i) = Real(0);
    }
  }
  return false;
}

template <class Real, int Most>
bool NonNegativeLeastSquares<Real, Most>::choose_entering(const Matrix& q,
                                                          const Vector& c,
                                                          const Vector& z) {
  const Eigen::Index n = q.rows();
  gradient_.noalias() = c;
  for (Eigen::Index j = 0; j < n; ++j) {
    gradient_ -= q.col(j) * z(j);
  }
  entering_ = -1;
  Real best_gain = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!(constrained_ & bit(i)) || (passive_ & bit(i)) || (refused_ & bit(i))) {
      continue;
    }
    // Gain in the units of the cost, so that scaling a column changes nothing.
    Real size = std::abs(c(i));
    for (Eigen::Index j = 0; j < n; ++j) {
      size += std::abs(q(i, j) * z(j));
    }
    const Real noise = Real(64) * std::numeric_limits<Real>::epsilon() * size;
    if (gradient_(i) > noise && q(i, i) > Real(0)) {
      const Real gain = gradient_(i) * gradient_(i) / q(i, i);
      if (gain > best_gain) {
        best_gain = gain;
        entering_ = i;
      }
    }
  }
  return entering_ >= 0;
}

template <class Real, int Most>
bool NonNegativeLeastSquares<Real, Most>::solve(const Matrix& q, const Vector& c,
                                                UnknownSet constrained, Vector& z) {
  z.setZero(q.rows());
  start(q, c, constrained, z);
  while (!step()) {
  }
  return optimal_;
}

template <class Real, int Most>
void NonNegativeLeastSquares<Real, Most>::start(const Matrix& q, const Vector& c,
                                                UnknownSet constrained, Vector& z) {
  const Eigen::Index n = q.rows();
  q_ = &q;
  c_ = &c;
  z_ = &z;
  constrained_ = constrained;
  passive_ = n == 64 ? ~UnknownSet{0} : bit(n) - 1;
  for (Eigen::Index i = 0; i < n; ++i) {
    if ((constrained & bit(i)) && !(z(i) > Real(0))) {
      passive_ &= ~bit(i);
      z(i) = Real(0);
    }
  }
  refused_ = 0;
  entering_ = -1;
  entered_ = blocked_ = 0;
  new_ = chooses_ = optimal_ = false;
}

template <class Real, int Most>
bool NonNegativeLeastSquares<Real, Most>::step() {
  const int n = static_cast<int>(q_->rows());
  const int step_bound = 3 * n + 10;
  if (chooses_) {
    chooses_ = false;
    optimal_ = !choose_entering(*q_, *c_, *z_);
    if (optimal_) {
      return true;
    }
    ++entered_;
    blocked_ = 0;
    new_ = true;
    passive_ |= bit(entering_);
    return false;
  }
  solve_passive(*q_, *c_);
  if (new_) {
    new_ = false;
    if (!(passive_ & bit(entering_)) || trial_(entering_) <= Real(0)) {
      passive_ &= ~bit(entering_);
      refused_ |= bit(entering_);
      return false;
    }
  }
  if (!descend(*z_) && ++blocked_ <= n) {
    return false;
  }
  chooses_ = true;
  return entered_ == step_bound;
}

template <class Real, int Most>
int NonNegativeLeastSquares<Real, Most>::cost_of_step() const {
  const int n = static_cast<int>(q_->rows());
  return n * n * (chooses_ ? 24 : n + 10) / 1000 + 4;
}

template class NonNegativeLeastSquares<float, kMaxUnknowns>;
template class NonNegativeLeastSquares<double, kMaxUnknowns>;
template class NonNegativeLeastSquares<float, kMaxHats>;
template class NonNegativeLeastSquares<double, kMaxHats>;

}  // namespace ident
