#include "ident/signal/storage.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ident/signal/differences.hpp"

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
// first, the share of the changes that must lead to such a value, and how many of the
// smallest they span at most in the mean: a signal that often moves by more than so many
// steps does not rest for their coarseness.
constexpr double kOffLattice = 0.1;
constexpr double kLattice = 0.8;
constexpr double kFewSteps = 8;

}  // namespace

StoredSignal find_storage(std::span<const double> x) {
  StoredSignal out;
  if (x.size() < kFewest) {
    return out;
  }
  const Differences differences = measure_differences(x);
  if (!(differences.bend > 0)) {
    return out;
  }
  const double straight = differences.straight;
  const double same = differences.same;
  std::size_t line = 0;
  std::size_t inside = 0;
  std::size_t held = 0;
  std::size_t changes = 0;
  std::size_t alone = 0;
  std::size_t whole = 0;
  double travel = 0;
  for (std::size_t t = 1; t < x.size(); ++t) {
    const double change = x[t] - x[t - 1];
    const bool last = t + 1 == x.size();
    const double next = last ? 0.0 : x[t + 1] - x[t];
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
    travel += std::abs(change);
    alone += std::abs(next) <= same ? 1 : 0;
    const double steps = (x[t] - x[0]) / differences.smallest;
    whole += std::abs(steps - std::round(steps)) < kOffLattice ? 1 : 0;
  }
  const double count = static_cast<double>(x.size());
  const double moved = static_cast<double>(changes);
  const bool coarse = static_cast<double>(whole) >= kLattice * moved &&
                      travel < kFewSteps * differences.smallest * moved;
  out.interpolated = static_cast<double>(inside) / count;
  out.held = static_cast<double>(held) / count;
  if (same < kFine * differences.bend && out.interpolated > kMuch) {
    out.storage = Storage::kInterpolated;
    out.points_apart = count / (count - static_cast<double>(inside));
  } else if (out.held > kMuch && changes >= kFewestChanges &&
             static_cast<double>(alone) > kAlone * moved && !coarse) {
    out.storage = Storage::kHeld;
    out.points_apart = count / std::max(moved, 1.0);
  }
  return out;
}

bool was_compressed(const StoredSignal& u, const StoredSignal& y) {
  return y.storage == Storage::kInterpolated ||
         (u.storage == Storage::kInterpolated && y.held < kMuch);
}

}  // namespace ident
