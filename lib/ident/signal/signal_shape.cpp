#include "ident/signal/signal_shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ident/base/limits.hpp"

namespace ident {
namespace {

// Nearer than this share of the range is the same value.
constexpr double kSame = 1e-5;
// More levels than this are as good as a continuum, and fewer samples for each level than
// this are no proof of a lattice.
constexpr std::size_t kMostLevels = 100;
constexpr std::size_t kFewestEach = 3;
// How far from a whole number of steps two levels may be apart, in steps.
constexpr double kOffLattice = 0.1;
constexpr std::size_t kShortestRest = 2;
constexpr std::size_t kSortedAtOnce = 256;
// Nobody steps by hand sooner; a historian seldom holds a controller output longer.
constexpr std::size_t kShortestStep = 20;

// Samples in rests between `low` and `high`: of a controller output that is stepped by
// hand, which rests at its highest and lowest level, too.
template <class Real>
std::size_t rests_between(std::span<const Real> values, Real low, Real high, Real same) {
  std::size_t resting = 0;
  std::size_t first = 0;
  for (std::size_t t = 1; t <= values.size(); ++t) {
    if (t < values.size() && std::abs(values[t] - values[first]) <= same) {
      continue;
    }
    const bool between = values[first] > low + same && values[first] < high - same;
    resting += between && t - first >= kShortestStep ? t - first : 0;
    first = t;
  }
  return resting;
}

}  // namespace

template <class Real>
void LevelStep<Real>::start(std::span<Real> values) {
  values_ = values;
  heap_ = values.size();
  value_ = 0;
  stage_ = values.empty() ? Stage::kDone : Stage::kHeap;
}

template <class Real>
bool LevelStep<Real>::step() {
  switch (stage_) {
    case Stage::kHeap:
      std::make_heap(values_.begin(), values_.end());
      stage_ = Stage::kSort;
      break;
    case Stage::kSort: {
      const std::size_t end = heap_ - std::min(heap_, kSortedAtOnce);
      for (; heap_ > end; --heap_) {
        std::pop_heap(values_.begin(),
                      values_.begin() + static_cast<std::ptrdiff_t>(heap_));
      }
      stage_ = heap_ > 0 ? Stage::kSort : Stage::kLevels;
      break;
    }
    case Stage::kLevels:
      find_levels();
      stage_ = value_ > Real(0) ? Stage::kLattice : Stage::kDone;
      break;
    case Stage::kLattice:
      check_lattice();
      stage_ = Stage::kDone;
      break;
    case Stage::kDone:
      break;
  }
  return stage_ == Stage::kDone;
}

// The smallest distance of two levels, 0 where there are too few or too many.
template <class Real>
void LevelStep<Real>::find_levels() {
  const Real same = (values_.back() - values_.front()) * Real(kSame);
  std::size_t levels = 1;
  value_ = values_.back() - values_.front();
  for (std::size_t t = 1; t < values_.size(); ++t) {
    const Real gap = values_[t] - values_[t - 1];
    if (gap > same) {
      ++levels;
      value_ = std::min(value_, gap);
    }
  }
  if (levels < 2 || levels > kMostLevels || kFewestEach * levels > values_.size()) {
    value_ = 0;
  }
}

// Whether all levels are whole steps apart.
template <class Real>
void LevelStep<Real>::check_lattice() {
  for (std::size_t t = 1; t < values_.size(); ++t) {
    const Real steps = (values_[t] - values_[t - 1]) / value_;
    if (std::abs(steps - std::round(steps)) > Real(kOffLattice)) {
      value_ = 0;
      return;
    }
  }
}

template <class Real>
Real share_at_limits(std::span<const Real> values) {
  if (values.empty()) {
    return 0;
  }
  const auto extremes = std::minmax_element(values.begin(), values.end());
  const Real low = *extremes.first;
  const Real high = *extremes.second;
  const Real same = (high - low) * Real(kSame);
  const auto limit = [=](Real value) {
    return value >= high - same ? 1 : (value <= low + same ? -1 : 0);
  };
  std::size_t resting = 0;
  std::size_t rest = 0;
  int at = 0;
  for (std::size_t t = 0; t <= values.size(); ++t) {
    const int now = t < values.size() ? limit(values[t]) : 0;
    if (now != at || t == values.size()) {
      resting += at != 0 && rest >= kShortestRest ? rest : 0;
      rest = 0;
      at = now;
    }
    ++rest;
  }
  if constexpr (!kSmallSizes) {
    if (2 * rests_between(values, low, high, same) >= resting) {
      return 0;
    }
  }
  return static_cast<Real>(resting) / static_cast<Real>(values.size());
}

template <class Real>
Real share_of_touches(std::span<const Real> values, Real cycles) {
  if (values.empty()) {
    return 0;
  }
  constexpr Real kFewest = Real(5);
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const Real fewest = std::max(cycles / Real(2), kFewest);
  const Real same = (*highest - *lowest) * Real(kSame);
  std::size_t touching = 0;
  for (const Real extreme : {*lowest, *highest}) {
    std::size_t samples = 0;
    std::size_t visits = 0;
    bool before = false;
    for (const Real value : values) {
      const bool now = std::abs(value - extreme) <= same;
      samples += now ? 1 : 0;
      visits += now && !before ? 1 : 0;
      before = now;
    }
    touching += static_cast<Real>(visits) >= fewest ? samples : 0;
  }
  return static_cast<Real>(touching) / static_cast<Real>(values.size());
}

template <class Real>
Real kurtosis(std::span<const Real> values) {
  const Real count = static_cast<Real>(values.size());
  // From the first value, so that equal ones leave exactly nothing.
  Real mean = 0;
  for (const Real value : values) {
    mean += (value - values[0]) / count;
  }
  Real square = 0;
  Real fourth = 0;
  for (const Real value : values) {
    const Real away = value - values[0] - mean;
    const Real distance = away * away;
    square += distance / count;
    fourth += distance * distance / count;
  }
  return square > Real(0) ? fourth / (square * square) : Real(0);
}

template <class Real>
bool moves_rarely(std::span<const Real> values) {
  constexpr std::size_t kRests = 50;
  std::size_t moves = 0;
  for (std::size_t t = 1; t < values.size(); ++t) {
    moves += values[t] != values[t - 1] ? 1 : 0;
  }
  return kRests * moves <= values.size();
}

#define STICKBAND_INSTANTIATE(Real)                                  \
  template class LevelStep<Real>;                                    \
  template Real share_at_limits<Real>(std::span<const Real>);        \
  template Real share_of_touches<Real>(std::span<const Real>, Real); \
  template bool moves_rarely<Real>(std::span<const Real>);           \
  template Real kurtosis<Real>(std::span<const Real>);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
