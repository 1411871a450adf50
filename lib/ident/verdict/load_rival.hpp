// A wandering load against a valve that sticks.
//
// Where few setpoint steps move a loop, a load that wanders between them moves u and not
// y, for the controller answers it: in the free simulation that looks like a stem at
// rest. The load has no such luck one sample ahead. Both rivals are therefore given a
// load of their own and compared on what of y neither foresees: docs/model.md, (E4).
#pragma once

#include <cstdint>
#include <span>

#include "ident/base/pattern_search.hpp"
#include "ident/valve/valve_search.hpp"

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

  enum class Doing : std::uint8_t { kNothing, kPlace, kWhiten, kRegress };

  [[nodiscard]] bool integrates(const ValveModel<Real>& valve) const;
  void evaluate(ValveSearch<Real>& search, const ValveModel<Real>& valve, Point point);
  int piece(ValveSearch<Real>& search, const ValveModel<Real>& valve,
            std::span<Real> scratch);
  void take(ValveSearch<Real>& search, const ValveModel<Real>& valve, Real error);
  void begin_pattern(const ValveModel<Real>& valve);
  void finish_job();

  PatternSearch<Real> pattern_;
  Point point_{};  // that is evaluated
  Point first_{};  // the better one to begin with, of those that were evaluated
  ProcessPoles<Real> poles_;
  Real first_error_ = 0;
  Real linear_ = 0;  // lowest error of the linear valve so far
  Real ratio_ = 1;
  Job job_ = Job::kDone;
  Doing doing_ = Doing::kNothing;
  int starts_ = 0;        // points that the present job has looked at to begin with
  bool started_ = false;  // its pattern search
};

}  // namespace ident
