// Where the identified model fails, and which physical effect it seems to lack.
//
// Life: new → start(window) → step until done → report. Evidence of fixed size: the
// residual e = y − ŷ of the free simulation is seen in physical coordinates, and each
// effect that the model could lack is a column, what it would add to ŷ to first order,
// held against e. docs/model.md, (G1) – (G4).
//
// A suspect is a hint of where to look, not a finding: the workbench fits the effect and
// tells whether it holds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "ident/base/effect_code.hpp"
#include "ident/base/limits.hpp"
#include "ident/gap/gap_column.hpp"
#include "ident/gap/gap_fit.hpp"

namespace ident {

/// Shares of the squared error; each group adds up to 1, or is 0 throughout if there is
/// no error.
template <class Real>
struct GapViews {
  static constexpr int kQuarters = 4;
  static constexpr int kPhases = 8;
  Real ascending = 0;  ///< while u rises; the rest while it falls
  /// By travel of the stem's range since the last reversal of u: up to 0.25, 0.5, 1 of
  /// the usual swing, more.
  std::array<Real, kQuarters> travel{};
  std::array<Real, kQuarters> level{};  ///< quarters of the range of the stem
  std::array<Real, kPhases> phase{};    ///< of the cycle, from the upper reversal on
  std::array<Real, kQuarters> time{};   ///< quarters of the window
  Real lag = 0;          ///< correlation of e with itself one sample later, −1 … 1
  Real line = 0;         ///< share of the strongest spectral line
  Real line_period = 0;  ///< its period, samples
};

template <class Real>
struct ModelGapReport {
  EffectCode suspect = EffectCode::kNone;
  Real share_of_error = 0;  ///< that the suspect explains on samples it was not fitted to
  Real residual = 0;        ///< root mean square of e; standard deviation of y is 1
  struct NoViews {};
  [[no_unique_address]] std::conditional_t<kModelGap, GapViews<Real>, NoViews> views;
};

/// Memory: under 900 bytes (float). Cost of all steps, N samples: N/24 passes over the
/// window for the spectrum, 20 multiplications a sample each, and at most 75 for the
/// columns, 60 multiplications a sample each.
template <class Real>
class ModelGap {
 public:
  void start(const GapWindow<Real>& window);
  /// Some samples of one pass over the window; true when done.
  bool step();
  [[nodiscard]] bool done() const { return stage_ == Stage::kDone; }
  /// Of the next step, thousands of instructions of a Cortex-M4F.
  [[nodiscard]] int cost_of_step() const;
  /// Meaningful when done.
  [[nodiscard]] const ModelGapReport<Real>& report() const { return report_; }

 private:
  enum class Stage : std::uint8_t { kLook, kLines, kList, kRefine, kVerify, kDone };

  static constexpr int kLinesAtOnce = 4;
  /// Sums over the window, as far as the pass has come.
  struct Sums {
    Real energy = 0;
    Real beside = 0;
    Real before = 0;  // e at the sample before
  };
  struct Look {
    Real stem_low = 0;
    Real range = 0;
    Real turned_at = 0;
    std::size_t upper_turn = 0;
  };
  struct Phasor {
    Real c = 1, s = 0, turn_c = 0, turn_s = 0, sum_c = 0, sum_s = 0;
  };
  using Lines = std::array<Phasor, kLinesAtOnce>;

  [[nodiscard]] std::size_t end_of_piece() const;
  [[nodiscard]] bool over() const { return next_ == window_.y.size(); }
  void begin_pass();
  void look();
  void take_look();
  void begin_lines();
  void scan_lines();
  void take_lines();
  void begin_column(const GapCandidate& candidate);
  void follow_column();
  void take_column();
  void next_candidate();
  void refine();
  void next_refinement();
  void begin_verification();
  void verify();
  void take_verdict();
  [[nodiscard]] GapColumn<Real>& column() {
    return *std::get_if<GapColumn<Real>>(&work_);
  }
  [[nodiscard]] Real strongest_line() const;  // cycles a sample
  [[nodiscard]] typename GapFit<Real>::Row row_at(std::size_t t,
                                                  GapColumn<Real>& column) const;

  GapWindow<Real> window_;
  ModelGapReport<Real> report_;
  GapFit<Real> fit_;
  GapCandidate suspect_;
  typename GapFit<Real>::Row weights_{};  // of the suspect
  Real share_ = 0;                        // that the suspect explains
  Real line_power_ = 0;
  // Of the pass that is going on.
  Sums sums_;
  std::variant<Look, Lines, GapColumn<Real>> work_;
  GapCandidate candidate_;
  std::size_t next_ = 0;  // sample
  float refinement_ = 0;
  int best_line_ = 0;
  int line_ = 0;
  int index_ = 0;
  Stage stage_ = Stage::kDone;
};

}  // namespace ident
