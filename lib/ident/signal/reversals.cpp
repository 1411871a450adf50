#include "ident/signal/reversals.hpp"

namespace ident {

template <class Real>
std::optional<Reversal<Real>> ReversalTracker<Real>::push(Real u) {
  const std::size_t now = next_++;
  if (now == 0) {
    low_ = high_ = u;
    return std::nullopt;
  }
  if (u > high_) {
    high_ = u;
    high_at_ = now;
  }
  if (u < low_) {
    low_ = u;
    low_at_ = now;
  }
  if (direction_ >= 0 && high_ - u > threshold_) {
    const Reversal<Real> found{high_at_, high_, true};
    const bool rose = direction_ > 0;
    direction_ = -1;
    low_ = u;
    low_at_ = now;
    return rose ? std::optional(found) : std::nullopt;
  }
  if (direction_ <= 0 && u - low_ > threshold_) {
    const Reversal<Real> found{low_at_, low_, false};
    const bool fell = direction_ < 0;
    direction_ = 1;
    high_ = u;
    high_at_ = now;
    return fell ? std::optional(found) : std::nullopt;
  }
  return std::nullopt;
}

template <class Real>
std::size_t mark_directions(std::span<const Real> u, Real threshold,
                            std::span<unsigned char> ascending,
                            std::span<Reversal<Real>> found) {
  ReversalTracker<Real> tracker(threshold);
  std::size_t count = 0;
  std::size_t marked = 0;
  for (std::size_t t = 0; t < u.size(); ++t) {
    const auto reversal = tracker.push(u[t]);
    if (!reversal) {
      continue;
    }
    for (; marked <= reversal->index; ++marked) {
      ascending[marked] = reversal->maximum ? 1 : 0;
    }
    if (count < found.size()) {
      found[count] = *reversal;
    }
    ++count;
  }
  const bool rising = tracker.direction() > 0 ||
                      (tracker.direction() == 0 && u.size() > 1 && u.back() > u.front());
  for (; marked < u.size(); ++marked) {
    ascending[marked] = rising ? 1 : 0;
  }
  return count;
}

#define STICKBAND_INSTANTIATE(Real)           \
  template class ReversalTracker<Real>;       \
  template std::size_t mark_directions<Real>( \
      std::span<const Real>, Real, std::span<unsigned char>, std::span<Reversal<Real>>);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
