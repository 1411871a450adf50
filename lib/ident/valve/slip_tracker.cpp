#include "ident/valve/slip_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ident {
namespace {

// A model fitted to a few cycles fits the others less well.
constexpr double kFirstMisfits = 1.5;
constexpr double kLeastMisfit = 0.05;
constexpr double kMostMisfit = 0.5;
// Beyond this many standard deviations an error counts linearly: spikes of y kill nobody.
constexpr double kOutlier = 3;
// A stem's output forgets its error this many times in a period, so that one that was off
// the track for a while can be seen to be on it again; once the model is nearly right a
// longer memory tells more.
constexpr double kCorrections = 8;
constexpr double kLaterCorrections = 3;
constexpr double kMostCorrection = 0.3;
// Instructions of a Cortex-M4F: of one stem at one sample of y and at one of u, of one
// that is replaced, of laying a path and filtering y at one sample of u and of y; and
// what a piece that follows may take without replacing any.
constexpr int kPerOutput = 240;
constexpr int kPerMove = 45;
constexpr int kPerReplaced = 450;
constexpr int kPerLaid = 15;
constexpr int kPerFiltered = 23;
constexpr int kMostOfPiece = 35'000;
// Log-likelihoods: while none is below the first, more than half of the stems count
// (Kantorovich's inequality: 4·w / (1 + w)² > ½).
constexpr double kAllAlike = -1.76;

}  // namespace

template <class Real>
void SlipTracker<Real>::start(const SearchWindow<Real>& window,
                              const ValveModel<Real>& model, std::size_t active,
                              std::span<Real> x, std::span<Real> scratch, Stems& stems,
                              ProcessRegression<Real>& regression) {
  window_ = window;
  x_ = x;
  filtered_ = scratch.first(window.y.size());
  stems_ = &stems;
  regression_ = &regression;
  correction_ = std::min(Real(kCorrections) / window.period, Real(kMostCorrection));
  best_ = {};
  best_.model = model;
  best_.misfit = std::clamp(
      Real(kFirstMisfits) * std::sqrt(model.fit.error / static_cast<Real>(active)),
      Real(kLeastMisfit), Real(kMostMisfit));
  take_free_fit(active);
  started_ = true;
  random_ = {};
}

template <class Real>
void SlipTracker<Real>::resume(const State& state, bool depart) {
  best_ = state;
  correction_ = std::min(Real(kLaterCorrections) / window_.period, Real(kMostCorrection));
  started_ = depart;
}

// The gain and the offset of a free simulation as those of a recursion.
template <class Real>
void SlipTracker<Real>::take_free_fit(std::size_t samples) {
  const ProcessFit<Real>& fit = best_.model.fit;
  const Real n = static_cast<Real>(samples);
  const Real steady = std::max(fit.gain_a + fit.gain_b, Real(1e-6));
  best_.origin = PoleFilter<Real>(best_.model.poles, x_.first(samples)).origin();
  if (best_.model.poles.slow < Real(1)) {
    best_.gain = steady * (Real(1) - best_.model.poles.slow);
    best_.origin -= fit.offset / steady;
    return;
  }
  best_.gain = steady * Real(16) / n;
  best_.origin -= Real(2) * fit.drift / (n * best_.gain);
}

// Draws where the stem will give way, from what it may still be.
template <class Real>
void SlipTracker<Real>::release(Stem& stem) {
  const Real half = stem.deadband / Real(2);
  const Real turn = static_cast<Real>(stem.direction) * half;
  const auto draw = [&](int stroke, Real reached) {
    const Real least = std::max(stem.least[stroke], reached);
    const Real most = std::max(stem.most[stroke], least);
    return least + random_.uniform() * (most - least);
  };
  const Real up = half - turn;
  const Real down = half + turn;
  stem.position = stem.slipped_at - turn;
  stem.upper = stem.slipped_at + (up + draw(0, stem.highest - stem.slipped_at - up));
  stem.lower = stem.slipped_at - (down + draw(1, stem.slipped_at - stem.lowest - down));
}

// While it moves the stem follows u, and all that counts from there with it.
template <class Real>
bool SlipTracker<Real>::still_moves(Stem& stem, Real u) {
  stem.moves = stem.direction > 0 ? u > stem.slipped_at : u < stem.slipped_at;
  if (stem.moves) {
    const Real by = u - stem.slipped_at;
    stem.slipped_at = stem.highest = stem.lowest = u;
    stem.position += by;
    stem.upper += by;
    stem.lower += by;
  }
  return stem.moves;
}

// Equation (T2): what held and what gave way bounds the slips of this stem.
template <class Real>
void SlipTracker<Real>::slip(Stem& stem, bool up, int u_index) {
  const Real u = window_.u[u_index];
  if (stem.direction != 0) {
    const Real half = stem.deadband / Real(2);
    const Real turn = static_cast<Real>(stem.direction) * half;
    const Real reached[2] = {stem.highest - stem.slipped_at - half + turn,
                             stem.slipped_at - stem.lowest - half - turn};
    const Real gave =
        up ? u - stem.slipped_at - half + turn : stem.slipped_at - u - half - turn;
    Real& most = stem.most[up ? 0 : 1];
    most = std::min(most, gave);
    const Real middle[2] = {now_.model.friction.slip_ascending,
                            now_.model.friction.slip_descending};
    const Real reach = reach_;
    for (int stroke = 0; stroke < 2; ++stroke) {
      const Real least =
          std::max(stem.least[stroke], std::min(reached[stroke], stem.most[stroke]));
      stem.least[stroke] = std::max({std::min(least, stem.most[stroke]) - widening_,
                                     middle[stroke] - reach, Real(0)});
      stem.most[stroke] = std::min(stem.most[stroke] + widening_, middle[stroke] + reach);
    }
  }
  const int mark = u_index + 1;
  stem.when[stem.slips++] = static_cast<std::int16_t>(up ? mark : -mark);
  if (stem.slips == kMostSlips) {
    --stem.slips;
    used_ =
        std::min(used_, static_cast<std::size_t>(u_index / window_.decimation + delay_));
  }
  stem.direction = static_cast<std::int8_t>(up ? 1 : -1);
  stem.slipped_at = stem.highest = stem.lowest = u;
  stem.moves = now_.model.friction.motion == SlipMotion::kStops;
  release(stem);
}

