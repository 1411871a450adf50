// What an effect that the model lacks would add to its output, to first order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ident/base/effect_code.hpp"
#include "ident/process/process_regression.hpp"

namespace ident {

/// What the model made of a window, oldest sample first. All spans have one length, are
/// not copied and must stay until `done`.
template <class Real>
struct GapWindow {
  std::span<const Real> stem;       ///< x, 0 … 1; x[t] acts on y[t] after fit.delay
  std::span<const Real> y;          ///< measured, zero mean, unit variance
  std::span<const Real> simulated;  ///< ŷ of stem, poles and fit
  std::span<const unsigned char> ascending;  ///< direction of u
  ProcessPoles<Real> poles;
  ProcessFit<Real> fit;
  Real period = 0;        ///< of the oscillation, samples, ≥ 4
  Real swing = 1;         ///< usual distance of two turning points of u
  Real observations = 0;  ///< independent samples in the residual
  Real y_step = 0;        ///< distance of the levels of y, 0: none seen
  bool upright = true;    ///< false: y was turned, so that "above" is below
};

/// How a column is made; `value` of the candidate is what the comment says.
enum class GapKind : std::uint8_t {
  kSquare,   ///< through the process: (x − mean)²
  kProduct,  ///< through the process: (x − mean)·ŷ
  kDrift,    ///< through the process: (x − mean)·time
  kLine,     ///< cosine and sine; value: distance from the strongest line, 1/N
  kStep,     ///< through the process: a step; value: place, share of the window
  kRate,     ///< through the process: limited stem less stem; value: of swing in a period
  kOpening,  ///< the same, rising only
  kClosing,  ///< falling only
  kUpper,    ///< through the process: stem cut off above; value: share of its range
  kLower,    ///< below
  kOverflow,  ///< ŷ cut off; value: share of its range
  kLag,       ///< ŷ through a lag; value: time constant, share of the period
  kDelay,     ///< ŷ later; value: samples
  kRamp,      ///< time
};

/// One effect at one setting.
struct GapCandidate {
  EffectCode effect = EffectCode::kNone;
  GapKind kind = GapKind::kSquare;
  float value = 0;
  bool whole = false;  ///< the column is the whole effect: its factor would be 1
};

inline constexpr int kGapCandidates = 69;
/// 0 ≤ index < kGapCandidates; in the order of the effects, steps last.
[[nodiscard]] GapCandidate gap_candidate(int index);
/// How far the listed values of the same effect lie apart; 0 where `value` means nothing
/// or only whole numbers do.
[[nodiscard]] float gap_spacing(const GapCandidate& candidate);

/// The column or columns of one candidate, sample by sample.
template <class Real>
class GapColumn {
 public:
  /// `line`: frequency of the strongest spectral line of the residual, cycles a sample;
  /// used by GapKind::kLine only. Cost: two passes.
  GapColumn(const GapCandidate& candidate, const GapWindow<Real>& window, Real line);

  /// The values at sample t, called for t = 0, 1, 2 … Constant time. The second is 0 but
  /// for a line.
  std::array<Real, 2> at(std::size_t t);
  [[nodiscard]] int count() const { return kind_ == GapKind::kLine ? 2 : 1; }

 private:
  /// What the process makes of a change of its input.
  Real respond(Real x);

  static constexpr unsigned kLength = 32;  // a power of two
  static_assert(kLength > static_cast<unsigned>(kDelayTaps) + 1);

  const GapWindow<Real>& window_;
  GapKind kind_;
  Real mean_ = 0;   // of the stem
  Real level_ = 0;  // where the stem or the output is cut off
  Real rate_ = 0;   // of the stem, a sample
  Real kept_ = 0;   // share of itself that a lag keeps in a sample
  Real limited_;    // stem with a limited rate
  Real lagged_;     // output with a lag
  Real cosine_ = 1;
  Real sine_ = 0;
  Real turn_cosine_ = 1;
  Real turn_sine_ = 0;
  std::size_t place_ = 0;  // sample of a step, or samples of a dead time
  Real steady_;
  Real slow_ = 0;
  Real fast_ = 0;
  unsigned now_ = 0;
  std::array<Real, kLength> past_{};
};

}  // namespace ident
