// A wandering load against a valve that sticks.
//
// Where few setpoint steps move a loop, a load that wanders between them moves u and not
// y, for the controller answers it: in the free simulation that looks like a stem at
// rest. The load has no such luck one sample ahead. Both rivals are therefore given a
// load of their own and compared on what of y neither foresees.
#pragma once

#include <cstdint>
#include <span>

#include "ident/pattern_search.hpp"
#include "ident/valve_search.hpp"

namespace ident {

/// Colour of a load under measurement noise: (1 − memory·q⁻¹) / (1 − smoothing·q⁻¹)
/// makes it white. 0 ≤ smoothing ≤ memory ≤ 1; both 0: it is white.
template <class Real>
struct LoadColour {
  Real memory = 0;
  Real smoothing = 0;
};

/// Filters a signal in place with what makes the load white, at rest before its first
/// sample. Cost: one pass.
template <class Real>
void whiten(const LoadColour<Real>& colour, std::span<Real> signal);

/// Refits the time constants and the load's colour of the linear valve, self-regulating
/// and integrating, and of a given valve, on the whitened error: three pattern searches
/// of at most kEvaluations passes each over the window of a search that is done.
///
/// Life: `start`, then `step` until true. Fixed memory.
template <class Real>
class LoadRival {
 public:
  static constexpr int kEvaluations = 120;

  void start();
  /// Goes on by about `budget` units; true when done. `valve` is the one to be doubted,
  /// the same at each call; `scratch` has the length of window.y and, as the search's
  /// positions, is overwritten.
  bool step(ValveSearch<Real>& search, const ValveModel<Real>& valve,
            std::span<Real> scratch, int budget);
  /// Whitened squared error of the linear valve, each with its load, over that of the
  /// other valve: about 1 where a load does as well. When done.
  [[nodiscard]] Real error_ratio() const { return ratio_; }

 private:
  using Point = typename PatternSearch<Real>::Point;
  enum class Job : std::uint8_t { kSelfRegulating, kIntegrating, kValve, kDone };

  void start_job(ValveSearch<Real>& search, const ValveModel<Real>& valve,
                 std::span<Real> scratch);
  [[nodiscard]] Real error_at(ValveSearch<Real>& search, const ValveModel<Real>& valve,
                              std::span<Real> scratch, Point& point) const;

  PatternSearch<Real> pattern_;
  Real linear_ = 0;  // lowest error of the linear valve so far
  Real ratio_ = 1;
  Job job_ = Job::kDone;
  bool started_ = false;  // the present job
};

}  // namespace ident