// One sample of u.
template <class Real>
void SlipTracker<Real>::move(Stem& stem, Real u, int u_index) {
  if (stem.moves && still_moves(stem, u)) {
    return;
  }
  const bool up = u > stem.highest && u > stem.upper;
  if (up || (u < stem.lowest && u < stem.lower)) {
    slip(stem, up, u_index);
    return;
  }
  stem.highest = std::max(stem.highest, u);
  stem.lowest = std::min(stem.lowest, u);
}

// One sample of y, in which u goes from `low` to `high`: the sum of the stem's positions.
// Most hold that far.
template <class Real>
Real SlipTracker<Real>::go_on(Stem& stem, int first, Real low, Real high) {
  const int decimation = window_.decimation;
  if (!stem.moves && !(high > stem.upper) && !(low < stem.lower)) {
    stem.highest = std::max(stem.highest, high);
    stem.lowest = std::min(stem.lowest, low);
    return held(stem.position, decimation);
  }
  Real sum = 0;
  for (int k = 0; k < decimation; ++k) {
    move(stem, window_.u[first + k], first + k);
    sum += stem.position;
  }
  return sum;
}

// One sample of y: all stems move and foretell it (T1), those that are lost are replaced.
template <class Real>
void SlipTracker<Real>::follow(std::size_t t) {
  const State& s = now_;
  const std::size_t seen = t + static_cast<std::size_t>(delay_);
  const Real place =
      Real(2) * static_cast<Real>(seen) / static_cast<Real>(window_.y.size()) - Real(1);
  const Real y = window_.y[seen] - s.drift * place;
  const int decimation = window_.decimation;
  const Real share = Real(1) / static_cast<Real>(decimation);
  const int first = static_cast<int>(t) * decimation;
  const Real* const at = &window_.u[first];
  const Real slow = s.model.poles.slow;
  const Real fast = s.model.poles.fast;
  const Real gain = s.gain;
  const Real origin = s.origin;
  const Real correction = correction_;
  const Real sigma = sigma_;
  Real low = at[0];
  Real high = at[0];
  for (int k = 1; k < decimation; ++k) {
    low = std::min(low, at[k]);
    high = std::max(high, at[k]);
  }
  Stems& stems = *stems_;
  Real largest = std::numeric_limits<Real>::lowest();
  Real smallest = std::numeric_limits<Real>::max();
  for (int i = 0; i < kStems; ++i) {
    Stem& stem = stems[i];
    const Real sum = go_on(stem, first, low, high);
    stem.lagged = fast * stem.lagged + (Real(1) - fast) * sum * share;
    const Real output = slow * stem.output[0] + gain * (stem.lagged - origin);
    for (int lag = kOutputs - 1; lag > 0; --lag) {
      stem.output[lag] = stem.output[lag - 1];
    }
    stem.output[0] = output;
    const int late = static_cast<int>(stem.late);
    const Real older = stem.late - static_cast<Real>(late);
    const Real e =
        y - (Real(1) - older) * stem.output[late] - older * stem.output[late + 1];
    const Real z = std::abs(e) / sigma;
    const Real counted = std::min(z, Real(kOutlier));
    const Real weight = weight_[i] - counted * (z - counted / Real(2));
    weight_[i] = weight;
    largest = std::max(largest, weight);
    smallest = std::min(smallest, weight);
    stem.output[0] = output + correction * e;
  }
  for (Real& weight : weight_) {
    weight -= largest;
  }
  if (!(smallest - largest > Real(kAllAlike))) {
    replace_lost();
  }
}

template <class Real>
int SlipTracker<Real>::followed_at_once() const {
  return std::max(kMostOfPiece / (kStems * (kPerOutput + kPerMove * window_.decimation)),
                  1);
}

template <class Real>
void SlipTracker<Real>::follow_some() {
  const std::size_t delay = static_cast<std::size_t>(delay_);
  const int at_once = followed_at_once();
  replaced_ = 0;
  for (int i = at_once; i > 0 && next_ + delay < used_; --i) {
    follow(next_++);
  }
  const int per_stem = kPerOutput + kPerMove * window_.decimation;
  cost_ = (at_once * kStems * per_stem + replaced_ * kPerReplaced) / 1000 + 1;
  if (next_ + delay >= used_) {
    begin_fits();
  }
}

template <class Real>
bool SlipTracker<Real>::step() {
  cost_ =
      static_cast<int>(window_.u.size() * kPerLaid + window_.y.size() * kPerFiltered) /
          1000 +
      1;
  switch (doing_) {
    case Doing::kFollow:
      follow_some();
      return false;
    case Doing::kFilter:
      if (!laid_) {
        lay_path(found_, point_[0]);
        laid_ = true;
      }
      regress(poles_, first_fit_ ? every_delay(window_)
                                 : delays_near(window_, now_.model.fit.delay));
      return false;
    case Doing::kRegress:
      cost_ = regression_->cost_of_step();
      if (!regression_->step()) {
        return false;
      }
      if (measuring_) {
        return true;
      }
      take_fit();
      return false;
    case Doing::kFinish:
      finish_round();
      break;
  }
  return true;
}

template class SlipTracker<float>;
template class SlipTracker<double>;

}  // namespace ident
