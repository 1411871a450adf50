// How much better one form of valve explains y than another.
#pragma once

#include <algorithm>

#include "ident/base/limits.hpp"
#include "ident/evidence/bounded_stem.hpp"
#include "ident/evidence/closed_loop_evidence.hpp"
#include "ident/signal/stroke_pace.hpp"
#include "ident/valve/valve_form.hpp"
#include "ident/valve/valve_search.hpp"
#include "ident/verdict/verdict.hpp"

namespace ident {

/// A number of a window, for a threshold to be compared with: as exact as that is.
template <class Real>
[[nodiscard]] constexpr Threshold exact(Real value) {
  return static_cast<Threshold>(value);
}

/// The stem that foretells y best one sample ahead, looked for where no fitted valve
/// sticks. Bands over the usual swing of u.
template <class Real>
struct SearchedStem {
  bool asked = false;
  Real nats = 0;  ///< 0 where no stem was worth it; after the cost of its parameters, by
                  ///< many lags
  int strokes = 0;  ///< how often it turned back
  PerStroke<Real> band;

  [[nodiscard]] constexpr Real wider_band() const {
    return std::max(band.ascending.value, band.descending.value);
  }
};

/// What the lags of one cycle ago add to the past of u and y: cycle_memory.hpp.
template <class Real>
struct RememberedCycle {
  Real nats = 0;
};

/// What a stem foretells that does not stick but is bounded: bounded_stem.hpp.
template <class Real>
struct BoundedFinding {
  Real nats = 0;
  Bound bound = Bound::kSpeed;
};

/// What a stem tells beside u (E17): closed_loop_evidence.hpp.
template <class Real>
struct StemBesideU {
  Real nats = 0;
};

/// What the stronger stem tells where the setpoint is known, too (E20).
template <class Real>
struct StemBesideSetpoint {
  bool weighed = false;  ///< the setpoint moves, and a stem speaks
  Real nats = 0;
};

/// What a stem tells beside a bent characteristic and the setpoint (E23), and that
/// characteristic beside u (E24): bands over the usual swing of u.
template <class Real>
struct CurvedFinding {
  bool weighed = false;
  Real nats = 0;
  Real curve_nats = 0;
  Real narrower_band = 0;
  Real wider_band = 0;
};

/// What is asked where stems are searched.
template <class Real, bool kSearched = kStemSearch>
struct StemEvidence {
  SearchedStem<Real> searched;
  RememberedCycle<Real> cycle;
  BoundedFinding<Real> bounded;
  StemBesideU<Real> beside_u;
  StemBesideSetpoint<Real> beside_setpoint;
  CurvedFinding<Real> curved;
  /// Of a step test by hand (E21): wider stick bands are excluded, over the usual swing
  /// of u; 0: unknown.
  Real excluded_above = 0;
  /// In a few turns of u (E22): squared error of `form` over that of a process whose lag
  /// depends on direction, behind a linear valve; 0: not asked.
  Real uneven_ratio = 0;
};
/// Where none is searched it takes no room.
template <class Real>
struct StemEvidence<Real, false> {
  static constexpr SearchedStem<Real> searched = {};
  static constexpr RememberedCycle<Real> cycle = {};
  static constexpr BoundedFinding<Real> bounded = {};
  static constexpr StemBesideU<Real> beside_u = {};
  static constexpr StemBesideSetpoint<Real> beside_setpoint = {};
  static constexpr CurvedFinding<Real> curved = {};
  static constexpr Real excluded_above = 0;
  static constexpr Real uneven_ratio = 0;
};

/// The numbers behind the verdict, all free of units.
template <class Real>
struct Evidence : StemEvidence<Real> {
  ValveForm form = ValveForm::kLinear;  ///< simplest valve that the data support
  Real error_ratio = 1;  ///< squared error of the linear valve over that of `form`, ≥ 1
  Real jump_ratio = 1;   ///< the same for a valve without slip jump over `form`
  Real observations = 0;  ///< independent samples in the residual of `form`
  Real score = 0;         ///< log-likelihood gain of `form` after its cost, in nats
  int cycles = 0;         ///< stretches of about one period that were compared
  int cycles_better =
      0;  ///< of those, where `form` simulates y better than the linear valve
  Real consistency = 0;         ///< mean gain of a stretch over its standard error
  Real band_over_swing = 0;     ///< larger stick band over the usual swing of u
  Real slip_over_band = 0;      ///< larger slip jump over the larger stick band, 0 … 1
  Real fit_percent = 0;         ///< of the sticking valve on the searched window
  Real fit_linear_percent = 0;  ///< of the linear valve on the searched window
  Real time_constant = 0;       ///< slow time constant over the period of u; 0 unknown
  int reversals = 0;            ///< turning points of u
  LadderFinding<Real> ladder;   ///< closed-loop evidence; bands over the usual swing of u
  bool stem_weighed = false;
  bool by_hand = false;  ///< u rests but for a few moves: moves_rarely()
  bool drifts = false;   ///< u, irregularly, further than it swings
  Real stem_nats = 0;    ///< closed-loop evidence of the stem of `form`; if weighed
  int stem_strokes = 0;  ///< how often it turned back
  [[no_unique_address]] StrokePace<Real> pace;
};

/// Whether the searched one of the window's own stems has more closed-loop evidence than
/// the fitted one, if that was weighed.
template <class Real>
[[nodiscard]] bool searched_is_stronger(const Evidence<Real>& e) {
  return kStemSearch &&
         e.searched.nats > (e.stem_weighed ? std::max(e.stem_nats, Real(0)) : Real(0));
}

/// Closed-loop evidence of the stronger of the window's own stems, nats; `none` where
/// neither was weighed.
template <class Real>
[[nodiscard]] Real nats_of_stems(const Evidence<Real>& e, Real none) {
  if (searched_is_stronger(e)) {
    return e.searched.nats;
  }
  return e.stem_weighed ? e.stem_nats : none;
}

/// That of the best stem of all that were asked.
template <class Real>
[[nodiscard]] Real best_nats(const Evidence<Real>& e) {
  return std::max(nats_of_stems(e, Real(0)), e.ladder.nats);
}

/// The smaller of the band that is refuted one sample ahead (E25), or that is only
/// `hoped` for (E12), and of the one that is excluded running free (E21), over the usual
/// swing of u; 0: neither is known.
template <class Real>
[[nodiscard]] Real shown_or_excluded(const Evidence<Real>& e, bool hoped) {
  const Real ahead = hoped ? Real(e.ladder.hoped_band) : e.ladder.detectable_band;
  const Real excluded = e.excluded_above;
  return ahead > Real(0) && excluded > Real(0) ? std::min(ahead, excluded)
                                               : std::max(ahead, excluded);
}

/// Chooses the form, the simplest one that the data support: each parameter more must
/// earn its keep in the likelihood of the independent samples. Takes `observations` from
/// `evidence` and fills in all that follows from the errors of the searched models.
/// Constant time.
template <class Real>
void weigh_forms(const ValveSearch<Real>& search, Evidence<Real>& evidence);

}  // namespace ident
