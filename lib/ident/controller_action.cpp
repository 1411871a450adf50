#include "ident/controller_action.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ident {

namespace {

// Samples off the limits below which no law is fitted.
constexpr int kFewest = 4;

/// Least squares of Δu(t) on Δe and e of `lag` samples earlier.
template <class Real>
struct PiLaw {
  PiLaw(std::span<const Real> u, std::span<const Real> y, std::span<const Real> sp,
        std::size_t lag) {
    const std::size_t n = u.size();
    const auto error = [&](std::size_t t) {
      return (sp.empty() ? Real(0) : sp[t]) - y[t];
    };
    // A controller at its limit does not follow its law.
    const auto [low, high] = std::minmax_element(u.begin(), u.end());
    const Real margin = (*high - *low) * Real(1e-6);
    const Real lowest = *low + margin;
    const Real highest = *high - margin;
    const auto moves = [&](std::size_t t) { return u[t] > lowest && u[t] < highest; };
    const std::size_t first = lag + 1;
    Real count = 0;
    Real mean = 0;
    Real move = 0;
    Real drift = 0;
    for (std::size_t t = first; t < n; ++t) {
      if (moves(t)) {
        count += Real(1);
        mean += error(t - lag);
        move += u[t] - u[t - 1];
        drift += error(t - lag) - error(t - lag - 1);
      }
    }
    if (count < Real(kFewest)) {
      return;
    }
    mean /= count;
    move /= count;
    drift /= count;
    // Centred sums: the constant is already taken out.
    Real pp = 0;
    Real pi = 0;
    Real ii = 0;
    Real pu = 0;
    Real iu = 0;
    Real uu = 0;
    for (std::size_t t = first; t < n; ++t) {
      if (!moves(t)) {
        continue;
      }
      const Real p = error(t - lag) - error(t - lag - 1) - drift;
      const Real i = error(t - lag) - mean;
      const Real v = u[t] - u[t - 1] - move;
      pp += p * p;
      pi += p * i;
      ii += i * i;
      pu += p * v;
      iu += i * v;
      uu += v * v;
    }
    const Real determinant = pp * ii - pi * pi;
    if (!(uu > Real(0)) || !(determinant > Real(1e-9) * pp * ii)) {
      return;
    }
    proportional = (ii * pu - pi * iu) / determinant;
    integral = (pp * iu - pi * pu) / determinant;
    r_squared = (proportional * pu + integral * iu) / uu;
    proportional_share = proportional * proportional * pp / uu;
    integral_share = integral * integral * ii / uu;
  }

  Real proportional = 0;
  Real integral = 0;
  Real r_squared = 0;
  Real proportional_share = 0;  // of the variance of Δu
  Real integral_share = 0;
};

}  // namespace

template <class Real>
ControllerAction<Real> controller_action(std::span<const Real> u, std::span<const Real> y,
                                         std::span<const Real> sp) {
  constexpr Real kCertain = Real(0.95);  // share of Δu that settles it
  constexpr Real kLikely = Real(0.8);    // enough if the law fits worse a sample later:
  constexpr Real kSharper = Real(0.85);  // then it is the law and not mere smoothness
  constexpr Real kMinor = Real(0.02);    // a part below this share may disagree
  ControllerAction<Real> action;
  if (u.size() < 8) {
    return action;
  }
  const PiLaw<Real> law(u, y, sp, 0);
  action.proportional = law.proportional;
  action.integral = law.integral;
  action.r_squared = law.r_squared;
  const bool agree = (law.proportional > Real(0)) == (law.integral > Real(0)) ||
                     law.proportional_share < kMinor || law.integral_share < kMinor;
  if (!agree || !(law.r_squared > kLikely)) {
    return action;
  }
  if (law.r_squared < kCertain &&
      PiLaw<Real>(u, y, sp, 1).r_squared > kSharper * law.r_squared) {
    return action;
  }
  const bool leads = law.proportional_share > law.integral_share;
  action.sign = (leads ? law.proportional : law.integral) > Real(0) ? 1 : -1;
  return action;
}

template ControllerAction<float> controller_action<float>(std::span<const float>,
                                                          std::span<const float>,
                                                          std::span<const float>);
template ControllerAction<double> controller_action<double>(std::span<const double>,
                                                            std::span<const double>,
                                                            std::span<const double>);

}  // namespace ident
