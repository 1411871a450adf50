// Whether the stem of a sticking valve tells something about the next y that u, and the
// past of y, do not: evidence that holds in closed loop.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ident/base/limits.hpp"
#include "ident/evidence/band_ladder.hpp"
#include "ident/evidence/stem_passes.hpp"
#include "ident/valve/stick_slip_valve.hpp"

namespace ident {

/// Valves this close to the best, in nats, are as good: half of χ²(1) at 95 %.
inline constexpr double kWithinNats = 1.92;

/// The band that the weights of the prediction alone say would show (E12), unit of u; 0:
/// none. Only where stems are searched: elsewhere detectable_band is that.
template <class Real, bool kKept = kStemSearch>
struct HopedBand {
  Real hoped_band = 0;
};
template <class Real>
struct HopedBand<Real, false> {
  static constexpr Real hoped_band = 0;
};

/// What the ladder says of one window.
template <class Real>
struct LadderFinding : HopedBand<Real> {
  std::size_t predicted = 0;  ///< samples; 0: the window is too short, nothing is known
  Real nats = 0;              ///< of the best valve, after the cost of its two parameters
  Real band = 0;              ///< its stick band, unit of u
  Real low = 0;               ///< bands that are as good within the chances of 95 %
  Real high = 0;
  int strokes = 0;  ///< how often its stem turned back
  /// Smallest that would have shown, unit of u; 0: none. Where stems are searched it and
  /// all wider ones are refuted (E25).
  Real detectable_band = 0;
};

/// Band and interval of a finding: the best rung, and those as good with half a rung to
/// each side.
template <class Real>
void lay_interval(LadderFinding<Real>& found, int best, int lowest, int highest,
                  Real span) {
  const Real half_rung = std::sqrt(Real(kRungRatio));
  found.band = rung_band(best, span);
  found.low = rung_band(lowest, span) / half_rung;
  found.high = rung_band(highest, span) * half_rung;
}

/// Nats of each rung and slip, slip-wise, before any cost.
template <class Real>
using Ladder = std::array<Real, kLadderValves>;

/// Nats by which predicting y one sample ahead from a stem instead of u is better,
/// m/2·ln(V_u/V_x), m predicted samples: docs/model.md (E10) – (E12), (E25). A load of
/// any colour, tight tuning, an integrator or a moving setpoint are in the past of y and
/// of u, which both predictions know; in a loop with a valve that follows u no stem knows
/// more.
///
/// Life: `start`, then `step` until it says true: every rung of the ladder that fits the
/// swing, by coarse lags (lag_bins.hpp), under which bands differ most; then, where there
/// are fine ones, the best of them and the bands that are refuted by these, and of both
/// numbers of nats the smaller. Or `start_with` and `step`: one valve alone, then others
/// by `go_on_with` and `step`, for which less is left to sum. By the finest lags a valve
/// has to speak at most of its strokes: what it says in one place is left out
/// (spoken_parts.hpp), not so in the small sizes. Or `start_beside_best` and `step`,
/// where stems are searched: what a stem tells beside u. The window is thinned out as
/// stem_passes.hpp says.
///
/// Cost on a Cortex-M4F, which has coarse lags only: a pass of some 1,000 instructions a
/// predicted sample for each valve, 400 for each band that is planted; 52 and at most 50
/// of them for a ladder. Pieces of about a unit. Memory: 80 numbers beside the sums and
/// the ladder.
template <class Real>
class ClosedLoopEvidence {
 public:
  /// The ladder is filled in: 0 for bands too small to show, for those wider than the
  /// swing what a stem that never moves says.
  void start(const EvidenceWindow<Real>& window, Ladder<Real>& ladder);
  /// `valve` as it stands before the first sample, in the unit of u, with so many free
  /// parameters; by these lags.
  void start_with(const EvidenceWindow<Real>& window, const StickSlipValve<Real>& valve,
                  int parameters, std::span<const LagBin> bins = kLagBins);
  /// Where stems are searched: as start_with, without a cost, and the setpoint stands
  /// beside y (E20); as long as u, in any unit.
  void start_beside_setpoint(const EvidenceWindow<Real>& window,
                             const StickSlipValve<Real>& valve,
                             std::span<const Real> setpoint);
  /// What the best valve of the ladder that is done tells beside u, then what bands far
  /// apart do, until one tells enough (E17), by coarse lags; false where the ladder has
  /// no valve.
  bool start_beside_best(const EvidenceWindow<Real>& window);
  /// Another valve on the same window, once the one before is weighed.
  void go_on_with(const StickSlipValve<Real>& valve);
  /// Some pieces, `budget` units; true when done.
  bool step(int budget);

