#include "ident/signal/seam.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ident {
namespace {

// How many times further than anywhere else both signals jump at a seam.
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
  const auto end = at.begin() + static_cast<std::ptrdiff_t>(count);
  return std::find(at.begin(), end, t) != end;
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
  stage_ = u.size() < kFewest ? Stage::kDone : Stage::kMoves;
}

// The m largest moves of u and of y at the same m places.
template <class Real>
void SeamSearch<Real>::find_moves() {
  Moves of_u;
  Moves of_y;
  for (std::size_t t = 1; t < u_.size(); ++t) {
    of_u.take(std::abs(u_[t] - u_[t - 1]), t);
    of_y.take(std::abs(y_[t] - y_[t - 1]), t);
  }
  for (std::size_t count = 1; count <= Seams<Real>::kMost; ++count) {
    const Real clear = std::min(of_u.clearness(count), of_y.clearness(count));
    bool same = clear > Real(kClear);
    for (std::size_t k = 0; same && k < count; ++k) {
      const std::size_t t = of_u.at[k];
      same = of_y.among_first(count, t) && stays(u_, t) && stays(y_, t);
    }
    if (same) {
      seams_.count = count;
      seams_.sureness = clear;
      std::copy_n(of_u.at.begin(), count, seams_.at.begin());
      std::sort(seams_.at.begin(),
                seams_.at.begin() + static_cast<std::ptrdiff_t>(count));
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

// Takes away the jumps of u that answer those of y.
template <class Real>
void SeamSearch<Real>::check_law() {
  const ControllerAction<Real>& law = law_.action();
  if (law.sign == 0) {
    return;
  }
  const auto error = [&](std::size_t t) {
    return (sp_.empty() ? Real(0) : sp_[t]) - y_[t];
  };
  const auto answers = [&](std::size_t t) {
    const Real jump = u_[t] - u_[t - 1];
    const Real due = (law.proportional + law.integral) * (error(t) - error(t - 1));
    return std::abs(jump - due) < Real(kLeft) * std::abs(jump);
  };
  std::size_t left = 0;
  for (std::size_t k = 0; k < seams_.count; ++k) {
    if (!answers(seams_.at[k])) {
      seams_.at[left++] = seams_.at[k];
    }
  }
  seams_.count = left;
  seams_.sureness = left > 0 ? seams_.sureness : Real(0);
  measure_parts();
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
        check_law();
        stage_ = Stage::kDone;
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
