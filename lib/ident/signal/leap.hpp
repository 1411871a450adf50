// How coarsely a signal may be thinned out before its quick moves are lost.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace ident {

/// How far `signal` travels within the liveliest of its blocks of `count` samples, and to
/// the first of the next, over the mean of all blocks in which it moves; 1 where it
/// rests. Oscillations and noise have 1 to 5, held or not. A kick that is over within a
/// block, as of a controller after a setpoint step, has more: the mean of its block does
/// not tell when it came. Cost: one pass.
template <class Real>
[[nodiscard]] Real leap(std::span<const Real> signal, std::size_t count) {
  Real most = 0;
  Real sum = 0;
  std::size_t moving = 0;
  const std::size_t blocks = signal.empty() ? 0 : (signal.size() - 1) / count;
  for (std::size_t i = 0; i < blocks; ++i) {
    const auto [low, high] = std::ranges::minmax(signal.subspan(i * count, count + 1));
    most = std::max(most, high - low);
    sum += high - low;
    moving += high > low ? 1 : 0;
  }
  return moving > 0 ? most * static_cast<Real>(moving) / sum : Real(1);
}

/// The largest of `most`, a half of it, a quarter, … 1 at which no leap of `signal` is
/// above 5.
template <class Real>
[[nodiscard]] std::size_t thinning_for(std::span<const Real> signal, std::size_t most) {
  constexpr Real kLively = 5;
  while (most > 1 && leap(signal, most) > kLively) {
    most /= 2;
  }
  return most;
}

}  // namespace ident
