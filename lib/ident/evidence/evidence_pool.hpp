// What the windows of one loop say together: one valve has to serve all of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "ident/evidence/closed_loop_evidence.hpp"

namespace ident {

/// The nats of every rung, added up over windows: docs/model.md (E11). The rungs are
/// bands in units of u, so the ladders must all have one span. A window in which a band
/// is too small to show says nothing about it; one whose swing never leaves it says
/// whether a stem that rests explains y; windows that want different bands speak against
/// each other's.
///
/// Life: `fade`, and `add` where the window says something, window by window → `finding`,
/// at any time. It is plain data: a copy is a memory. Memory: two bytes a rung and slip,
/// and eight more. A sum is kept to a quarter of a nat, up to ±8,191: what would make one
/// larger makes all that was known fade until it fits, or, where no stem is searched
/// (kStemSearch), for lack of flash, is cut off.
class EvidencePool {
 public:
  /// What it holds, to be kept over a restart.
  struct Memory {
    std::array<std::int16_t, kLadderValves> quarter_nats{};  ///< ≥ −32,767
    float windows = 0;                                       ///< finite, ≥ 0
    float predicted = 0;                                     ///< samples, finite, ≥ 0
  };

  EvidencePool() = default;
  explicit EvidencePool(const Memory& memory) : held_(memory) {}
  [[nodiscard]] const Memory& memory() const { return held_; }

  /// Keeps the share `keep` (0 … 1) of what was. A sum of less than 0.125/(1 − keep) nats
  /// rounds to itself.
  void fade(float keep);
  /// Adds `weight` times the ladder of a window of `predicted` samples: below 1 where
  /// windows overlap, so that no sample counts twice. A window that is too short (0)
  /// changes nothing.
  template <class Real>
  void add(const Ladder<Real>& ladder, std::size_t predicted, float weight = 1);
  /// The band that serves all windows best, in the unit of `span`. Its strokes and the
  /// detectable band are not known here.
  template <class Real>
  [[nodiscard]] LadderFinding<Real> finding(Real span) const;
  /// How many windows count, each by its weight.
  [[nodiscard]] float windows() const { return held_.windows; }

 private:
  Memory held_;
};

}  // namespace ident
