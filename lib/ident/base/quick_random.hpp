// Random numbers for searches: same data, same answer.
#pragma once

#include <cstdint>

namespace ident {

/// A fixed sequence (Numerical Recipes' quick generator), good enough for trial points.
/// State: 4 bytes.
template <class Real>
class QuickRandom {
 public:
  /// Uniform in 0 … below 1, 24 bits.
  [[nodiscard]] Real uniform() {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<Real>(state_ >> 8) / Real(1 << 24);
  }
  /// Uniform in −1 … below 1.
  [[nodiscard]] Real symmetric() { return Real(2) * uniform() - Real(1); }
  /// Zero mean, unit variance, within ±3: near enough to a normal distribution.
  [[nodiscard]] Real normal() {
    const Real sum = uniform() + uniform() + uniform();
    return Real(2) * sum - Real(3);
  }

 private:
  std::uint32_t state_ = 1;
};

}  // namespace ident
