// Whether a stem speaks in all of a window, or in one place.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace ident {

/// Equal parts of the predicted samples, each with what a stem takes from the squared
/// error of predicting by u: docs/model.md (E14).
///
/// Life: `set` for each part, `less` once for each part, `without_excess`. Memory: kCount
/// numbers.
template <class Real>
class SpokenParts {
 public:
  static constexpr std::size_t kCount = 20;
  /// A part counts for no more than so many of the others.
  static constexpr double kMostOfOne = 3;

  /// The squared error in `part` of predicting by u.
  void set(std::size_t part, Real error) { gains_[part] = error; }
  /// And by the stem.
  void less(std::size_t part, Real error) { gains_[part] -= error; }

  /// Of `nats` those that are left when the part that says most counts for no more than
  /// kMostOfOne of the others. None where nothing but that part speaks for the stem.
  [[nodiscard]] Real without_excess(Real nats) const {
    const Real sum = std::accumulate(gains_.begin(), gains_.end(), Real(0));
    const Real most = *std::max_element(gains_.begin(), gains_.end());
    const Real others = (sum - most) / static_cast<Real>(kCount - 1);
    const Real excess = most - Real(kMostOfOne) * std::max(others, Real(0));
    if (!(excess > Real(0))) {
      return nats;
    }
    return excess < sum ? nats * (Real(1) - excess / sum) : std::min(nats, Real(0));
  }

 private:
  std::array<Real, kCount> gains_{};
};

}  // namespace ident