  /// Of the ladder; when done.
  [[nodiscard]] LadderFinding<Real> finding() const;
  /// Of the one valve: nats after the cost of its parameters; when done.
  [[nodiscard]] Real nats() const { return best_ - cost_; }
  /// Whether it was begun by start_beside_best.
  [[nodiscard]] bool asks_beside() const { return beside_; }
  /// After start_beside_best, when done: the most that a stem tells beside u, nats beyond
  /// what so many weights bring by chance.
  [[nodiscard]] Real nats_beside_u() const { return best_; }
  /// How often the stem of the one valve turned back.
  [[nodiscard]] int strokes() const { return strokes_; }
  /// Samples that are predicted; 0: the window is too short.
  [[nodiscard]] std::size_t predicted() const { return passes_.rows(); }

  /// Nats that a band has to leave behind to be hoped for: far above what decides, since
  /// the stem that is tried is never quite the true one.
  static constexpr double kShows = 40;
  /// Nats by which u has to foretell y better than a stem that is refuted (E25).
  static constexpr double kRefutes = 20;
  /// What a stem tells beside u by chance, nats: the weights are a dozen, the stem is the
  /// best of a hundred.
  static constexpr double kBends = 20;

 private:
  enum class Stem : std::uint8_t {
    kRests,
    kRung,
    kGiven,
    kGivenWithU,
  };
  // What rungs are asked.
  enum class Part : std::uint8_t {
    kTries,     // by the ladder's lags
    kPlants,    // which would show
    kRefutes,   // which cannot be, by fine lags
    kConfirms,  // whether the best holds, by fine lags
  };

  // Devices have coarse lags only.
  static constexpr bool kConfirms = kLadderLagBins.size() < kLagBins.size();

  void begin(const EvidenceWindow<Real>& window, int parameters,
             std::span<const LagBin> bins);
  void begin_stem(Stem stem);
  Real move_stem(Real u);
  void take_error();
  void take_nats();
  void next_beside();
  void after_u();
  void take_rung();
  void take_planted();
  void take_refuted();
  void confirm_best();
  void next_rung();
  void confirm();
  void next_planted();
  [[nodiscard]] StickSlipValve<Real> valve_of(int rung, int slip) const {
    return {rung_valve<Real>(rung, slip, passes_.window().span), passes_.window().u[0]};
  }
  [[nodiscard]] Real& rung_nats(int rung, int slip) const {
    return (*ladder_)[static_cast<std::size_t>(slip * kRungs + rung)];
  }

  StemPasses<Real, 64> passes_;
  Ladder<Real>* ladder_ = nullptr;  // none: one valve only
  StickSlipValve<Real> given_{{}, Real(0)};
  StickSlipValve<Real> valve_{{}, Real(0)};
  Real nats_ = 0;  // of the stem that is laid
  Real best_ = 0;
  Real cost_ = 0;
  Real detectable_ = 0;
  [[no_unique_address]] HopedBand<Real> hoped_;
  int rung_ = 0;
  int slip_ = 0;
  RungRange rungs_;
  int best_rung_ = -1;
  int best_slip_ = 0;
  int best_strokes_ = 0;
  int strokes_ = 0;    // of the stem that is laid
  int direction_ = 0;  // of its newest move
  Real position_ = 0;
  Stem stem_ = Stem::kRests;
  Part part_ = Part::kTries;
  bool done_ = true;
  bool beside_ = false;   // u stands beside the valve
  bool divides_ = false;  // into parts
};

}  // namespace ident
