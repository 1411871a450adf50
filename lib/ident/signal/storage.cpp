#include "ident/signal/storage.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ident {
namespace {

constexpr std::size_t kFewest = 64;
// A second difference below this share of the mean one is none, or, where the values are
// rounded, one of up to the second share.
constexpr double kStraight = 0.02;
constexpr double kRounded = 0.1;
// Samples in a row that make a line.
constexpr std::size_t kShortestLine = 3;
// Changes that make a held signal: fewer are the steps of an operator or a test.
constexpr std::size_t kFewestChanges = 16;
// Shares of the samples from which a signal counts as interpolated or held, and of the
// changes that stand alone.
constexpr double kMuch = 0.3;
constexpr double kAlone = 0.5;
// How far from whole multiples of the smallest change rounded values may lie from the
// first, and the share of the changes that must lead to such a value.
constexpr double kOffLattice = 0.1;
constexpr double kLattice = 0.8;

}  // namespace

template <class Real>
void StorageSearch<Real>::start(std::span<const Real> values) {
  values_ = values;
  signal_ = {};
  stage_ = values.size() < kFewest ? Stage::kDone : Stage::kDifferences;
}

template <class Real>
void StorageSearch<Real>::measure_differences() {
  const std::span<const Real> x = values_;
  Real largest = 0;
  for (const Real value : x) {
    largest = std::max(largest, std::abs(value));
  }
  same_ = Real(4) * std::numeric_limits<Real>::epsilon() * largest;
  bend_ = 0;
  smallest_ = std::numeric_limits<Real>::max();
  for (std::size_t t = 1; t + 1 < x.size(); ++t) {
    const Real change = std::abs(x[t] - x[t - 1]);
    bend_ += std::abs(x[t + 1] - Real(2) * x[t] + x[t - 1]);
    if (change > same_) {
      smallest_ = std::min(smallest_, change);
    }
  }
  bend_ /= static_cast<Real>(x.size() - 2);
}

template <class Real>
void StorageSearch<Real>::count_pieces() {
  const std::span<const Real> x = values_;
  const Real straight =
      std::max(Real(kStraight) * bend_,
               std::min(std::max(Real(2.02) * smallest_, same_), Real(kRounded) * bend_));
  std::size_t line = 0;
  std::size_t inside = 0;
  std::size_t held = 0;
  std::size_t changes = 0;
  std::size_t alone = 0;
  std::size_t whole = 0;
  for (std::size_t t = 1; t < x.size(); ++t) {
    const Real change = x[t] - x[t - 1];
    const bool last = t + 1 == x.size();
    const Real next = last ? Real(0) : x[t + 1] - x[t];
    if (!last && std::abs(next - change) <= straight && std::abs(change) > straight) {
      ++line;
      inside += line > kShortestLine ? 1 : (line == kShortestLine ? kShortestLine : 0);
    } else {
      line = 0;
    }
    if (std::abs(change) <= same_) {
      ++held;
      continue;
    }
    ++changes;
    alone += std::abs(next) <= same_ ? 1 : 0;
    const Real steps = (x[t] - x[0]) / smallest_;
    whole += std::abs(steps - std::round(steps)) < Real(kOffLattice) ? 1 : 0;
  }
  const Real count = static_cast<Real>(x.size());
  const Real moved = static_cast<Real>(changes);
  signal_.interpolated = static_cast<Real>(inside) / count;
  signal_.held = static_cast<Real>(held) / count;
  if (same_ < Real(kRounded) * bend_ && signal_.interpolated > Real(kMuch)) {
    signal_.storage = Storage::kInterpolated;
    signal_.points_apart = count / (count - static_cast<Real>(inside));
  } else if (signal_.held > Real(kMuch) && changes >= kFewestChanges &&
             static_cast<Real>(alone) > Real(kAlone) * moved &&
             static_cast<Real>(whole) < Real(kLattice) * moved) {
    signal_.storage = Storage::kHeld;
    signal_.points_apart = count / std::max(moved, Real(1));
  }
}

template <class Real>
bool StorageSearch<Real>::step() {
  switch (stage_) {
    case Stage::kDifferences:
      measure_differences();
      stage_ = bend_ > Real(0) ? Stage::kPieces : Stage::kDone;
      break;
    case Stage::kPieces:
      count_pieces();
      stage_ = Stage::kDone;
      break;
    case Stage::kDone:
      break;
  }
  return stage_ == Stage::kDone;
}

template <class Real>
StoredSignal<Real> find_storage(std::span<const Real> values) {
  StorageSearch<Real> search;
  search.start(values);
  while (!search.step()) {
  }
  return search.signal();
}

template <class Real>
bool was_compressed(const StoredSignal<Real>& u, const StoredSignal<Real>& y) {
  return y.storage == Storage::kInterpolated ||
         (u.storage == Storage::kInterpolated && y.held < Real(kMuch));
}

#define STICKBAND_INSTANTIATE(Real)                                      \
  template class StorageSearch<Real>;                                    \
  template StoredSignal<Real> find_storage<Real>(std::span<const Real>); \
  template bool was_compressed<Real>(const StoredSignal<Real>&,          \
                                     const StoredSignal<Real>&);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)
#undef STICKBAND_INSTANTIATE

}  // namespace ident
