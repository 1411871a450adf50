#include "ident/signal/controller_action.hpp"

#include <algorithm>
#include <cstddef>

namespace ident {

namespace {

// Samples off the limits below which no law is fitted.
constexpr int kFewest = 4;

}  // namespace

template <class Real>
void ControllerRecognition<Real>::start(std::span<const Real> u, std::span<const Real> y,
                                        std::span<const Real> sp) {
  u_ = u;
  y_ = y;
  sp_ = sp;
  action_ = {};
  lag_ = 0;
  likely_ = 0;
  if (u.size() < 8) {
    stage_ = Stage::kDone;
    return;
  }
  stage_ = Stage::kMeans;
}

// Means of what the law is made of; false where too little moves.
template <class Real>
bool ControllerRecognition<Real>::find_means() {
  const auto [low, high] = std::minmax_element(u_.begin(), u_.end());
  const Real margin = (*high - *low) * Real(1e-6);
  lowest_ = *low + margin;
  highest_ = *high - margin;
  Real count = 0;
  Real mean = 0;
  Real move = 0;
  Real drift = 0;
  for (std::size_t t = lag_ + 1; t < u_.size(); ++t) {
    if (moves(t)) {
      count += Real(1);
      mean += error(t - lag_);
      move += u_[t] - u_[t - 1];
      drift += error(t - lag_) - error(t - lag_ - 1);
    }
  }
  mean_ = mean / count;
  move_ = move / count;
  drift_ = drift / count;
  return !(count < Real(kFewest));
}

// Least squares of Δu(t) on Δe and e of `lag_` samples earlier, on centred sums: the
// constant is already taken out.
template <class Real>
typename ControllerRecognition<Real>::Law ControllerRecognition<Real>::fit() const {
  Real pp = 0;
  Real pi = 0;
  Real ii = 0;
  Real pu = 0;
  Real iu = 0;
  Real uu = 0;
  for (std::size_t t = lag_ + 1; t < u_.size(); ++t) {
    if (!moves(t)) {
      continue;
    }
    const Real p = error(t - lag_) - error(t - lag_ - 1) - drift_;
    const Real i = error(t - lag_) - mean_;
    const Real v = u_[t] - u_[t - 1] - move_;
    pp += p * p;
    pi += p * i;
    ii += i * i;
    pu += p * v;
    iu += i * v;
    uu += v * v;
  }
  Law law;
  const Real determinant = pp * ii - pi * pi;
  if (!(uu > Real(0)) || !(determinant > Real(1e-9) * pp * ii)) {
    return law;
  }
  law.proportional = (ii * pu - pi * iu) / determinant;
  law.integral = (pp * iu - pi * pu) / determinant;
  law.r_squared = (law.proportional * pu + law.integral * iu) / uu;
  law.proportional_share = law.proportional * law.proportional * pp / uu;
  law.integral_share = law.integral * law.integral * ii / uu;
  return law;
}

template <class Real>
void ControllerRecognition<Real>::take(const Law& law) {
  constexpr Real kCertain = Real(0.95);  // share of Δu that settles it
  constexpr Real kLikely = Real(0.8);    // enough if the law fits worse a sample later:
  constexpr Real kSharper = Real(0.85);  // then it is the law and not mere smoothness
  constexpr Real kMinor = Real(0.02);    // a part below this share may disagree
  stage_ = Stage::kDone;
  if (lag_ > 0) {
    action_.sign = law.r_squared > kSharper * action_.r_squared ? 0 : likely_;
    return;
  }
  action_.proportional = law.proportional;
  action_.integral = law.integral;
  action_.r_squared = law.r_squared;
  const bool agree = (law.proportional > Real(0)) == (law.integral > Real(0)) ||
                     law.proportional_share < kMinor || law.integral_share < kMinor;
  if (!agree || !(law.r_squared > kLikely)) {
    return;
  }
  const bool leads = law.proportional_share > law.integral_share;
  likely_ = (leads ? law.proportional : law.integral) > Real(0) ? 1 : -1;
  if (law.r_squared < kCertain) {
    lag_ = 1;
    stage_ = Stage::kMeans;
  } else {
    action_.sign = likely_;
  }
}

template <class Real>
bool ControllerRecognition<Real>::step() {
  switch (stage_) {
    case Stage::kMeans:
      if (find_means()) {
        stage_ = Stage::kSums;
      } else {
        take({});
      }
      break;
    case Stage::kSums:
      take(fit());
      break;
    case Stage::kDone:
      break;
  }
  return stage_ == Stage::kDone;
}

template <class Real>
ControllerAction<Real> controller_action(std::span<const Real> u, std::span<const Real> y,
                                         std::span<const Real> sp) {
  ControllerRecognition<Real> recognition;
  recognition.start(u, y, sp);
  while (!recognition.step()) {
  }
  return recognition.action();
}

template class ControllerRecognition<float>;
template class ControllerRecognition<double>;
template ControllerAction<float> controller_action<float>(std::span<const float>,
                                                          std::span<const float>,
                                                          std::span<const float>);
template ControllerAction<double> controller_action<double>(std::span<const double>,
                                                            std::span<const double>,
                                                            std::span<const double>);

}  // namespace ident
