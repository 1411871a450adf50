// A process that follows faster one way than the other, in the place of a valve.
#pragma once

#include <span>

#include "ident/base/pattern_search.hpp"
#include "ident/valve/valve_search.hpp"

namespace ident {

/// (E22) The best process behind a valve that follows u, whose first lag depends on the
/// direction: a drive that coasts, a vessel that cools by itself. In a few turns of u it
/// leaves y behind at each of them, as a stem that sticks does.
///
/// Two lags, rising and falling, around those of the linear model, then a pattern search
/// over both, the second lag and where the first one stood; gain, dead time, offset and
/// drift are solved for each trial. Stops after any piece of a pass. Fixed memory; at
/// most kEvaluations passes.
template <class Real>
class DirectionalLag {
 public:
  static constexpr int kGrid = 5;
  static constexpr int kEvaluations = 120;

  /// Starts from the linear model that was found on `window`.
  void start(const ValveModel<Real>& linear, const SearchWindow<Real>& window);
  /// Goes on by about `budget` units; true when done. `search`: that of the window; the
  /// stem positions in its pass are overwritten.
  bool step(ValveSearch<Real>& search, int budget);
  /// Squared error of the best, like ProcessFit::error. Meaningful when done; 0: the
  /// process integrates, of which there is none.
  [[nodiscard]] Real error() const { return asks_ ? pattern_.best_value() : Real(0); }

 private:
  using Point = typename PatternSearch<Real>::Point;

  [[nodiscard]] bool done() const;
  void take(Real error);
  void lay(const SearchWindow<Real>& window, std::span<Real> x) const;

  PatternSearch<Real> pattern_;
  Point middle_{};  // of the grid
  Point tried_{};
  int index_ = 0;      // on the grid
  bool laid_ = false;  // the pass is the trial's
  bool asks_ = false;
};

}  // namespace ident
