#include "ident/signal/storage.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ident {
namespace {

constexpr std::size_t kFewest = 64;
// The arithmetic must be finer than this share of the bends, or it makes lines itself.
constexpr double kFine = 0.1;
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
void StorageSearch<Real>::count_pieces() {
  const std::span<const Real> x = values_;
  const Real straight = differences_.straight;
  const Real same = differences_.same;
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
    if (std::abs(change) <= same) {
      ++held;
      continue;
    }
    ++changes;
    alone += std::abs(next) <= same ? 1 : 0;
    const Real steps = (x[t] - x[0]) / differences_.smallest;
    whole += std::abs(steps - std::round(steps)) < Real(kOffLattice) ? 1 : 0;
  }
  const Real count = static_cast<Real>(x.size());
  const Real moved = static_cast<Real>(changes);
  signal_.interpolated = static_cast<Real>(inside) / count;
  signal_.held = static_cast<Real>(held) / count;
  if (same < Real(kFine) * differences_.bend && signal_.interpolated > Real(kMuch)) {
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
      differences_ = measure_differences<Real>(values_);
      stage_ = differences_.bend > Real(0) ? Stage::kPieces : Stage::kDone;
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
