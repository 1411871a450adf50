// What the values of one signal tell before any model: resolution, limits, shape.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace ident {

/// Distance of the levels that the values lie on, 0 where no such lattice is seen or it
/// has more than 100 levels. Life: start → step until true → value. Cost: one sort.
template <class Real>
class LevelStep {
 public:
  /// Sorts `values` in place; they must outlive the work.
  void start(std::span<Real> values);
  /// A part of the sort, or a pass over the sorted values; true when done.
  bool step();
  [[nodiscard]] Real value() const { return value_; }

 private:
  enum class Stage : std::uint8_t { kHeap, kSort, kLevels, kLattice, kDone };

  void find_levels();
  void check_lattice();

  std::span<Real> values_;
  std::size_t heap_ = 0;  // values that are still a heap
  Real value_ = 0;
  Stage stage_ = Stage::kDone;
};

/// Share of the samples, 0 … 1, that the signal spends in rests of two samples or more
/// at its lowest or its highest value: a controller output at its limit. 0 where it rests
/// half as long between them, for 20 samples or more each time: steps by hand. That is
/// not asked in the small sizes. Two passes.
template <class Real>
[[nodiscard]] Real share_at_limits(std::span<const Real> values);

/// Share of the samples at the lowest or the highest value, where that is met, for
/// however short a time, at least five times and in every second of `cycles`: the
/// extremes of a signal that turns by itself differ, unless it is rounded. Three passes.
template <class Real>
[[nodiscard]] Real share_of_touches(std::span<const Real> values, Real cycles);

/// Whether the signal rests but for a few moves, at most one in fifty samples: steps by
/// hand, of which what they move knows nothing beforehand. One pass.
template <class Real>
[[nodiscard]] bool moves_rarely(std::span<const Real> values);

/// Kurtosis: 1 for a square wave, 1.5 for a sinusoid of constant size, 3 for a normal
/// distribution, and so for a resonance that noise keeps ringing. 0 where the values do
/// not differ. Two passes.
template <class Real>
[[nodiscard]] Real kurtosis(std::span<const Real> values);

}  // namespace ident
