// The direction of u by its turning points: equation (3), made robust to noise.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace ident {

/// A turning point of u, known only after u has retreated from it.
template <class Real>
struct Reversal {
  std::size_t index = 0;  ///< sample of the extreme itself
  Real value = 0;         ///< u at the extreme
  bool maximum = false;   ///< true: u falls from here on
};

/// Finds turning points with a zig-zag rule (M1): a new extreme, then a retreat larger
/// than the threshold, dates the reversal back to the extreme. The first extreme counts
/// only if u came to it from further away than the threshold: where a window begins in
/// the middle of a stroke, its first sample is no turning point. Taking h(t) of equation
/// (3) literally, noise on u would flip it at almost every sample. Cost of `push`:
/// constant. State: a few numbers.
template <class Real>
class ReversalTracker {
 public:
  /// `threshold` > 0, in units of u.
  explicit ReversalTracker(Real threshold) : threshold_(threshold) {}

  /// Takes the next sample; returns the turning point that it confirms, if any.
  std::optional<Reversal<Real>> push(Real u);

  /// Direction of the newest samples, as far as it is known: +1, −1, or 0.
  [[nodiscard]] int direction() const { return direction_; }

 private:
  Real threshold_;
  std::size_t next_ = 0;
  std::size_t low_at_ = 0;
  std::size_t high_at_ = 0;
  Real low_ = 0;
  Real high_ = 0;
  int direction_ = 0;
};

/// Marks every sample of a window ascending (1) or descending (0), and lists the
/// turning points in `found` as far as it has room. Returns how many there are.
/// Samples before the first turning point take the direction that led to it.
/// Cost: one pass.
template <class Real>
std::size_t mark_directions(std::span<const Real> u, Real threshold,
                            std::span<unsigned char> ascending,
                            std::span<Reversal<Real>> found);

}  // namespace ident
