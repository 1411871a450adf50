// One valve and its process over a window, in pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "ident/base/residual_structure.hpp"
#include "ident/process/process_regression.hpp"
#include "ident/process/process_simulation.hpp"
#include "ident/valve/stick_slip_valve.hpp"
#include "ident/valve/valve_model.hpp"

namespace ident {

/// All that is ever asked of a model of a valve: where its stem stands, which process is
/// the best behind it, what both make of y.
///
/// Life: `start` on a window; then one of `place`, `fit`, `fit_next`, `screen`,
/// `simulate` and `explain`, and `step` until `done`, as often as wanted. No piece takes
/// more than about 100 thousand instructions of a Cortex-M4F. Memory: that of a
/// ProcessRegression and about 200 numbers; the samples are the caller's.
template <class Real>
class ValvePass {
 public:
  /// `x` and `scratch` have the length of window.y; all spans must outlive the passes.
  /// The whole window is used.
  void start(const SearchWindow<Real>& window, std::span<Real> x,
             std::span<Real> scratch);
  /// From the next pass on only the first `samples` ≤ window.y.size() of y are used.
  void use(std::size_t samples) { used_ = samples; }
  [[nodiscard]] std::size_t used() const { return used_; }

  /// Stem positions, averaged to the rate of y.
  void place(const ValveModel<Real>& model);
  /// The same, then the process solved: dead times near the model's, or all of them.
  void fit(const ValveModel<Real>& model, bool all_delays);
  /// The same near the model's dead time, right after another fit: where only the process
  /// differs, the positions are those.
  void fit_next(const ValveModel<Real>& model);
  /// A quick look at a process behind the positions that are there.
  void screen(const ProcessPoles<Real>& poles);
  /// The process solved, all dead times, behind positions that its caller laid there.
  void fit_laid(const ProcessPoles<Real>& poles);
  /// Stem positions, what the model makes of y, and as the error of its fit what least
  /// squares only estimates.
  void simulate(const ValveModel<Real>& model);
  /// The same, then how far from white noise the residual is.
  void explain(const ValveModel<Real>& model);

  /// One piece; returns what it took, thousands of instructions of a Cortex-M4F.
  int step();
  [[nodiscard]] bool done() const { return stage_ == Stage::kDone; }
  /// Goes on until it is done or nothing is left; true when done.
  bool run(int& left);

  /// The model of the pass, with what was found; when done.
  [[nodiscard]] const ValveModel<Real>& model() const { return model_; }
  /// ResidualStructure; after `explain`.
  [[nodiscard]] Real structure() const { return structure_.value(); }
  /// After `simulate` or `explain`.
  [[nodiscard]] std::span<const Real> simulated() const { return scratch_.first(used_); }
  /// After each but `screen`.
  [[nodiscard]] std::span<Real> positions() { return x_.first(used_); }

  /// The valve of a model as it stands before the first sample of the window.
  [[nodiscard]] StickSlipValve<Real> valve_at_start(const ValveModel<Real>& model) const;
  [[nodiscard]] const SearchWindow<Real>& window() const { return window_; }
  /// Free for others between two passes.
  [[nodiscard]] ProcessRegression<Real>& regression() { return regression_; }
  [[nodiscard]] const ProcessRegression<Real>& regression() const { return regression_; }
  [[nodiscard]] ProcessSimulation<Real>& simulation() { return simulation_; }

 private:
  enum class Stage : std::uint8_t { kPlace, kFit, kSimulate, kExplain, kDone };

  void begin(const ValveModel<Real>& model, Stage then, Stage at_last);
  int place_some();
  void placed();
  int simulate_some();
  int explain_some();

  SearchWindow<Real> window_;
  std::span<Real> x_;
  std::span<Real> scratch_;
  std::size_t used_ = 0;
  std::size_t next_ = 0;  // sample of y
  ValveModel<Real> model_;
  StickSlipValve<Real> valve_{{}, Real(0)};
  ProcessRegression<Real> regression_;
  ProcessSimulation<Real> simulation_;
  ResidualStructure<Real> structure_;
  DelayRange delays_;
  Stage stage_ = Stage::kDone;
  Stage then_ = Stage::kDone;     // after the positions
  Stage at_last_ = Stage::kDone;  // after the simulation
};

}  // namespace ident
