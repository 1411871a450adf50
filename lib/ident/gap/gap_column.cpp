#include "ident/gap/gap_column.hpp"

#include <algorithm>
#include <cmath>

#include "ident/base/elementary.hpp"
#include "ident/base/two_pi.hpp"

namespace ident {
namespace {

constexpr int kSteps = 31;

// The candidates of one effect and kind: up to four settings.
struct Family {
  EffectCode effect;
  GapKind kind;
  int count;
  bool whole;
  std::array<float, 4> values;
};

constexpr Family kFamilies[] = {
    {EffectCode::kValveCharacteristic, GapKind::kSquare, 1, false, {}},
    {EffectCode::kProcessNonlinearGain, GapKind::kProduct, 1, false, {}},
    {EffectCode::kProcessGainDrift, GapKind::kDrift, 1, false, {}},
    {EffectCode::kDisturbanceSinusoid, GapKind::kLine, 3, false, {-0.25F, 0, 0.25F}},
    {EffectCode::kValveRateLimit, GapKind::kRate, 4, true, {2, 4, 8, 16}},
    {EffectCode::kValveRateLimit, GapKind::kOpening, 4, true, {2, 4, 8, 16}},
    {EffectCode::kValveRateLimit, GapKind::kClosing, 4, true, {2, 4, 8, 16}},
    {EffectCode::kValveSaturation, GapKind::kUpper, 4, true, {0.6F, 0.7F, 0.8F, 0.9F}},
    {EffectCode::kValveSaturation, GapKind::kLower, 4, true, {0.4F, 0.3F, 0.2F, 0.1F}},
    {EffectCode::kProcessOverflow, GapKind::kOverflow, 4, true, {0.6F, 0.7F, 0.8F, 0.9F}},
    {EffectCode::kProcessSecondLag, GapKind::kLag, 4, true, {0.02F, 0.05F, 0.1F, 0.2F}},
    {EffectCode::kProcessDeadTime, GapKind::kDelay, 3, true, {1, 2, 4}},
    {EffectCode::kDisturbanceRamp, GapKind::kRamp, 1, false, {}},
};

}  // namespace

GapCandidate gap_candidate(int index) {
  for (const Family& family : kFamilies) {
    if (index < family.count) {
      return {family.effect, family.kind, family.values[static_cast<std::size_t>(index)],
              family.whole};
    }
    index -= family.count;
  }
  return {EffectCode::kDisturbanceStep, GapKind::kStep,
          static_cast<float>(index + 1) / static_cast<float>(kSteps + 1), false};
}

float gap_spacing(const GapCandidate& candidate) {
  switch (candidate.kind) {
    case GapKind::kLine:
      return 0.25F;
    case GapKind::kStep:
      return 1.0F / static_cast<float>(kSteps + 1);
    case GapKind::kRate:
    case GapKind::kOpening:
    case GapKind::kClosing:
    case GapKind::kLag:
      return candidate.value / 2;
    case GapKind::kUpper:
    case GapKind::kLower:
    case GapKind::kOverflow:
      return 0.1F;
    default:
      return 0;
  }
}

template <class Real>
GapColumn<Real>::GapColumn(const GapCandidate& candidate, const GapWindow<Real>& window,
                           Real line)
    : window_(window),
      kind_(candidate.kind),
      limited_(window.stem[0]),
      lagged_(window.simulated[0]) {
  const Real count = static_cast<Real>(window.stem.size());
  const Real value = static_cast<Real>(candidate.value);
  steady_ = unit_gain(window.poles, count);
  for (const Real x : window.stem) {
    mean_ += x / count;
  }
  const bool of_output = kind_ == GapKind::kOverflow;
  const auto signal = of_output ? window.simulated : window.stem;
  const auto [low, high] = std::minmax_element(signal.begin(), signal.end());
  const bool from_above = of_output && !window.upright;
  level_ = from_above ? *high - value * (*high - *low) : *low + value * (*high - *low);
  rate_ = value * window.swing / window.period;
  place_ = static_cast<std::size_t>(kind_ == GapKind::kStep ? value * count : value);
  if (kind_ == GapKind::kLag) {
    kept_ = elementary::exp(Real(-1) / (value * window.period));
  }
  if (kind_ == GapKind::kLine) {
    const Real omega = Real(kTwoPi) * (line + value / count);
    turn_cosine_ = elementary::cos(omega);
    turn_sine_ = elementary::sin(omega);
  }
}

template <class Real>
Real GapColumn<Real>::respond(Real x) {
  slow_ = window_.poles.slow * slow_ + x;
  fast_ = window_.poles.fast * fast_ + slow_;
  past_[now_ % kLength] = steady_ * fast_;
  const unsigned delay = static_cast<unsigned>(window_.fit.delay);
  const Real out = window_.fit.gain_a * past_[(now_ - delay) % kLength] +
                   window_.fit.gain_b * past_[(now_ - delay - 1U) % kLength];
  ++now_;
  return out;
}

template <class Real>
std::array<Real, 2> GapColumn<Real>::at(std::size_t t) {
  const Real x = window_.stem[t];
  const Real simulated = window_.simulated[t];
  const Real half = static_cast<Real>(window_.stem.size()) / Real(2);
  switch (kind_) {
    case GapKind::kSquare:
      return {respond((x - mean_) * (x - mean_)), 0};
    case GapKind::kProduct:
      return {respond((x - mean_) * simulated), 0};
    case GapKind::kDrift:
      return {respond((x - mean_) * (static_cast<Real>(t) / half - Real(1))), 0};
    case GapKind::kLine: {
      const std::array<Real, 2> out{cosine_, sine_};
      cosine_ = out[0] * turn_cosine_ - out[1] * turn_sine_;
      sine_ = out[1] * turn_cosine_ + out[0] * turn_sine_;
      return out;
    }
    case GapKind::kStep:
      return {respond(t >= place_ ? Real(1) : Real(0)), 0};
    case GapKind::kRate:
    case GapKind::kOpening:
    case GapKind::kClosing: {
      const bool rises = x > limited_;
      const bool free = kind_ == (rises ? GapKind::kClosing : GapKind::kOpening);
      const Real move = std::min(std::abs(x - limited_), rate_);
      limited_ = free || move < rate_ ? x : limited_ + (rises ? move : -move);
      return {respond(limited_ - x), 0};
    }
    case GapKind::kUpper:
      return {respond(std::min(level_ - x, Real(0))), 0};
    case GapKind::kLower:
      return {respond(std::max(level_ - x, Real(0))), 0};
    case GapKind::kOverflow:
      return {window_.upright ? std::min(level_ - simulated, Real(0))
                              : std::max(level_ - simulated, Real(0)),
              0};
    case GapKind::kLag:
      lagged_ = kept_ * lagged_ + (Real(1) - kept_) * simulated;
      return {lagged_ - simulated, 0};
    case GapKind::kRamp:
      return {static_cast<Real>(t) / half - Real(1), 0};
    case GapKind::kDelay:
      return {t >= place_ ? window_.simulated[t - place_] - simulated : Real(0), 0};
  }
  return {0, 0};
}

template class GapColumn<float>;
template class GapColumn<double>;

}  // namespace ident
