// Two gains ≥ 0 beside a few free unknowns: least squares on the sums, in closed form.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ident {

/// The nuisances taken out of the rest by a Cholesky factor of their sums; a column that
/// the ones before it explain is left out.
template <class Real, std::size_t kCount>
class Elimination {
 public:
  using Vector = std::array<Real, kCount>;

  explicit Elimination(const std::array<Vector, kCount>& q) {
    const Real tolerance = Real(16) * std::numeric_limits<Real>::epsilon();
    for (std::size_t i = 0; i < kCount; ++i) {
      Real pivot = q[i][i];
      for (std::size_t j = 0; j < i; ++j) {
        Real sum = q[i][j];
        for (std::size_t k = 0; k < j; ++k) {
          sum -= factor_[i][k] * factor_[j][k];
        }
        factor_[i][j] = sum * inverse_[j];
        pivot -= factor_[i][j] * factor_[i][j];
      }
      const bool kept = pivot > tolerance * q[i][i];
      inverse_[i] = kept ? Real(1) / std::sqrt(pivot) : Real(0);
    }
  }
  /// The share of a column in each nuisance, orthogonalised.
  [[nodiscard]] Vector shares(const Vector& sums) const {
    Vector out{};
    for (std::size_t i = 0; i < kCount; ++i) {
      Real sum = sums[i];
      for (std::size_t k = 0; k < i; ++k) {
        sum -= factor_[i][k] * out[k];
      }
      out[i] = sum * inverse_[i];
    }
    return out;
  }
  /// The weights of the nuisances that explain such shares.
  [[nodiscard]] Vector weights(Vector shares) const {
    for (std::size_t i = kCount; i-- > 0;) {
      shares[i] *= inverse_[i];
      for (std::size_t k = 0; k < i; ++k) {
        shares[k] -= factor_[i][k] * shares[i];
      }
    }
    return shares;
  }

 private:
  std::array<Vector, kCount> factor_{};
  Vector inverse_{};
};

template <class Vector>
auto inner(const Vector& a, const Vector& b) {
  auto sum = a[0] * b[0];
  for (std::size_t i = 1; i < a.size(); ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

/// What is left of a tap without the nuisances.
template <class Real>
struct Remainder {
  Real own = 0;     ///< 0: explained by them
  Real with_y = 0;  ///< 0 when below `noise`
  Real noise = 0;   ///< of sums with y
};

template <class Real>
struct Gains {
  Real a = 0;
  Real b = 0;
};

/// min ½(a²·A + 2ab·mixed + b²·B) − a·A.with_y − b·B.with_y over a, b ≥ 0.
template <class Real>
Gains<Real> non_negative_gains(const Remainder<Real>& a, const Remainder<Real>& b,
                               Real mixed) {
  const auto gain = [](const Remainder<Real>& tap) {
    return tap.own > Real(0) && tap.with_y > tap.noise ? tap.with_y * tap.with_y / tap.own
                                                       : Real(0);
  };
  const Real gain_a = gain(a);
  const Real gain_b = gain(b);
  if (!(gain_a > Real(0)) && !(gain_b > Real(0))) {
    return {};
  }
  const bool a_first = gain_a >= gain_b;
  const Remainder<Real>& first = a_first ? a : b;
  const Remainder<Real>& second = a_first ? b : a;
  const auto ordered = [&](Real of_first, Real of_second) {
    return a_first ? Gains<Real>{of_first, of_second} : Gains<Real>{of_second, of_first};
  };
  const Real alone = first.with_y / first.own;
  const Real left = second.with_y - mixed * alone;
  const Real pivot = second.own - mixed * mixed / first.own;
  const Real tolerance = Real(16) * std::numeric_limits<Real>::epsilon();
  if (!(left > second.noise) || !(pivot > tolerance * second.own)) {
    return ordered(alone, Real(0));
  }
  const Real other = left / pivot;
  const Real together = alone - mixed * other / first.own;
  return together > Real(0) ? ordered(together, other)
                            : ordered(Real(0), second.with_y / second.own);
}

}  // namespace ident
