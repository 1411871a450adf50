#include "ident/signal/swap.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ident {
namespace {

// Δsp, sp, in, Δin, and Δout, which they explain.
constexpr std::size_t kTerms = 5;
constexpr std::size_t kIntegral = 2;
constexpr std::size_t kProportional = 3;
constexpr std::size_t kOut = 4;
constexpr std::size_t kFewest = 32;
// A term that the ones before it explain up to this share of its own adds nothing.
constexpr double kDependent = 1e-6;
// What the law must explain, and how much more the reading as labelled must leave, at
// least what rounding leaves of either.
constexpr double kExplained = 0.9;
constexpr double kTimesMoreLeft = 4;
constexpr double kLeftAtLeast = 1e-4;
// One sample in so many has to bring another `out`: where it rests longer, a rounded
// process output steps and the controller answers at once, a law in both readings.
constexpr double kSamplesPerMove = 4;
// A part of the law below this share of Δout may have any sign.
constexpr double kMinor = 0.0005;

template <class Real>
using Terms = std::array<Real, kTerms>;
template <class Real>
using Products = std::array<Terms<Real>, kTerms>;  // the upper triangle

template <class Real>
void add_products(const Terms<Real>& x, Products<Real>& sums) {
  for (std::size_t k = 0; k < kTerms; ++k) {
    for (std::size_t j = k; j < kTerms; ++j) {
      sums[k][j] += x[k] * x[j];
    }
  }
}

// Gaussian elimination; each term is left with what those before it do not explain.
// Returns what each was before.
template <class Real>
Terms<Real> eliminate(Products<Real>& sums) {
  Terms<Real> whole;
  for (std::size_t k = 0; k < kTerms; ++k) {
    whole[k] = sums[k][k];
  }
  for (std::size_t k = 0; k < kOut; ++k) {
    if (!(sums[k][k] > Real(kDependent) * whole[k])) {
      sums[k][k] = 0;
      continue;
    }
    for (std::size_t i = k + 1; i < kTerms; ++i) {
      const Real share = sums[k][i] / sums[k][k];
      for (std::size_t j = i; j < kTerms; ++j) {
        sums[i][j] -= share * sums[k][j];
      }
    }
  }
  return whole;
}

}  // namespace

template <class Real>
void SwapSearch<Real>::start(std::span<const Real> u, std::span<const Real> y,
                             std::span<const Real> sp) {
  u_ = u;
  y_ = y;
  sp_ = sp;
  evidence_ = {};
  stage_ = u.size() < kFewest ? Stage::kDone : Stage::kAsLabelled;
}

template <class Real>
typename SwapSearch<Real>::Law SwapSearch<Real>::fit(std::span<const Real> out,
                                                     std::span<const Real> in) const {
  const auto [low, high] = std::minmax_element(out.begin(), out.end());
  const Real margin = (*high - *low) * Real(1e-6);
  const Real lowest = *low + margin;
  const Real highest = *high - margin;
  const auto terms = [&](std::size_t t, Terms<Real>& x) {
    x = {0, 0, in[t] - in[0], in[t] - in[t - 1], out[t] - out[t - 1]};
    if (!sp_.empty()) {
      x[0] = sp_[t] - sp_[t - 1];
      x[1] = sp_[t] - sp_[0];
    }
    return out[t] > lowest && out[t] < highest;
  };
  Terms<Real> x;
  Terms<Real> mean{};
  Real count = 0;
  for (std::size_t t = 1; t < out.size(); ++t) {
    if (terms(t, x)) {
      count += Real(1);
      for (std::size_t k = 0; k < kTerms; ++k) {
        mean[k] += x[k];
      }
    }
  }
  Law law;
  if (Real(2) * count < static_cast<Real>(out.size())) {
    return law;
  }
  Real moves = 0;
  Products<Real> sums{};
  for (std::size_t t = 1; t < out.size(); ++t) {
    if (terms(t, x)) {
      moves += x[kOut] != Real(0) ? Real(1) : Real(0);
      for (std::size_t k = 0; k < kTerms; ++k) {
        x[k] -= mean[k] / count;
      }
      add_products(x, sums);
    }
  }
  const Terms<Real> whole = eliminate(sums);
  const Real total = whole[kOut];
  if (!(total > Real(0))) {
    return law;
  }
  const auto weight = [&](std::size_t k, Real explained) {
    return sums[k][k] > Real(0) ? explained / sums[k][k] : Real(0);
  };
  const Real proportional = weight(kProportional, sums[kProportional][kOut]);
  const Real integral = weight(
      kIntegral, sums[kIntegral][kOut] - sums[kIntegral][kProportional] * proportional);
  const Real minor = std::min(proportional * proportional * whole[kProportional],
                              integral * integral * whole[kIntegral]);
  law.known = Real(kSamplesPerMove) * moves >= count;
  law.r_squared = Real(1) - std::max(sums[kOut][kOut], Real(0)) / total;
  law.agree = proportional * integral > Real(0) || minor < Real(kMinor) * total;
  return law;
}

template <class Real>
bool SwapSearch<Real>::step() {
  switch (stage_) {
    case Stage::kAsLabelled: {
      const Law law = fit(u_, y_);
      known_ = law.known;
      evidence_.as_labelled = law.r_squared;
      stage_ = Stage::kExchanged;
      break;
    }
    case Stage::kExchanged: {
      const Law law = fit(y_, u_);
      evidence_.exchanged = law.r_squared;
      const Real left = Real(1) - evidence_.as_labelled;
      evidence_.swapped = known_ && law.known && law.agree &&
                          law.r_squared > Real(kExplained) && left > Real(kLeftAtLeast) &&
                          left > Real(kTimesMoreLeft) * (Real(1) - law.r_squared);
      stage_ = Stage::kDone;
      break;
    }
    case Stage::kDone:
      break;
  }
  return stage_ == Stage::kDone;
}

template <class Real>
SwapEvidence<Real> find_swap(std::span<const Real> u, std::span<const Real> y,
                             std::span<const Real> sp) {
  SwapSearch<Real> search;
  search.start(u, y, sp);
  while (!search.step()) {
  }
  return search.evidence();
}

#define STICKBAND_INSTANTIATE(Real)            \
  template class SwapSearch<Real>;             \
  template SwapEvidence<Real> find_swap<Real>( \
      std::span<const Real>, std::span<const Real>, std::span<const Real>);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)
#undef STICKBAND_INSTANTIATE

}  // namespace ident
