// The part of an identification that asks what stems foretell one sample ahead.
// Definitions for in_place_identifier.cpp alone, like in_place_identifier_weigh.hpp.
#pragma once

#include <algorithm>

#include "ident/evidence/stem_passes.hpp"
#include "ident/in_place_identifier.hpp"

namespace ident {

// Of a stem that was searched: deadband, two slip jumps, and where it starts.
inline constexpr int kParametersOfStem = 4;

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::weigh_stem() {
  result_.evidence.stem_weighed = closed_loop().predicted() > 0;
  result_.evidence.stem_nats = closed_loop().nats();
  result_.evidence.stem_strokes = closed_loop().strokes();
  search_stem();
}

// A load may have led the free run astray: to no valve that sticks, or to another one.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::search_stem() {
  stage_ = Stage::kJudge;
  if constexpr (kStemSearch) {
    const Evidence<Real>& e = result_.evidence;
    if (e.ladder.predicted == 0 || e.reversals < kFiveCycles ||
        !(load_may_hide(e) || fitted_valve_sticks(e))) {
      return look_beside_setpoint();
    }
    result_.evidence.searched.asked = true;
    evidence_stage().search.start(
        movement_.swing, u_[0],
        Real(kNoNats) + cost_of<Real>(kParametersOfStem, e.ladder.predicted));
    closed_loop().start_with(evidence_window(valve_stage().sums),
                             evidence_stage().search.proposed().valve(), 0,
                             kCoarseLagBins);
    stage_ = Stage::kStemSearched;
  }
}

// The next of them; when there is none, what coarse lags say of the best must stand up
// to fine ones.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::confirm_stem() {
  if constexpr (kStemSearch) {
    StemSearch<Real>& search = evidence_stage().search;
    if (closed_loop().predicted() > 0) {
      search.report(closed_loop().nats(), closed_loop().strokes());
      if (!search.done()) {
        closed_loop().go_on_with(search.proposed().valve());
        return;
      }
    }
    const FoundStem<Real>& best = search.best();
    if (!best.known ||
        best.nats <
            Real(kNoNats) + cost_of<Real>(kParametersOfStem, closed_loop().predicted())) {
      return look_beside_setpoint();
    }
    closed_loop().start_with(evidence_window(valve_stage().sums), best.valve(),
                             kParametersOfStem);
    stage_ = Stage::kStemConfirmed;
  }
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_searched_stem() {
  if constexpr (kStemSearch) {
    const StemSearch<Real>& search = evidence_stage().search;
    const Real half_rung = std::sqrt(Real(kRungRatio));
    const auto band = [&](Real value, const BandReach<Real>& reach) {
      return Estimate<Real>{true, value / movement_.swing,
                            reach.low / half_rung / movement_.swing,
                            reach.high * half_rung / movement_.swing};
    };
    const ValveFriction<Real>& f = search.best().friction;
    SearchedStem<Real>& found = result_.evidence.searched;
    found.nats = closed_loop().nats();
    found.strokes = closed_loop().strokes();
    found.band = {band(f.stick_ascending(), search.ascending()),
                  band(f.stick_descending(), search.descending())};
    look_beside_setpoint();
  }
}

// (E20) The stronger stem once more, where a setpoint that moves may do its work.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::look_beside_setpoint() {
  if constexpr (kStemSearch) {
    const Evidence<Real>& e = result_.evidence;
    if (!(nats_of_stems(e, Real(0)) > Real(0)) || !setpoint_moves()) {
      return look_beside_curve();
    }
    closed_loop().start_beside_setpoint(
        evidence_window(valve_stage().sums),
        searched_is_stronger(e) ? evidence_stage().search.best().valve() : chosen_valve(),
        setpoint_);
    stage_ = Stage::kBesideSetpoint;
  }
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_beside_setpoint() {
  if constexpr (kStemSearch) {
    result_.evidence.beside_setpoint = {closed_loop().predicted() > 0,
                                        closed_loop().nats()};
  }
  look_beside_curve();
}

// Whether a stem is needed at all in turns that are few (E23), or where one speaks, but
// not clearly (E24).
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::look_beside_curve() {
  stage_ = Stage::kJudge;
  if constexpr (kStemSearch) {
    const Evidence<Real>& e = result_.evidence;
    const bool moves = setpoint_moves();
    const int few = moves ? kTenCycles : kFiveCycles;
    const bool speaks =
        e.form != ValveForm::kLinear || exact(best_nats(e)) > Threshold(kNoNats);
    if (e.reversals < few ? speaks : may_be_curve(judged())) {
      last_.template emplace<BesideCurve>().start(
          evidence_window(valve_stage().sums),
          moves ? setpoint_ : std::span<const Real>(),
          {chosen_valve(), e.band_over_swing * movement_.swing,
           e.form == ValveForm::kLinear ? 0 : free_parameters(e.form)});
      stage_ = Stage::kBesideCurve;
    }
  }
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_beside_curve() {
  if constexpr (kStemSearch) {
    const CurvedLadder<Real>& curved = *std::get_if<BesideCurve>(&last_);
    result_.evidence.curved = {curved.known(), curved.nats(), curved.curve_nats(),
                               curved.narrower_band() / movement_.swing,
                               curved.wider_band() / movement_.swing};
  }
  stage_ = Stage::kJudge;
}

// Where loads led the free run astray: what foretells y best, of which no slip jump is
// known.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::tell_bands_seen_ahead() {
  const Real unit = movement_.swing * u_range();
  const auto in_unit = [&](const Estimate<Real>& b) {
    return Estimate<Real>{true, b.value * unit, b.low * unit, b.high * unit};
  };
  const LadderFinding<Real>& found = result_.evidence.ladder;
  const Estimate<Real> rung{true, found.band, found.low, found.high};
  const PerStroke<Real>& searched = result_.evidence.searched.band;
  result_.stick_band =
      searched_stem_sticks(result_.evidence)
          ? PerStroke<Real>{in_unit(searched.ascending), in_unit(searched.descending)}
          : PerStroke<Real>{in_unit(rung), in_unit(rung)};
  result_.slip_jump = {};
}

}  // namespace ident
