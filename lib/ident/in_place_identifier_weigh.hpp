// The part of an identification that weighs the valve it found.
// Definitions for in_place_identifier.cpp alone: an archive of intermediate code does not
// pull in what only members of a class ask for.
#pragma once

#include <algorithm>

#include "ident/base/elementary.hpp"
#include "ident/in_place_identifier.hpp"

namespace ident {

// Of a stem that was searched: deadband, two slip jumps, and where it starts.
inline constexpr int kParametersOfStem = 4;

// What they cost, nats (Schwarz's BIC).
template <class Real>
[[nodiscard]] Real stem_cost(std::size_t predicted) {
  return static_cast<Real>(kParametersOfStem) / Real(2) *
         elementary::log(static_cast<Real>(predicted));
}

// The ladder, then the cycle before, which is not asked without an oscillation, then what
// bounded stems and stems beside u tell.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::after_ladder() {
  if constexpr (kStemSearch) {
    if (closed_loop().asks_beside()) {
      result_.evidence.beside_u.nats = closed_loop().nats_beside_u();
      return take_ladder();
    }
    result_.evidence.ladder = closed_loop().finding();
    if (result_.oscillation.detected) {
      ladder_stage().rivals.memory.start(evidence_window(ladder_stage().sums));
      stage_ = Stage::kCycle;
      return;
    }
  }
  look_at_bounds();
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::after_cycle() {
  if constexpr (kStemSearch) {
    result_.evidence.cycle.nats = ladder_stage().rivals.memory.nats();
  }
  look_at_bounds();
}

// A valve that does not stick may still fall behind u.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::look_at_bounds() {
  if constexpr (kStemSearch) {
    if (result_.evidence.ladder.nats > Real(0)) {
      ladder_stage().rivals.bounded.start(evidence_window(ladder_stage().sums));
      stage_ = Stage::kBounds;
      return;
    }
  }
  look_beside_rung();
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::after_bounds() {
  if constexpr (kStemSearch) {
    const BoundedStem<Real>& bounded = ladder_stage().rivals.bounded;
    result_.evidence.bounded = {bounded.nats(), bounded.bound()};
  }
  look_beside_rung();
}

// A stem may be no more than what remembers where a load stands.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::look_beside_rung() {
  if constexpr (kStemSearch) {
    if (closed_loop().start_beside_best(evidence_window(ladder_stage().sums))) {
      stage_ = Stage::kLadder;
      return;
    }
  }
  take_ladder();
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_ladder() {
  LadderFinding<Real> found =
      kStemSearch ? result_.evidence.ladder : closed_loop().finding();
  if (options_.pool != nullptr && !result_.health.compressed &&
      !repeats(result_.evidence.cycle, found.nats) &&
      !keeps_foreign_time(result_.evidence.pace) &&
      !(kStemSearch && (needs_u(result_.evidence) || few_levels(result_.loop) ||
                        outweighs(result_.evidence.bounded, found.nats)))) {
    options_.pool->add(ladder_stage().ladder, found.predicted, options_.weight);
  }
  result_.detectable_band = found.detectable_band * u_range();
  for (Real* band : {&found.band, &found.low, &found.high, &found.detectable_band}) {
    *band /= movement_.swing;
  }
  if constexpr (kStemSearch) {
    found.hoped_band /= movement_.swing;
  }
  result_.evidence.ladder = found;
  if (options_.ends_early && nothing_sticks()) {
    finish(doubt_compressed(judge_unfitted(result_.evidence, result_.loop),
                            result_.evidence, result_.health));
    return;
  }
  if constexpr (kTwoPathSearch) {
    bool two_path = options_.two_path && !options_.verdict_only;
    if constexpr (kStemSearch) {
      two_path = two_path || few_turns(result_.evidence);
    }
    if (two_path || !options_.verdict_only) {
      using Kind = typename StructureSearch<Real>::ValveKind;
      search_.template emplace<TwoPathStage>();
      structure().start(window(), two_path ? Kind::kTwoPath : Kind::kLinear,
                        {scratch_.data(), size_});
      stage_ = two_path ? Stage::kTwoPath : Stage::kLinear;
      return;
    }
  }
  start_valve();
}

// The ladder of symmetric valves misses stems that move in another way, but not wholly.
template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::nothing_sticks() const {
  const Evidence<Real>& evidence = result_.evidence;
  // Whether a load may hide what a stem tells beside u, only a fit knows.
  return evidence.ladder.predicted > 0 && evidence.ladder.nats < Real(0) &&
         evidence.reversals >= kFiveCycles && !bends(evidence);
}

// The residual of the richest model tells how many samples count.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::begin_weighing() {
  const ValveModel<Real>& mixed = valve().best(ValveForm::kMixed);
  valve().pass().simulate(mixed.known ? mixed : valve().best(ValveForm::kLinear));
  stage_ = Stage::kWeigh;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::weigh() {
  Evidence<Real>& evidence = result_.evidence;
  const SearchWindow<Real>& search = valve().window();
  evidence.observations =
      independent_observations<Real>(search.y, valve().pass().simulated(), search.period);
  weigh_forms(valve(), evidence);
  // Where the search of structures finds no linear process, or a worse one.
  result_.fit_linear_percent =
      std::max(result_.fit_linear_percent, evidence.fit_linear_percent);
  chosen_ = valve().best(evidence.form);
  if (evidence.form == ValveForm::kLinear) {
    start_intervals();
  } else {
    valve().pass().simulate(valve().best(ValveForm::kLinear));
    stage_ = Stage::kReference;
  }
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::begin_comparison() {
  const SearchWindow<Real>& search = valve().window();
  last_.template emplace<CycleComparison<Real>>(search.y, search.period);
  comparison().add(valve().pass().simulated(), Real(1));
  valve().pass().simulate(chosen_);
  stage_ = Stage::kCompare;
}

// Whether the chosen valve explains nearly every cycle better, or a lucky few.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::compare_cycles() {
  comparison().add(valve().pass().simulated(), Real(-1));
  const CycleGain<Real> gain = comparison().gain();
  result_.evidence.cycles = gain.cycles;
  result_.evidence.cycles_better = gain.better;
  result_.evidence.consistency = gain.consistency;
  start_intervals();
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::start_intervals() {
  const Evidence<Real>& evidence = result_.evidence;
  // (I1) χ²(1) at 95 %, widened as calibrated on simulated loops.
  constexpr Real kQuantile = Real(3.84);
  constexpr Real kWidening = Real(20);
  // (E21) Of the band that a linear valve leaves possible.
  constexpr Real kExcludes = Real(8);
  const Real widening = evidence.form == ValveForm::kLinear ? kExcludes : kWidening;
  const Real limit =
      chosen_.fit.error *
      (Real(1) + widening * kQuantile / std::max(evidence.observations, Real(4)));
  constexpr Real kLeastMargin = Real(0.004);  // of the swing of u
  constexpr Real kModelMargin = Real(0.25);  // of the stick band, residual far from white
  const Real samples = static_cast<Real>(valve().window().y.size());
  const Real unexplained = Real(1) - std::min(evidence.observations / samples, Real(1));
  const Real band = evidence.band_over_swing * movement_.swing;
  const Real margin =
      std::max(kLeastMargin * movement_.swing, kModelMargin * unexplained * band);
  last_.template emplace<IntervalSearch<Real>>();
  intervals().start(chosen_, limit, movement_.swing, margin);
  for (int form = 1; form < kValveForms; ++form) {
    intervals().include(valve().best(static_cast<ValveForm>(form)));
  }
  stage_ = Stage::kIntervals;
}

// Bands and jumps of the chosen valve with their intervals, whatever the verdict will be.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_bands() {
  result_.fit_valve_percent = full_rate_.fit_percent(size_);
  const ValveFriction<Real>& f = chosen_.friction;
  const ValveIntervals<Real>& bounds = intervals().intervals();
  const auto estimate = [&](Real value, const typename ValveIntervals<Real>::Bounds& b) {
    return Estimate<Real>{true, value * u_range(), b.low * u_range(), b.high * u_range()};
  };
  result_.stick_band = {estimate(f.stick_ascending(), bounds.stick_ascending),
                        estimate(f.stick_descending(), bounds.stick_descending)};
  result_.slip_jump = {estimate(f.slip_ascending, bounds.slip_ascending),
                       estimate(f.slip_descending, bounds.slip_descending)};
  // (E21) Bands that no process makes up for.
  if constexpr (kStemSearch) {
    if (result_.evidence.by_hand && result_.evidence.form == ValveForm::kLinear) {
      result_.evidence.excluded.above =
          std::max(bounds.stick_ascending.high, bounds.stick_descending.high) /
          movement_.swing;
    }
  }
  result_.valve = chosen_;
  result_.valve.friction.deadband *= u_range();
  result_.valve.friction.slip_ascending *= u_range();
  result_.valve.friction.slip_descending *= u_range();
  last_.template emplace<EvidenceStage>();
  valve_stage().sums = OneStepSums<Real>();
  if (result_.evidence.form == ValveForm::kLinear) {
    search_stem();
    return;
  }
  closed_loop().start_with(evidence_window(valve_stage().sums), chosen_valve(),
                           free_parameters(result_.evidence.form));
  stage_ = Stage::kStemEvidence;
}

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
    evidence_stage().search.start(movement_.swing, u_[0],
                                  Real(kNoNats) + stem_cost<Real>(e.ladder.predicted));
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
        best.nats < Real(kNoNats) + stem_cost<Real>(closed_loop().predicted())) {
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
  stage_ = Stage::kJudge;
  if constexpr (kStemSearch) {
    const Evidence<Real>& e = result_.evidence;
    const auto moved = [this](Real sp) { return sp != setpoint_[0]; };
    if (!(nats_of_stems(e, Real(0)) > Real(0)) ||
        std::none_of(setpoint_.begin(), setpoint_.end(), moved)) {
      return;
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
  stage_ = Stage::kJudge;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_verdict() {
  const Evidence<Real>& evidence = result_.evidence;
  Reason reason = doubted(judge(evidence, result_.loop), evidence, result_.health,
                          result_.stick_band, {movement_.period, result_.fit_percent});
  const bool under_load = reason == Reason::kSticksUnderLoad;
  if (is_fault(verdict_of(reason)) &&
      (under_load || searched_stem_is_told(evidence, result_.stick_band))) {
    tell_bands_seen_ahead();
  }
  if (!under_load) {
    reason = strokes_that_stick(reason, result_.stick_band);
  }
  if constexpr (kNamesCause) {
    result_.cause = cause_of(result_.loop, verdict_of(reason));
  }
  if constexpr (kStemSearch) {
    if (evidence.by_hand) {
      result_.detectable_band =
          shown_or_excluded(evidence, evidence.ladder.detectable_band) * movement_.swing *
          u_range();
    }
  }
  finish(reason);
  if (!is_fault(result_.verdict)) {
    result_.stick_band = result_.slip_jump = {};
  }
  if (kModelGap && !options_.verdict_only) stage_ = Stage::kGapStem;
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
