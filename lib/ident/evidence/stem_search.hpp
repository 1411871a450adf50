// Which sticking valve foretells y best one sample ahead, whatever its strokes.
#pragma once

#include <array>
#include <cstdint>

#include "ident/base/pattern_search.hpp"
#include "ident/valve/stick_slip_valve.hpp"

namespace ident {

/// A sticking valve and where its stem stands before the first sample; unit of u.
template <class Real>
struct FoundStem {
  bool known = false;
  Real nats = 0;    ///< by which its stem foretells y better than u does, before any cost
  int strokes = 0;  ///< how often it turned back
  ValveFriction<Real> friction;  ///< it slides until u turns
  Real start = 0;                ///< its position

  [[nodiscard]] StickSlipValve<Real> valve() const { return {friction, start}; }
};

/// A stem that turns back less often moves by chance when something happens.
inline constexpr int kFewestStrokes = 8;

/// Nats by which a stem may be behind the best one and still be the valve's: the surface
/// is rugged, so that the true valve is seldom hit. Calibrated on loops under real loads.
inline constexpr double kNearNats = 20;

/// Stick bands of a stroke that are nearly as good as the best, unit of u.
template <class Real>
struct BandReach {
  Real low = 0;
  Real high = 0;
};

/// Proposes valves whose stems are to be weighed (closed_loop_evidence.hpp), and takes
/// what they weigh: the grid of valves that slide (valve_grid.hpp), then pattern search
/// over deadband, both slip jumps and the start around the best of them that are unlike.
/// Where no valve of the grid is worth it, the search ends with the grid. docs/model.md
/// (E13).
///
/// Life: `start`, then `proposed` → weigh → `report`, until `done`. At most 176 + 3 · 80
/// stems. Memory: 160 numbers.
template <class Real>
class StemSearch {
 public:
  /// `swing`: usual distance of two turning points of u. `first_u`: where u starts.
  /// `worth`: nats above which the best of the grid is looked at closely.
  void start(Real swing, Real first_u, Real worth);
  [[nodiscard]] bool done() const { return doing_ == Doing::kDone; }
  /// The next valve to weigh; only while not done.
  [[nodiscard]] const FoundStem<Real>& proposed() const { return tried_; }
  /// How many nats its stem has, and how often it turned back.
  void report(Real nats, int strokes);
  /// The best so far that turned back often enough.
  [[nodiscard]] const FoundStem<Real>& best() const { return best_; }
  /// Bands of either stroke among those tried that come near it.
  [[nodiscard]] const BandReach<Real>& ascending() const { return ascending_; }
  [[nodiscard]] const BandReach<Real>& descending() const { return descending_; }

 private:
  enum class Doing : std::uint8_t { kGrid, kPolish, kDone };
  static constexpr int kUnlike = 3;
  static constexpr int kPolishes = 80;

  void propose();
  void go_on();
  bool lay_of_grid();
  void lay_polished();
  void keep(const FoundStem<Real>& stem);
  void widen(const FoundStem<Real>& stem);
  void begin_polish(const FoundStem<Real>& from);

  PatternSearch<Real> pattern_;
  FoundStem<Real> tried_;  // what is proposed
  FoundStem<Real> best_;
  std::array<FoundStem<Real>, kUnlike> grid_;  // the best of it, sorted
  BandReach<Real> ascending_;
  BandReach<Real> descending_;
  Real swing_ = 0;
  Real first_u_ = 0;
  Real worth_ = 0;
  int index_ = 0;  // of the grid, or of its best
  Doing doing_ = Doing::kDone;
};

}  // namespace ident
