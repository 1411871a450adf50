// The part of the tracker that makes its bundle of stems and replaces those that are
// lost.
#include <algorithm>
#include <cmath>

#include "ident/base/elementary.hpp"
#include "ident/valve/slip_tracker.hpp"

namespace ident {
namespace {

// Stems are told apart by residuals of this many misfits; less would trust a wrong model.
constexpr double kMisfits = 1.2;
constexpr double kLeastSigma = 0.02;  // of the standard deviation of y
constexpr double kStartSpread = 0.7;
// For a bundle as wide as the stick band: how far copies leave the deadband (as a share
// of that band) and the dead time (in samples) of a stem, how far dead times differ at
// first, and by what share of the swing of u the bounds of a slip widen at each.
constexpr double kDeadbandJitter = 0.27;
constexpr double kDelayJitter = 0.45;
constexpr double kDelaySpread = 3;
constexpr double kWidening = 0.06;
// Bands differ by at least this share, however narrow the bundle.
constexpr double kLeastReach = 0.04;

}  // namespace

template <class Real>
void SlipTracker<Real>::begin_round(Real spread) {
  now_ = best_;
  spread_ = spread;
  sigma_ = std::max(Real(kMisfits) * best_.misfit, Real(kLeastSigma));
  const ValveFriction<Real>& friction = now_.model.friction;
  widest_ = std::max(friction.stick_ascending(), friction.stick_descending());
  widening_ = Real(kWidening) * spread * window_.swing;
  reach_ = std::max(spread, Real(kLeastReach)) * widest_;
  const Real reach = reach_;
  least_deadband_ = std::max(friction.deadband - reach, Real(0));
  most_deadband_ = friction.deadband + reach;
  const ProcessFit<Real>& fit = now_.model.fit;
  const Real steady = fit.gain_a + fit.gain_b;
  const Real delay =
      static_cast<Real>(fit.delay) + (steady > Real(0) ? fit.gain_b / steady : Real(0));
  delay_ = std::max(static_cast<int>(delay + Real(0.5)) - 1, 0);
  int index = 0;
  for (Stem& stem : *stems_) {
    // Spread evenly, each in its own order.
    const auto place = [&](Real step) {
      const Real turns = static_cast<Real>(index) * step;
      return turns - std::floor(turns);
    };
    stem.deadband =
        least_deadband_ + place(Real(0.618034)) * (most_deadband_ - least_deadband_);
    stem.late = std::clamp(
        delay - static_cast<Real>(delay_) +
            Real(kDelaySpread) * spread * (Real(2) * place(Real(0.754878)) - Real(1)),
        Real(0), Real(kOutputs - 1) - Real(0.001));
    ValveFriction<Real> own = friction;
    own.deadband = stem.deadband;
    stem.start = stem.slipped_at =
        resting_range(own, window_.u[0])
            .at((static_cast<Real>(index) + random_.uniform()) / Real(kStems));
    stem.direction = 0;
    stem.moves = false;
    stem.slips = 0;
    stem.least[0] = std::max(friction.slip_ascending - reach, Real(0));
    stem.least[1] = std::max(friction.slip_descending - reach, Real(0));
    stem.most[0] = friction.slip_ascending + reach;
    stem.most[1] = friction.slip_descending + reach;
    stem.highest = stem.lowest = window_.u[0];
    release(stem);
    stem.lagged = stem.slipped_at;
    const Real output =
        window_.y[delay_] + Real(kStartSpread) * sigma_ * random_.normal();
    for (Real& value : stem.output) {
      value = output;
    }
    ++index;
  }
  weight_.fill(Real(0));
  next_ = 0;
  used_ = window_.y.size();
  replaced_ = 0;
  measuring_ = false;
  doing_ = Doing::kFollow;
}

// Copies must differ, or the bundle is one stem soon.
template <class Real>
void SlipTracker<Real>::vary(Stem& stem) {
  stem.deadband = std::clamp(
      stem.deadband + Real(kDeadbandJitter) * spread_ * widest_ * random_.normal(),
      least_deadband_, most_deadband_);
  stem.late = std::clamp(stem.late + Real(kDelayJitter) * spread_ * random_.normal(),
                         Real(0), Real(kOutputs - 1) - Real(0.001));
  release(stem);
}

// Stems are replaced when few of them count.
template <class Real>
void SlipTracker<Real>::replace_lost() {
  std::array<Real, kStems> likelihood;
  elementary::exp_of_negative(weight_, likelihood);
  Real total = 0;
  Real squares = 0;
  for (const Real w : likelihood) {
    total += w;
    squares += w * w;
  }
  if (total * total < Real(0.5) * Real(kStems) * squares) {
    resample(likelihood, total);
  }
}

// Systematic resampling in place: stems that are drawn more than once fill the places of
// those that are not drawn.
template <class Real>
void SlipTracker<Real>::resample(const std::array<Real, kStems>& likelihood, Real total) {
  Stems& stems = *stems_;
  std::array<std::uint8_t, kStems> copies{};
  const Real first = random_.uniform();
  Real reached = 0;
  int drawn = 0;
  for (int i = 0; i < kStems; ++i) {
    reached += likelihood[i] / total * Real(kStems);
    while (drawn < kStems && static_cast<Real>(drawn) + first < reached) {
      ++copies[i];
      ++drawn;
    }
  }
  int lost = 0;
  for (int i = 0; i < kStems; ++i) {
    for (; copies[i] > 1; --copies[i]) {
      while (lost < kStems && copies[lost] != 0) {
        ++lost;
      }
      if (lost == kStems) {
        break;
      }
      stems[lost] = stems[i];
      vary(stems[lost]);
      copies[lost] = 1;
      ++replaced_;
    }
  }
  weight_.fill(Real(0));
}

#define STICKBAND_INSTANTIATE(Real)                   \
  template void SlipTracker<Real>::begin_round(Real); \
  template void SlipTracker<Real>::replace_lost();
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
