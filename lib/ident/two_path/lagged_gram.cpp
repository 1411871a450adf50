#include "ident/two_path/lagged_gram.hpp"

#include <algorithm>
#include <cstddef>

namespace ident {

template <class Real>
HatPair<Real> hats_at(const Path<Real>& path, int offset, Real u) {
  int segment = 0;
  while (segment + 1 < path.segments && u >= path.knots[segment + 1]) {
    ++segment;
  }
  const Real width = path.knots[segment + 1] - path.knots[segment];
  const Real share = (u - path.knots[segment]) / width;
  return {offset + segment, std::clamp(share, Real(0), Real(1))};
}

template <class Real>
HatPair<Real> KnotGrid<Real>::at(Real u, bool is_ascending) const {
  return is_ascending ? hats_at(ascending, 0, u)
                      : hats_at(descending, ascending.segments + 1, u);
}

template <class Real>
void LaggedGram<Real>::start(const KnotGrid<Real>& grid, const WindowView<Real>& window) {
  grid_ = grid;
  window_ = window;
  rows_ = static_cast<int>(window.u.size()) - kFirst;
  next_ = 0;
  past_ = {};
  for (auto& block : hat_hat_) {
    block.setZero();
  }
  for (auto& column : y_hat_) {
    column.setZero();
  }
  hat_sum_.setZero();
  y_sum_ = {};
  yy_ = {};
}

template <class Real>
bool LaggedGram<Real>::step(int samples) {
  const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(window_.u.size());
  for (; samples > 0 && next_ < n; --samples, ++next_) {
    add(next_);
    if (next_ >= kFirst) {
      add_outputs(next_);
    }
  }
  return next_ == n;
}

template <class Real>
void LaggedGram<Real>::add(std::ptrdiff_t s) {
  const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(window_.u.size());
  for (int lag = kMaxNb - 1; lag > 0; --lag) {
    past_[lag] = past_[lag - 1];
  }
  past_[0] = grid_.at(window_.u[s], window_.ascending[s] != 0);
  const HatPair<Real> now = past_[0];
  if (s < kFirst) {
    head_[s] = now;
  }
  if (s >= n - kFirst) {
    tail_[s - rows_] = now;
  }
  const Real lower = Real(1) - now.upper;
  hat_sum_(now.first) += lower;
  hat_sum_(now.first + 1) += now.upper;
  for (int lag = 0; lag < kMaxNb && lag <= s; ++lag) {
    Block& block = hat_hat_[lag];
    const HatPair<Real> then = past_[lag];
    const Real then_lower = Real(1) - then.upper;
    block(now.first, then.first) += lower * then_lower;
    block(now.first, then.first + 1) += lower * then.upper;
    block(now.first + 1, then.first) += now.upper * then_lower;
    block(now.first + 1, then.first + 1) += now.upper * then.upper;
  }
  for (int lead = -kLeads; lead <= kFirst; ++lead) {
    if (s + lead >= 0 && s + lead < n) {
      const Real y = window_.y[s + lead];
      y_hat_[lead + kLeads](now.first) += y * lower;
      y_hat_[lead + kLeads](now.first + 1) += y * now.upper;
    }
  }
}

template <class Real>
void LaggedGram<Real>::add_outputs(std::ptrdiff_t t) {
  for (int i = 0; i <= kMaxNa; ++i) {
    y_sum_[i] += window_.y[t - i];
    for (int j = 0; j <= i; ++j) {
      yy_[i][j] += window_.y[t - i] * window_.y[t - j];
    }
  }
}

// The samples s ≥ `first` of which s + p is no predicted one, or none of the window.
template <class Real>
template <class Remove>
void LaggedGram<Real>::at_ends(std::ptrdiff_t first, int p, const Remove& remove) const {
  const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(window_.u.size());
  for (std::ptrdiff_t s = first; s < kFirst - p; ++s) {
    remove(s);
  }
  for (std::ptrdiff_t s = std::max(n - p, first); s < n; ++s) {
    remove(s);
  }
}

template <class Real>
void LaggedGram<Real>::add_y_hats(int i, int p, Real weight, HatColumn<Real>& out) const {
  const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(window_.u.size());
  const int lead = p - i;  // with s = t − p: y(t−i) = y(s + lead)
  out += weight * y_hat_[lead + kLeads].head(out.size());
  const auto remove = [&](std::ptrdiff_t s) {
    if (s + lead < 0 || s + lead >= n) {
      return;
    }
    const HatPair<Real>& pair = pair_at(s);
    const Real value = weight * window_.y[s + lead];
    out(pair.first) -= value * (Real(1) - pair.upper);
    out(pair.first + 1) -= value * pair.upper;
  };
  at_ends(0, p, remove);
}

template <class Real>
void LaggedGram<Real>::add_hat_sum(int p, Real weight, HatColumn<Real>& out) const {
  out += weight * hat_sum_.head(out.size());
  const auto remove = [&](std::ptrdiff_t s) {
    const HatPair<Real>& pair = pair_at(s);
    out(pair.first) -= weight * (Real(1) - pair.upper);
    out(pair.first + 1) -= weight * pair.upper;
  };
  at_ends(0, p, remove);
}

template <class Real>
void LaggedGram<Real>::filtered(int nk, int nb, const std::array<Real, kMaxNb>& b,
                                HatSquare<Real>& out) const {
  const Eigen::Index hats = out.rows();
  out.setZero();
  // Each lag counts twice, once transposed; half of lag 0 does, too.
  for (int lag = 0; lag < nb; ++lag) {
    // Lags p = nk + i and p + lag share the sums of H(s)·H(s−lag)ᵀ, s = t − p.
    const Real share = lag == 0 ? Real(0.5) : Real(1);
    Real weight = 0;
    for (int i = 0; i + lag < nb; ++i) {
      const Real product = share * b[i] * b[i + lag];
      weight += product;
      const int p = nk + i + 1;
      const auto remove = [&](std::ptrdiff_t s) {
        const HatPair<Real>& now = pair_at(s);
        const HatPair<Real>& then = pair_at(s - lag);
        const Real now_weight[2] = {Real(1) - now.upper, now.upper};
        const Real then_weight[2] = {Real(1) - then.upper, then.upper};
        for (int r = 0; r < 2; ++r) {
          for (int c = 0; c < 2; ++c) {
            out(now.first + r, then.first + c) -=
                product * now_weight[r] * then_weight[c];
          }
        }
      };
      at_ends(lag, p, remove);
    }
    for (Eigen::Index c = 0; c < hats; ++c) {
      out.col(c) += weight * hat_hat_[lag].col(c).head(hats);
    }
  }
  for (Eigen::Index c = 0; c < hats; ++c) {
    for (Eigen::Index r = 0; r <= c; ++r) {
      out(r, c) = out(c, r) = out(r, c) + out(c, r);
    }
  }
}

template <class Real>
Real LaggedGram<Real>::xx(int p, int q, const HatColumn<Real>& x) const {
  const int lag = q > p ? q - p : p - q;
  const int nearer = q > p ? p : q;
  // Σ_c column·x(c) first: independent sums.
  Hats product = Hats::Zero();
  for (Eigen::Index c = 0; c < x.size(); ++c) {
    product += x(c) * hat_hat_[lag].col(c);
  }
  Real sum = product.head(x.size()).dot(x);
  const auto remove = [&](std::ptrdiff_t s) {
    sum -= x_at(pair_at(s), x) * x_at(pair_at(s - lag), x);
  };
  at_ends(lag, nearer, remove);
  return sum;
}

template HatPair<float> hats_at<float>(const Path<float>&, int, float);
template HatPair<double> hats_at<double>(const Path<double>&, int, double);
template class LaggedGram<float>;
template class LaggedGram<double>;
template struct KnotGrid<float>;
template struct KnotGrid<double>;

}  // namespace ident
