// Two numbers side by side: sums of which the processor makes two at a time.
#pragma once

#include <cstring>

namespace ident {

/// Two numbers with + and × by element, {first, second} and [0], [1]. What is added up in
/// the two halves of a Pair is the same on every target, to the last bit; where there are
/// vector registers it takes half the instructions.
#if defined(__SSE2__) || defined(__aarch64__)
template <class Real>
struct PairOf {
  using Type [[gnu::vector_size(2 * sizeof(Real))]] = Real;
};
template <class Real>
using Pair = typename PairOf<Real>::Type;
#else
template <class Real>
struct Pair {
  Real half[2];

  Real operator[](int k) const { return half[k]; }
  friend Pair operator+(Pair a, Pair b) {
    return {a.half[0] + b.half[0], a.half[1] + b.half[1]};
  }
  friend Pair operator*(Pair a, Pair b) {
    return {a.half[0] * b.half[0], a.half[1] * b.half[1]};
  }
  Pair& operator+=(Pair other) { return *this = *this + other; }
};
#endif

/// values[0] and values[1].
template <class Real>
[[nodiscard]] inline Pair<Real> pair_at(const Real* values) {
#if defined(__SSE2__) || defined(__aarch64__)
  Pair<Real> out;
  std::memcpy(&out, values, sizeof out);
  return out;
#else
  return {values[0], values[1]};
#endif
}

/// Both halves added up.
template <class Real>
[[nodiscard]] inline Real sum_of(Pair<Real> pair) {
  return pair[0] + pair[1];
}

}  // namespace ident
