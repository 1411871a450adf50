// One valve with its process, moved to where the simulation fits best.
#pragma once

#include "ident/base/pattern_search.hpp"
#include "ident/base/quick_random.hpp"
#include "ident/valve/valve_form.hpp"
#include "ident/valve/valve_model.hpp"

namespace ident {

/// Local search over deadband, slips, two time constants and the start of the stem, in
/// the directions that a form of valve allows.
///
/// A pattern search; for the mixed valve, and every valve with a memory, every other
/// proposal is a random jump, shorter as the polish goes on, because the error has many
/// local minima where a valve loses step. An integrating process stays one and no other
/// becomes one: on a few cycles, or with the wrong valve, both do as well. Life: `start`,
/// then `propose` → evaluate → `report`, until `done`. A fixed sequence of random
/// numbers: same data, same answer. Fixed memory.
template <class Real>
class ValvePolish {
 public:
  static constexpr int kEvaluations = 200;  ///< of a usual polish

  static constexpr double kFarJumps = 0.12;    ///< as a share of the swing of u
  static constexpr double kGrownJumps = 0.02;  ///< of one that suits the first cycles
  static constexpr double kNearJumps = 0.01;   ///< where the start is nearly right

  /// `model` has its error; at most `evaluations` ≤ kEvaluations proposals.
  void start(ValveForm form, const ValveModel<Real>& model,
             const SearchWindow<Real>& window, int evaluations, Real jumps);
  [[nodiscard]] bool done() const { return pattern_.done(); }
  /// The next model to evaluate, within its bounds; only while not done.
  [[nodiscard]] ValveModel<Real> propose();
  /// Takes it back with its process and its error solved.
  void report(const ValveModel<Real>& model);
  [[nodiscard]] const ValveModel<Real>& best() const { return best_; }

 private:
  using Point = typename PatternSearch<Real>::Point;

  [[nodiscard]] Point jump();
  [[nodiscard]] Point to_point(const ValveModel<Real>& model) const;
  [[nodiscard]] ValveModel<Real> model_at(const Point& point) const;
  void clamp(Point& point) const;

  PatternSearch<Real> pattern_;
  ValveModel<Real> best_;
  Point proposed_{};
  Real swing_ = 1;    // of u
  Real longest_ = 1;  // time constant, samples of y
  Real reach_ = 0;    // of random jumps at first
  ValveForm form_ = ValveForm::kLinear;
  bool jumps_ = false;   // the form is one for random jumps
  bool jumped_ = false;  // the present proposal is one
  QuickRandom<Real> random_;
};

}  // namespace ident
