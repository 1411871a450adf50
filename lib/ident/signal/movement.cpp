#include "ident/signal/movement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ident/base/limits.hpp"
#include "ident/signal/reversals.hpp"

namespace ident {
namespace {

// Where u drifts further than it swings, not on a bare board: the retreats that are tried
// next, and the fewest samples a turning point, for noise turns more often.
constexpr std::array kSharesOfDrift = {0.15, 0.1};
constexpr std::size_t kSamplesATurn = 8;
// Not on a bare board, whose flash has no room for it: of an oscillation whose turning
// points are looked for though u drifts, as long as they are not more in a cycle than it
// can have.
constexpr double kNearlyRegular = 0.85;
constexpr double kMostTurns = 3;
constexpr std::size_t kFewTurns = 10;
constexpr std::size_t kMostReversals = kLeastSizes ? 128 : 256;

// Turning points of what swings on a drift, irregularly; `few` where there are not ten.
template <class Real>
std::size_t mark_on_drift(std::span<const Real> u, std::size_t few,
                          std::span<unsigned char> ascending,
                          std::span<Reversal<Real>> list) {
  for (const double share : kSharesOfDrift) {
    const std::size_t count = mark_directions<Real>(u, Real(share), ascending, list);
    if (count >= kFewTurns && count * kSamplesATurn < u.size()) {
      return count;
    }
  }
  mark_directions<Real>(u, Real(kReversalShare), ascending, list);
  return few;
}

// (M1)
template <class Real>
std::size_t mark_turns(std::span<const Real> u,
                       const OscillationReport<Real>& oscillation, Real u_range,
                       std::span<unsigned char> ascending,
                       std::span<Reversal<Real>> list) {
  const Real samples = static_cast<Real>(u.size());
  const Real share = Real(kReversalShare);
  std::size_t count = mark_directions<Real>(u, share, ascending, list);
  const bool nearly =
      kStemSearch && count < kFewTurns && oscillation.regularity > Real(kNearlyRegular);
  if ((oscillation.detected || nearly) &&
      static_cast<Real>(count) < samples / oscillation.period_samples) {
    const Real swing = Real(2) * oscillation.amplitude / u_range;
    count = mark_directions<Real>(u, std::min(share, share * swing), ascending, list);
    if constexpr (kStemSearch) {
      const Real most = Real(kMostTurns) * samples / oscillation.period_samples;
      if (!oscillation.detected && static_cast<Real>(count) > most) {
        count = mark_directions<Real>(u, share, ascending, list);
      }
    }
  }
  if constexpr (kStemSearch) {
    if (!oscillation.detected && count < kFewTurns) {
      count = mark_on_drift<Real>(u, count, ascending, list);
    }
  }
  return count;
}

}  // namespace

template <class Real>
Movement<Real> measure_movement(std::span<const Real> u,
                                const OscillationReport<Real>& oscillation, Real u_range,
                                std::span<unsigned char> ascending) {
  std::array<Reversal<Real>, kMostReversals> found;
  const std::span<Reversal<Real>> list(found);
  const Real samples = static_cast<Real>(u.size());
  const std::size_t count = mark_turns<Real>(u, oscillation, u_range, ascending, list);
  Movement<Real> movement;
  movement.reversals = static_cast<int>(count);
  movement.period = samples / Real(4);
  const std::size_t listed = std::min(count, kMostReversals);
  // From here on each entry is the way to the next: in u and in samples.
  const std::size_t ways = std::max<std::size_t>(listed, 1) - 1;
  for (std::size_t k = 0; k < ways; ++k) {
    found[k].value = std::abs(found[k + 1].value - found[k].value);
    found[k].index = found[k + 1].index - found[k].index;
  }
  if constexpr (kStrokePace) {
    movement.pace = measure_pace<Real>(std::span(found).first(ways));
  }
  const auto median = [&] {
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(ways / 2);
    std::nth_element(found.begin(), middle,
                     found.begin() + static_cast<std::ptrdiff_t>(ways),
                     [](const auto& a, const auto& b) { return a.value < b.value; });
    return middle->value;
  };
  if (listed > 1) {
    movement.swing = median();
  }
  if (oscillation.detected) {
    movement.period = oscillation.period_samples;
  } else if (listed > 3) {
    for (std::size_t k = 0; k < ways; ++k) {
      found[k].value = static_cast<Real>(found[k].index);
    }
    movement.period = Real(2) * median();
  }
  movement.period = std::clamp(movement.period, Real(4), samples / Real(1.5));
  movement.cycles = oscillation.detected ? samples / oscillation.period_samples
                                         : static_cast<Real>(count) / Real(2);
  return movement;
}

template <class Real>
bool turns_in_cycles(std::span<const Real> signal,
                     const OscillationReport<Real>& oscillation, Real amplitude) {
  ReversalTracker<Real> tracker(Real(kReversalShare) * Real(2) * amplitude);
  int turns = 0;
  for (const Real value : signal) {
    turns += tracker.push(value).has_value() ? 1 : 0;
  }
  // Two a cycle, but for some that are lost on a drift.
  return turns >= oscillation.cycles;
}

template <class Real>
std::size_t first_return(std::span<const Real> u,
                         std::span<const unsigned char> ascending, Real period) {
  constexpr Real kOffPeriod = Real(0.02);  // weight of coming back early or late
  if (!(static_cast<Real>(u.size()) > Real(3) * period)) {
    return 0;
  }
  std::size_t best = 0;
  Real nearest = 0;
  const std::size_t last = static_cast<std::size_t>(period * Real(1.3));
  for (std::size_t k = static_cast<std::size_t>(period * Real(0.75)); k < last; ++k) {
    // A turning point ends a stroke: what counts is where u goes from there.
    if (ascending[k + 1] != ascending[1]) {
      continue;
    }
    const Real off_period = std::abs(static_cast<Real>(k) - period) / period;
    const Real distance = std::abs(u[k] - u[0]) + kOffPeriod * off_period;
    if (best == 0 || distance < nearest) {
      nearest = distance;
      best = k;
    }
  }
  return best;
}

#define STICKBAND_INSTANTIATE(Real)                                                    \
  template Movement<Real> measure_movement<Real>(std::span<const Real>,                \
                                                 const OscillationReport<Real>&, Real, \
                                                 std::span<unsigned char>);            \
  template bool turns_in_cycles<Real>(std::span<const Real>,                           \
                                      const OscillationReport<Real>&, Real);           \
  template std::size_t first_return<Real>(std::span<const Real>,                       \
                                          std::span<const unsigned char>, Real);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
