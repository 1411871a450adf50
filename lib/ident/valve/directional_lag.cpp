#include "ident/valve/directional_lag.hpp"

#include <algorithm>

#include "ident/base/configurations.hpp"
#include "ident/base/elementary.hpp"

namespace ident {
namespace {

constexpr double kApart = 0.55;  // of neighbours on the grid, logarithm of a lag
constexpr double kFirstStep = 0.3;
constexpr double kLastStep = 0.02;
constexpr double kFirstStart = 0.1;  // of the swing of u
constexpr double kLastStart = 0.005;

// Coordinates: logarithms of the rising, the falling and the second lag, in samples of y,
// and where the first one stood, scaled like u.
enum : int { kRising, kFalling, kSecond, kStood };

}  // namespace

template <class Real>
void DirectionalLag<Real>::start(const ValveModel<Real>& linear,
                                 const SearchWindow<Real>& window) {
  *this = {};
  asks_ = linear.known && linear.poles.slow < Real(1);
  if (!asks_) {
    return;
  }
  const Real first = elementary::log(time_constant_of(linear.poles.slow));
  middle_ = {first, first, elementary::log(time_constant_of(linear.poles.fast)),
             window.u[0]};
  pattern_.start(middle_, linear.fit.error, kEvaluations);
  constexpr Real kStep = Real(kFirstStep);
  constexpr Real kLast = Real(kLastStep);
  pattern_.add_direction({1, 0}, kStep, kLast);
  pattern_.add_direction({0, 1}, kStep, kLast);
  pattern_.add_direction({1, 1}, kStep, kLast);
  pattern_.add_direction({0, 0, 1}, Real(2) * kStep, kLast);
  pattern_.add_direction({0, 0, 0, 1}, Real(kFirstStart) * window.swing,
                         Real(kLastStart) * window.swing);
}

template <class Real>
bool DirectionalLag<Real>::done() const {
  return !asks_ || (index_ >= kGrid * kGrid && pattern_.done());
}

template <class Real>
void DirectionalLag<Real>::take(Real error) {
  if (index_ < kGrid * kGrid) {
    pattern_.offer(tried_, error);
    ++index_;
  } else {
    pattern_.report(tried_, error);
  }
}

// What the first lag makes of u, averaged to the rate of y.
template <class Real>
void DirectionalLag<Real>::lay(const SearchWindow<Real>& window,
                               std::span<Real> x) const {
  const Real per_sample = static_cast<Real>(window.decimation);
  const Real rising = pole_of(per_sample * elementary::exp(tried_[kRising]));
  const Real falling = pole_of(per_sample * elementary::exp(tried_[kFalling]));
  Real stands = tried_[kStood];
  const Real* u = window.u.data();
  for (Real& mean : x) {
    Real sum = 0;
    for (const Real* const last = u + window.decimation; u < last; ++u) {
      stands = *u + (stands - *u) * (*u > stands ? rising : falling);
      sum += stands;
    }
    mean = sum / per_sample;
  }
}

template <class Real>
bool DirectionalLag<Real>::step(ValveSearch<Real>& search, int budget) {
  ValvePass<Real>& pass = search.pass();
  for (int left = budget * kUnit; left > 0 && pass.run(left);) {
    if (laid_) {
      take(pass.model().fit.error);
      laid_ = false;
    }
    if (done()) {
      return true;
    }
    if (index_ < kGrid * kGrid) {
      tried_ = middle_;
      tried_[kRising] += Real(kApart) * static_cast<Real>(index_ / kGrid - kGrid / 2);
      tried_[kFalling] += Real(kApart) * static_cast<Real>(index_ % kGrid - kGrid / 2);
    } else {
      tried_ = pattern_.propose();
    }
    lay(search.window(), pass.positions());
    pass.fit_laid({pole_of(elementary::exp(tried_[kSecond])), Real(0)});
    laid_ = true;
  }
  return false;
}

template class DirectionalLag<float>;
template class DirectionalLag<double>;

}  // namespace ident
