#include "ident/gap/gap_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ident {
namespace {

template <class Real>
using Vector = typename GapFit<Real>::Row;
template <class Real>
using Matrix = std::array<Vector<Real>, GapFit<Real>::kUnknowns>;

template <class Real>
struct Problem {
  Matrix<Real> q;
  Vector<Real> c;
  Real energy;  // of the residual
};

template <class Real, class Sums>
Problem<Real> unpacked(const Sums& sums) {
  constexpr int kUnknowns = GapFit<Real>::kUnknowns;
  Problem<Real> out{};
  std::size_t at = 0;
  for (int i = 0; i < kUnknowns; ++i) {
    for (int j = 0; j <= i; ++j, ++at) {
      out.q[i][j] = out.q[j][i] = sums[at];
    }
  }
  for (int j = 0; j < kUnknowns; ++j, ++at) {
    out.c[j] = sums[at];
  }
  out.energy = sums[at];
  return out;
}

// Least squares by a Cholesky factor; columns that the ones before explain get 0.
template <class Real>
Vector<Real> solve(const Problem<Real>& problem, int count) {
  constexpr Real kTolerance = Real(1e-5);
  Matrix<Real> factor{};
  Vector<Real> z{};
  for (int i = 0; i < count; ++i) {
    Real pivot = problem.q[i][i];
    Real rhs = problem.c[i];
    for (int j = 0; j < i; ++j) {
      Real sum = problem.q[i][j];
      for (int k = 0; k < j; ++k) {
        sum -= factor[i][k] * factor[j][k];
      }
      factor[i][j] = factor[j][j] > Real(0) ? sum / factor[j][j] : Real(0);
      pivot -= factor[i][j] * factor[i][j];
      rhs -= factor[i][j] * z[j];
    }
    factor[i][i] = pivot > kTolerance * problem.q[i][i] ? std::sqrt(pivot) : Real(0);
    z[i] = factor[i][i] > Real(0) ? rhs / factor[i][i] : Real(0);
  }
  for (int i = count - 1; i >= 0; --i) {
    for (int j = i + 1; j < count; ++j) {
      z[i] -= factor[i][i] > Real(0) ? factor[j][i] * z[j] : Real(0);
    }
    z[i] = factor[i][i] > Real(0) ? z[i] / factor[i][i] : Real(0);
  }
  return z;
}

// Σ e² that is left with these weights.
template <class Real>
Real error_with(const Vector<Real>& z, const Problem<Real>& problem) {
  Real sum = problem.energy;
  for (int i = 0; i < GapFit<Real>::kUnknowns; ++i) {
    sum -= Real(2) * z[i] * problem.c[i];
    for (int j = 0; j < GapFit<Real>::kUnknowns; ++j) {
      sum += z[i] * problem.q[i][j] * z[j];
    }
  }
  return sum;
}

}  // namespace

template <class Real>
void GapFit<Real>::add(int fold, const Row& row, Real e) {
  Sums& sums = folds_[static_cast<std::size_t>(fold)];
  std::size_t at = 0;
  for (int i = 0; i < kUnknowns; ++i) {
    for (int j = 0; j <= i; ++j, ++at) {
      sums[at] += row[i] * row[j];
    }
  }
  for (int j = 0; j < kUnknowns; ++j, ++at) {
    sums[at] += row[j] * e;
  }
  sums[at] += e * e;
}

template <class Real>
Real GapFit<Real>::share(int columns) const {
  const Problem<Real> one = unpacked<Real>(folds_[0]);
  const Problem<Real> other = unpacked<Real>(folds_[1]);
  const auto left = [&](int count) {
    return error_with<Real>(solve<Real>(other, count), one) +
           error_with<Real>(solve<Real>(one, count), other);
  };
  const Real plain = left(kNuisances);
  if (!(plain > Real(0))) {
    return 0;
  }
  return std::clamp(Real(1) - left(kNuisances + columns) / plain, Real(0), Real(1));
}

template <class Real>
typename GapFit<Real>::Row GapFit<Real>::weights() const {
  Sums both = folds_[0];
  for (std::size_t k = 0; k < both.size(); ++k) {
    both[k] += folds_[1][k];
  }
  return solve<Real>(unpacked<Real>(both), kUnknowns);
}

template class GapFit<float>;
template class GapFit<double>;

}  // namespace ident
