#include "ident/signal/seam.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ident {
namespace {

// How many times further than anywhere else a signal jumps at a seam, or its law fails.
constexpr double kClear = 3;
// Samples on each side that must lie on their own side of the jump.
constexpr std::size_t kSide = 4;
// Share of the jump of u that the law may leave over where it explains it.
constexpr double kLeft = 0.5;
constexpr std::size_t kFewest = 16;

}  // namespace

template <class Real>
void SeamSearch<Real>::Moves::take(Real move, std::size_t t) {
  if (!(move > size[kKept - 1])) {
    return;
  }
  std::size_t place = kKept - 1;
  for (std::size_t k = kKept - 1; k > 0 && move > size[k - 1]; --k) {
    size[k] = size[k - 1];
    at[k] = at[k - 1];
    place = k - 1;
  }
  size[place] = move;
  at[place] = t;
}

template <class Real>
bool SeamSearch<Real>::Moves::among_first(std::size_t count, std::size_t t) const {
  bool found = false;
  for (std::size_t k = 0; k < count; ++k) {
    found = found || at[k] == t;
  }
  return found;
}

template <class Real>
Real SeamSearch<Real>::Moves::clearness(std::size_t count) const {
  return size[count] > Real(0) ? size[count - 1] / size[count] : Real(0);
}

// Whether the samples before and after the jump to `t` lie apart: no spike.
template <class Real>
bool SeamSearch<Real>::stays(std::span<const Real> x, std::size_t t) {
  const Real middle = (x[t - 1] + x[t]) / Real(2);
  const bool up = x[t] > x[t - 1];
  const std::size_t before = t - std::min(t, kSide);
  const std::size_t after = std::min(x.size(), t + kSide);
  for (std::size_t k = before; k < after; ++k) {
    if ((x[k] > middle) != ((k >= t) == up)) {
      return false;
    }
  }
  return true;
}

template <class Real>
void SeamSearch<Real>::start(std::span<const Real> u, std::span<const Real> y,
                             std::span<const Real> sp) {
  u_ = u;
  y_ = y;
  sp_ = sp;
  seams_ = {};
  seams_.length = u.size();
  u_jumps_ = false;
  stage_ = u.size() < kFewest ? Stage::kDone : Stage::kMoves;
}

// The m largest moves of y, and whether u has its own at the same m places.
template <class Real>
void SeamSearch<Real>::find_moves() {
  Moves of_u;
  Moves of_y;
  for (std::size_t t = 1; t < u_.size(); ++t) {
    of_u.take(std::abs(u_[t] - u_[t - 1]), t);
    of_y.take(std::abs(y_[t] - y_[t - 1]), t);
  }
  for (std::size_t count = 1; count <= Seams<Real>::kMost; ++count) {
    const Real clear = of_y.clearness(count);
    bool jumps = clear > Real(kClear);
    bool u_jumps = of_u.clearness(count) > Real(kClear);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t t = of_y.at[k];
      jumps = jumps && stays(y_, t);
      u_jumps = u_jumps && of_u.among_first(count, t) && stays(u_, t);
    }
    if (jumps && (u_jumps || !u_jumps_)) {
      u_jumps_ = u_jumps;
      seams_.count = count;
      seams_.sureness = clear;
      for (std::size_t k = 0; k < count; ++k) {
        seams_.at[k] = of_y.at[k];
        for (std::size_t j = k; j > 0; --j) {
          if (seams_.at[j] < seams_.at[j - 1]) std::swap(seams_.at[j], seams_.at[j - 1]);
        }
      }
    }
  }
}

template <class Real>
void SeamSearch<Real>::measure_parts() {
  seams_.first = 0;
  seams_.length = 0;
  std::size_t first = 0;
  for (std::size_t k = 0; k <= seams_.count; ++k) {
    const std::size_t end = k < seams_.count ? seams_.at[k] : u_.size();
    if (end - first > seams_.length) {
      seams_.first = first;
      seams_.length = end - first;
    }
    first = end;
  }
}

// Keeps the places at which u breaks with the law of the longest part.
template <class Real>
void SeamSearch<Real>::check_law() {
  const ControllerAction<Real>& law = law_.action();
  const auto error = [&](std::size_t t) {
    return (sp_.empty() ? Real(0) : sp_[t]) - y_[t];
  };
  const auto missed = [&](std::size_t t) {
    return u_[t] - u_[t - 1] - law.proportional * (error(t) - error(t - 1)) -
           law.integral * error(t);
  };
  Real usual = 0;
  const std::size_t end = seams_.first + seams_.length;
  for (std::size_t t = seams_.first + 1; t < end; ++t) {
    usual += missed(t) / static_cast<Real>(seams_.length - 1);
  }
  Moves misses;
  for (std::size_t t = 1; t < u_.size(); ++t) {
    misses.take(std::abs(missed(t) - usual), t);
  }
  const std::size_t count = seams_.count;
  const bool law_fails = misses.clearness(count) > Real(kClear);
  seams_.count = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t t = seams_.at[k];
    const bool jumps = u_jumps_ && std::abs(missed(t) - usual) >
                                       Real(kLeft) * std::abs(u_[t] - u_[t - 1]);
    if (jumps || (law_fails && misses.among_first(count, t))) {
      seams_.at[seams_.count++] = t;
    }
  }
}

template <class Real>
bool SeamSearch<Real>::step() {
  switch (stage_) {
    case Stage::kMoves: {
      find_moves();
      measure_parts();
      const auto part = [&](std::span<const Real> x) {
        return x.empty() ? x : x.subspan(seams_.first, seams_.length);
      };
      law_.start(part(u_), part(y_), part(sp_));
      stage_ = seams_.count > 0 ? Stage::kLaw : Stage::kDone;
      break;
    }
    case Stage::kLaw:
      if (law_.step()) {
        stage_ = Stage::kDone;
        if (law_.action().sign != 0) {
          check_law();
        } else if (!u_jumps_) {
          seams_.count = 0;
        }
        seams_.sureness = seams_.count > 0 ? seams_.sureness : Real(0);
        measure_parts();
      }
      break;
    case Stage::kDone:
      break;
  }
  return stage_ == Stage::kDone;
}

template <class Real>
Seams<Real> find_seams(std::span<const Real> u, std::span<const Real> y,
                       std::span<const Real> sp) {
  SeamSearch<Real> search;
  search.start(u, y, sp);
  while (!search.step()) {
  }
  return search.seams();
}

#define STICKBAND_INSTANTIATE(Real)                                                   \
  template class SeamSearch<Real>;                                                    \
  template Seams<Real> find_seams<Real>(std::span<const Real>, std::span<const Real>, \
                                        std::span<const Real>);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)
#undef STICKBAND_INSTANTIATE

}  // namespace ident
