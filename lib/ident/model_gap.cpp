#include "ident/model_gap.hpp"

#include <algorithm>
#include <cmath>

namespace ident {
namespace {

// A suspect explains at least this share of the error, on samples that it was not fitted
// to, and gains so many nats of likelihood over all the columns that were tried. Set on
// simulated loops (host-tests/score/score_gap.cpp).
constexpr double kLeastShare = 0.15;
constexpr double kLeastShareOfStep = 0.45;  // which has a place to choose
constexpr double kLeastNats = 12;
// A smaller residual is not worth a word; the standard deviation of y is 1.
constexpr double kLeastResidual = 0.01;
// Factor of a column that is a whole effect: it would be 1.
constexpr double kLeastFactor = 0.3;
constexpr double kMostFactor = 2;

constexpr double kTwoPi = 6.28318530717959;
constexpr double kLineSpacing = 0.75;  // of 1/N
constexpr int kFirstLine = 7;          // 5¼ cycles in the window
constexpr double kShortestLine = 8;    // samples
constexpr int kLinesAtOnce = 4;
constexpr int kRefinements = 6;
constexpr std::size_t kMostBlocks = 64;
constexpr double kHarmonic = 0.06;  // distance to a harmonic of the loop, in orders

template <class Real>
Real least_share(EffectCode effect) {
  return effect == EffectCode::kDisturbanceStep ? Real(kLeastShareOfStep)
                                                : Real(kLeastShare);
}

}  // namespace

template <class Real>
void ModelGap<Real>::start(const GapWindow<Real>& window) {
  window_ = window;
  report_ = {};
  suspect_ = {};
  share_ = line_power_ = 0;
  best_line_ = index_ = 0;
  line_ = kFirstLine;
  look();
  stage_ = report_.residual > Real(kLeastResidual) ? Stage::kLines : Stage::kDone;
}

// The residual in physical coordinates.
template <class Real>
void ModelGap<Real>::look() {
  using Views = GapViews<Real>;
  const std::size_t n = window_.y.size();
  const auto [low, high] = std::minmax_element(window_.stem.begin(), window_.stem.end());
  const Real stem_low = *low;
  const Real range = *high - stem_low;
  Views& views = report_.views;
  Real energy = 0;
  Real beside = 0;
  Real before = 0;
  Real turned_at = window_.stem[0];
  std::size_t upper_turn = 0;
  for (std::size_t t = 0; t < n; ++t) {
    const Real x = window_.stem[t];
    if (t > 0 && window_.ascending[t] != window_.ascending[t - 1]) {
      turned_at = x;
      upper_turn = window_.ascending[t] ? upper_turn : t;
    }
    const Real e = window_.y[t] - window_.simulated[t];
    const Real square = e * e;
    energy += square;
    beside += e * before;
    before = e;
    views.ascending += window_.ascending[t] ? square : Real(0);
    const Real travel = std::abs(x - turned_at) / window_.swing;
    views.travel[travel > Real(1)      ? 3
                 : travel > Real(0.5)  ? 2
                 : travel > Real(0.25) ? 1
                                       : 0] += square;
    const Real level = range > Real(0) ? (x - stem_low) / range : Real(0);
    views.level[std::min(static_cast<int>(level * Real(4)), 3)] += square;
    const Real phase = static_cast<Real>(t - upper_turn) / window_.period;
    views.phase[static_cast<int>(phase * Real(Views::kPhases)) % Views::kPhases] +=
        square;
    views.time[t * Views::kQuarters / n] += square;
  }
  report_.residual = std::sqrt(energy / static_cast<Real>(n));
  if (!(energy > Real(0))) {
    views = {};
    return;
  }
  views.ascending /= energy;
  views.lag = beside / energy;
  for (auto* group : {&views.travel, &views.level, &views.time}) {
    for (Real& share : *group) {
      share /= energy;
    }
  }
  for (Real& share : views.phase) {
    share /= energy;
  }
}

// Equation (G2): the next few lines of the spectrum of e.
template <class Real>
void ModelGap<Real>::scan_lines() {
  const Real n = static_cast<Real>(window_.y.size());
  struct Phasor {
    Real c = 1, s = 0, turn_c, turn_s, sum_c = 0, sum_s = 0;
  };
  std::array<Phasor, kLinesAtOnce> phasors;
  for (int k = 0; k < kLinesAtOnce; ++k) {
    const Real omega = Real(kTwoPi * kLineSpacing) * static_cast<Real>(line_ + k) / n;
    phasors[k].turn_c = std::cos(omega);
    phasors[k].turn_s = std::sin(omega);
  }
  Real energy = 0;
  for (std::size_t t = 0; t < window_.y.size(); ++t) {
    const Real e = window_.y[t] - window_.simulated[t];
    energy += e * e;
    for (Phasor& p : phasors) {
      p.sum_c += e * p.c;
      p.sum_s += e * p.s;
      const Real c = p.c * p.turn_c - p.s * p.turn_s;
      p.s = p.s * p.turn_c + p.c * p.turn_s;
      p.c = c;
    }
  }
  for (int k = 0; k < kLinesAtOnce; ++k) {
    const Phasor& p = phasors[k];
    const Real power = Real(2) * (p.sum_c * p.sum_c + p.sum_s * p.sum_s) / (n * energy);
    if (power > line_power_) {
      line_power_ = power;
      best_line_ = line_ + k;
    }
  }
  line_ += kLinesAtOnce;
  if (Real(kLineSpacing) * static_cast<Real>(line_) * Real(kShortestLine) > n) {
    report_.views.line = std::min(line_power_, Real(1));
    report_.views.line_period =
        n / (Real(kLineSpacing) * static_cast<Real>(std::max(best_line_, 1)));
    stage_ = Stage::kList;
  }
}

template <class Real>
Real ModelGap<Real>::strongest_line() const {
  return Real(kLineSpacing) * static_cast<Real>(best_line_) /
         static_cast<Real>(window_.y.size());
}

template <class Real>
typename GapFit<Real>::Row ModelGap<Real>::row_at(std::size_t t,
                                                  GapColumn<Real>& column) const {
  const std::array<Real, 2> values = column.at(t);
  return {Real(1), window_.simulated[t], values[0], values[1]};
}

// One candidate: its column, sample by sample, and what it explains. True if it is the
// best so far.
template <class Real>
bool ModelGap<Real>::try_candidate(const GapCandidate& candidate) {
  const std::size_t n = window_.y.size();
  if (candidate.kind == GapKind::kLine) {
    const Real order = window_.period / report_.views.line_period;
    const Real nearest = std::max(std::round(order), Real(1));
    const Real apart =
        std::max(Real(kHarmonic), Real(1.5) * window_.period / static_cast<Real>(n));
    if (std::abs(order - nearest) < apart) {
      return false;  // a harmonic of the loop itself
    }
  }
  GapColumn<Real> column(candidate, window_, strongest_line());
  const std::size_t block =
      std::max(static_cast<std::size_t>(window_.period), n / kMostBlocks + 1);
  fit_.clear();
  for (std::size_t t = 0; t < n; ++t) {
    fit_.add(static_cast<int>(t / block % 2), row_at(t, column),
             window_.y[t] - window_.simulated[t]);
  }
  using Fit = GapFit<Real>;
  const Real share = fit_.share(column.count());
  if (!(share > share_) || !(share > least_share<Real>(candidate.effect))) {
    return false;
  }
  const typename Fit::Row weights = fit_.weights();
  const Real factor = weights[Fit::kNuisances];
  if (candidate.whole && !(factor > Real(kLeastFactor) && factor < Real(kMostFactor))) {
    return false;
  }
  share_ = share;
  weights_ = weights;
  suspect_ = candidate;
  return true;
}

// The suspect at settings nearer and nearer to the best one.
template <class Real>
void ModelGap<Real>::refine() {
  GapCandidate nearer = suspect_;
  const float sense = index_ % 2 == 0 ? 1.0F : -1.0F;
  nearer.value += sense * gap_spacing(suspect_) * refinement_;
  try_candidate(nearer);
  if (++index_ % 2 == 0) {
    refinement_ /= 2;
  }
  if (index_ == kRefinements) {
    stage_ = Stage::kVerify;
  }
}

// Independent samples in what the suspect leaves: a column that only follows the trend of
// a residual leaves one that is as coloured as before.
template <class Real>
void ModelGap<Real>::verify() {
  stage_ = Stage::kDone;
  // A recorded lattice adds the variance of half a step either way.
  const Real variance = report_.residual * report_.residual;
  const Real lattice = window_.y_step * window_.y_step / (Real(12) * variance);
  Real observations = window_.observations;
  if (lattice > share_) {
    share_ = std::min(lattice, Real(1));
    suspect_.effect = EffectCode::kSensorQuantisation;
  } else if (suspect_.effect != EffectCode::kNone) {
    GapColumn<Real> column(suspect_, window_, strongest_line());
    Real energy = 0;
    Real beside = 0;
    Real before = 0;
    for (std::size_t t = 0; t < window_.y.size(); ++t) {
      const typename GapFit<Real>::Row row = row_at(t, column);
      Real left = window_.y[t] - window_.simulated[t];
      for (std::size_t k = 0; k < row.size(); ++k) {
        left -= weights_[k] * row[k];
      }
      energy += left * left;
      beside += left * before;
      before = left;
    }
    const Real correlation = std::clamp(beside / energy, Real(0), Real(0.999));
    observations = static_cast<Real>(window_.y.size()) * (Real(1) - correlation) /
                   (Real(1) + correlation);
  }
  const Real nats =
      Real(-0.5) * observations * std::log(std::max(Real(1) - share_, Real(1e-6)));
  if (share_ > least_share<Real>(suspect_.effect) && nats > Real(kLeastNats)) {
    report_.suspect = suspect_.effect;
    report_.share_of_error = share_;
  }
}

template <class Real>
bool ModelGap<Real>::step() {
  switch (stage_) {
    case Stage::kLines:
      scan_lines();
      break;
    case Stage::kList:
      try_candidate(gap_candidate(index_));
      if (++index_ == kGapCandidates) {
        index_ = 0;
        refinement_ = 0.5F;
        const bool refined =
            suspect_.effect != EffectCode::kNone && gap_spacing(suspect_) > 0;
        stage_ = refined ? Stage::kRefine : Stage::kVerify;
      }
      break;
    case Stage::kRefine:
      refine();
      break;
    case Stage::kVerify:
      verify();
      break;
    case Stage::kDone:
      break;
  }
  return done();
}

template class ModelGap<float>;
template class ModelGap<double>;

}  // namespace ident
