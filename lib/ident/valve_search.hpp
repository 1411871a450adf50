// Which physical valve, if any, the data support, and how much it sticks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ident/pattern_search.hpp"
#include "ident/process_regression.hpp"
#include "ident/stick_slip_valve.hpp"
#include "ident/valve_form.hpp"
#include "ident/verdict.hpp"

namespace ident {

/// A valve with the process behind it, at the rate of the decimated window.
template <class Real>
struct ValveModel {
  bool known = false;
  ValveFriction<Real> friction;
  ProcessPoles<Real> poles;
  ProcessFit<Real> fit;
  bool start_known = false;  ///< false: the stem starts where one cycle would leave it
  Real start = 0;            ///< stem position before the first sample, scaled like u
};

/// The window that is searched, oldest sample first.
template <class Real>
struct SearchWindow {
  std::span<const Real> u;  ///< every sample, scaled to 0 … 1
  std::span<const Real> y;  ///< means of `decimation` samples, zero mean, unit variance,
                            ///< sign turned so that the process gain is positive
  int decimation = 1;       ///< samples of u for each of y
  Real period = 0;          ///< of the oscillation, in samples of y
  std::size_t warm_up = 0;  ///< samples of u in the first cycle: where u is next in the
                            ///< state it had at the start, 0 if unknown
  std::size_t first_part = 0;  ///< samples of y that hold the first few reversals of u
  Real swing = 1;              ///< usual distance of two turning points of u, scaled
  bool drift = true;           ///< allow a straight drift of y
};

/// Fits every form of valve on the simulation error.
///
/// A valve that slides on is fitted to the whole window at once: a grid of stick bands,
/// slip shares and time constants is screened, the best of each form polished by pattern
/// search over deadband, slips and two time constants, with gain, dead time, offset,
/// drift and start solved exactly for each trial.
///
/// A valve that stops or resticks remembers where it slipped. A trial that is slightly
/// wrong loses step with the real valve after some cycles and then fits no better than a
/// bad one. So it is fitted to the first cycles only, from many stem positions, and a
/// shrinking beam of candidates is polished again as the window grows, to the end.
///
/// The search can stop after any evaluation and resume: `start`, then `step` until
/// `done`. Memory: one number for each sample of y, and a few kilobytes. Bounds: at most
/// kMostCandidates screened valves of kTimeConstants passes (over the first cycles for
/// most), and kMostPolishes polishes of kPolishEvaluations passes.
template <class Real>
class ValveSearch {
 public:
  static constexpr int kMostCandidates = 4000;
  static constexpr int kMostPolishes = 60;
  static constexpr int kPolishEvaluations = 200;

  /// Starts on a window; `x` is scratch of the length of window.y. All spans must outlive
  /// the search.
  void start(const SearchWindow<Real>& window, std::span<Real> x);
  /// Does at most `evaluations` passes over the window; true when everything is done.
  bool step(int evaluations);
  [[nodiscard]] bool done() const { return stage_ == Stage::kDone; }

  /// The best model of a form, after `done`.
  [[nodiscard]] const ValveModel<Real>& best(ValveForm form) const {
    return best_[static_cast<int>(form)];
  }
  /// Takes the error of every best model from its simulation, which `scratch` (of the length
  /// of window.y) holds: what least squares leaves is a difference of large sums, and wrong
  /// in single precision where columns are nearly alike. After `done`; kValveForms passes.
  void settle_errors(std::span<Real> scratch);
  /// The model with its process solved on the window: one pass. Dead times near the one
  /// it came with, or all of them.
  ValveModel<Real> evaluate(ValveModel<Real> model, bool all_delays);
  /// Stem positions of a valve, averaged to the rate of y, into the scratch.
  void position(const ValveModel<Real>& model);
  [[nodiscard]] std::span<const Real> positions() const { return x_; }
  [[nodiscard]] const SearchWindow<Real>& window() const { return window_; }

 private:
  enum class Stage : unsigned char { kScreen, kGrow, kPolish, kDone };
  using Point = typename PatternSearch<Real>::Point;
  static constexpr int kTimeConstants = 9;
  static constexpr int kPerTimeConstant = 3;
  static constexpr int kBeam = kPerTimeConstant * kTimeConstants;
  static constexpr int kPolished = 3;  // of the beam, on the whole window
  static constexpr int kGrown = 8;     // of which this many see more cycles

  void screen_next();
  [[nodiscard]] bool alike(const ValveModel<Real>& a, const ValveModel<Real>& b) const;
  void keep_in_beam(int time_constant, const ValveModel<Real>& model);
  void prune_beam(int most);
  void start_motion();
  void grow_next();
  void start_growth_stage();
  bool next_polish();
  [[nodiscard]] bool slide_job(int job, ValveForm& form, ValveModel<Real>& from) const;
  [[nodiscard]] bool memory_job(int job, ValveForm& form, ValveModel<Real>& from) const;
  void begin_polish(ValveForm form, const ValveModel<Real>& from, int evaluations);
  bool polish_once();
  [[nodiscard]] Point jump();
  [[nodiscard]] Real uniform();
  void take(ValveForm form, const ValveModel<Real>& model);
  [[nodiscard]] Point to_point(const ValveModel<Real>& model) const;
  [[nodiscard]] ValveModel<Real> model_at(const Point& point) const;
  void clamp(Point& point) const;

  SearchWindow<Real> window_;
  std::span<Real> x_;
  std::size_t active_ = 0;  // samples of y in use: the first cycles, or all
  ProcessRegression<Real> regression_;
  PatternSearch<Real> pattern_;
  std::array<ValveModel<Real>, kValveForms> best_;
  std::array<ValveModel<Real>, kValveForms> screened_;
  std::array<ValveModel<Real>, kBeam> beam_;
  std::array<ProcessPoles<Real>, kTimeConstants> time_constants_;
  ValveModel<Real> trial_best_;
  ValveForm form_ = ValveForm::kLinear;
  SlipMotion motion_ = SlipMotion::kSlides;
  Stage stage_ = Stage::kDone;
  int index_ = 0;             // screened candidate, member of the beam, or polish job
  std::uint32_t random_ = 1;  // state of a fixed sequence: same data, same answer
  int beam_size_ = 0;         // members at the front of the beam, once it grows
};

}  // namespace ident
