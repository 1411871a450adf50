#include "ident/lagged_gram.hpp"

#include <algorithm>
#include <cstddef>

namespace ident {

template <class Real>
HatPair<Real> KnotGrid<Real>::at(Real u, bool is_ascending) const {
  const Path<Real>& path = is_ascending ? ascending : descending;
  const int offset = is_ascending ? 0 : ascending.segments + 1;
  int segment = 0;
  while (segment + 1 < path.segments && u >= path.knots[segment + 1]) {
    ++segment;
  }
  const Real width = path.knots[segment + 1] - path.knots[segment];
  const Real share = (u - path.knots[segment]) / width;
  return {offset + segment, std::clamp(share, Real(0), Real(1))};
}

template <class Real>
void LaggedGram<Real>::accumulate(const KnotGrid<Real>& grid,
                                  const WindowView<Real>& window) {
  grid_ = grid;
  window_ = window;
  const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(window.u.size());
  rows_ = static_cast<int>(n - kFirst);
  for (auto& block : hat_hat_) {
    block.setZero();
  }
  for (auto& column : y_hat_) {
    column.setZero();
  }
  hat_sum_.setZero();

  std::array<HatPair<Real>, kMaxNb> past{};  // past[τ] is the pair of sample s − τ
  for (std::ptrdiff_t s = 0; s < n; ++s) {
    for (int lag = kMaxNb - 1; lag > 0; --lag) {
      past[lag] = past[lag - 1];
    }
    past[0] = grid_.at(window.u[s], window.ascending[s] != 0);
    const HatPair<Real> now = past[0];
    const Real lower = Real(1) - now.upper;
    hat_sum_(now.first) += lower;
    hat_sum_(now.first + 1) += now.upper;
    for (int lag = 0; lag < kMaxNb && lag <= s; ++lag) {
      HatSquare& block = hat_hat_[lag];
      const HatPair<Real> then = past[lag];
      const Real then_lower = Real(1) - then.upper;
      block(now.first, then.first) += lower * then_lower;
      block(now.first, then.first + 1) += lower * then.upper;
      block(now.first + 1, then.first) += now.upper * then_lower;
      block(now.first + 1, then.first + 1) += now.upper * then.upper;
    }
    for (int lead = -kLeads; lead <= kFirst; ++lead) {
      if (s + lead >= 0 && s + lead < n) {
        const Real y = window.y[s + lead];
        y_hat_[lead + kLeads](now.first) += y * lower;
        y_hat_[lead + kLeads](now.first + 1) += y * now.upper;
      }
    }
  }

  for (int i = 0; i <= kMaxNa; ++i) {
    y_sum_[i] = 0;
    for (int j = 0; j <= kMaxNa; ++j) {
      yy_[i][j] = 0;
    }
  }
  for (std::ptrdiff_t t = kFirst; t < n; ++t) {
    for (int i = 0; i <= kMaxNa; ++i) {
      y_sum_[i] += window.y[t - i];
      for (int j = i; j <= kMaxNa; ++j) {
        yy_[i][j] += window.y[t - i] * window.y[t - j];
      }
    }
  }
  for (int i = 0; i <= kMaxNa; ++i) {
    for (int j = 0; j < i; ++j) {
      yy_[i][j] = yy_[j][i];
    }
  }
}

template <class Real>
void LaggedGram<Real>::add_y_hats(int i, int p, Real weight, Column<Real>& out) const {
  const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(window_.u.size());
  const int lead = p - i;  // with s = t − p: y(t−i) = y(s + lead)
  out += weight * y_hat_[lead + kLeads].head(out.size());
  const auto remove = [&](std::ptrdiff_t s) {
    if (s + lead < 0 || s + lead >= n) {
      return;
    }
    const HatPair<Real> pair = grid_.at(window_.u[s], window_.ascending[s] != 0);
    const Real value = weight * window_.y[s + lead];
    out(pair.first) -= value * (Real(1) - pair.upper);
    out(pair.first + 1) -= value * pair.upper;
  };
  for (std::ptrdiff_t s = 0; s < kFirst - p; ++s) {
    remove(s);
  }
  for (std::ptrdiff_t s = n - p; s < n; ++s) {
    remove(s);
  }
}

template <class Real>
void LaggedGram<Real>::add_hat_sum(int p, Real weight, Column<Real>& out) const {
  const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(window_.u.size());
  out += weight * hat_sum_.head(out.size());
  const auto remove = [&](std::ptrdiff_t s) {
    const HatPair<Real> pair = grid_.at(window_.u[s], window_.ascending[s] != 0);
    out(pair.first) -= weight * (Real(1) - pair.upper);
    out(pair.first + 1) -= weight * pair.upper;
  };
  for (std::ptrdiff_t s = 0; s < kFirst - p; ++s) {
    remove(s);
  }
  for (std::ptrdiff_t s = n - p; s < n; ++s) {
    remove(s);
  }
}

template <class Real>
void LaggedGram<Real>::add_filtered(int nk, int nb, const std::array<Real, kMaxNb>& b,
                                    Square<Real>& out) const {
  const Eigen::Index hats = out.rows();
  const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(window_.u.size());
  for (int lag = 0; lag < nb; ++lag) {
    // Lags p = nk + i and p + lag share the sums of H(s)·H(s−lag)ᵀ, s = t − p.
    Real weight = 0;
    for (int i = 0; i + lag < nb; ++i) {
      weight += b[i] * b[i + lag];
    }
    const auto block = hat_hat_[lag].topLeftCorner(hats, hats);
    if (lag == 0) {
      out += weight * block;
    } else {
      out += weight * block;
      out += weight * block.transpose();
    }
    for (int i = 0; i + lag < nb; ++i) {
      const Real product = b[i] * b[i + lag];
      const int p = nk + i + 1;
      const auto remove = [&](std::ptrdiff_t s) {
        const HatPair<Real> now = grid_.at(window_.u[s], window_.ascending[s] != 0);
        const HatPair<Real> then =
            grid_.at(window_.u[s - lag], window_.ascending[s - lag] != 0);
        const Real now_weight[2] = {Real(1) - now.upper, now.upper};
        const Real then_weight[2] = {Real(1) - then.upper, then.upper};
        for (int r = 0; r < 2; ++r) {
          for (int c = 0; c < 2; ++c) {
            const Real value = product * now_weight[r] * then_weight[c];
            out(now.first + r, then.first + c) -= value;
            if (lag != 0) {
              out(then.first + c, now.first + r) -= value;
            }
          }
        }
      };
      for (std::ptrdiff_t s = lag; s < kFirst - p; ++s) {
        remove(s);
      }
      for (std::ptrdiff_t s = std::max<std::ptrdiff_t>(n - p, lag); s < n; ++s) {
        remove(s);
      }
    }
  }
}

template <class Real>
Real LaggedGram<Real>::x_at(std::ptrdiff_t t, const Column<Real>& x) const {
  const HatPair<Real> pair = grid_.at(window_.u[t], window_.ascending[t] != 0);
  return x(pair.first) + (x(pair.first + 1) - x(pair.first)) * pair.upper;
}

template <class Real>
Real LaggedGram<Real>::xx(int p, int q, const Column<Real>& x) const {
  const int lag = q > p ? q - p : p - q;
  const int nearer = q > p ? p : q;
  const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(window_.u.size());
  Real sum = 0;
  const Eigen::Index hats = x.size();
  for (Eigen::Index c = 0; c < hats; ++c) {
    sum += x(c) * hat_hat_[lag].col(c).head(hats).dot(x);
  }
  const auto remove = [&](std::ptrdiff_t s) { sum -= x_at(s, x) * x_at(s - lag, x); };
  for (std::ptrdiff_t s = lag; s < kFirst - nearer; ++s) {
    remove(s);
  }
  for (std::ptrdiff_t s = std::max<std::ptrdiff_t>(n - nearer, lag); s < n; ++s) {
    remove(s);
  }
  return sum;
}

template class LaggedGram<float>;
template class LaggedGram<double>;
template struct KnotGrid<float>;
template struct KnotGrid<double>;

}  // namespace ident
