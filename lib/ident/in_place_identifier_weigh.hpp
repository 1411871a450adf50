// The part of an identification that weighs the valve it found.
// Definitions for in_place_identifier.cpp alone: an archive of intermediate code does not
// pull in what only members of a class ask for.
#pragma once

#include <algorithm>

#include "ident/in_place_identifier.hpp"

namespace ident {

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
                        outweighs<Real>(result_.evidence.bounded.nats, found.nats)))) {
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
    finish(doubt_compressed(judge_without_stem(result_.evidence, result_.loop),
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
  if constexpr (kStemSearch) {
    if (result_.evidence.reversals < kFiveCycles) {
      Uneven& uneven = last_.template emplace<Uneven>();
      uneven.start(valve().best(ValveForm::kLinear), valve().window());
      stage_ = Stage::kUneven;
      return;
    }
  }
  start_intervals();
}

// (E22) In a few turns of u a lag that depends on direction does what a stem does.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::after_uneven() {
  if constexpr (kStemSearch) {
    const Real error = std::get_if<Uneven>(&last_)->error();
    result_.evidence.uneven_ratio = error > Real(0) ? chosen_.fit.error / error : Real(0);
  }
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
      result_.evidence.excluded_above =
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
Reason InPlaceIdentifier<Real, Capacity>::judged() const {
  return doubted(judge(result_.evidence, result_.loop), result_.evidence, result_.health,
                 result_.stick_band, {movement_.period, result_.fit_percent});
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_verdict() {
  const Evidence<Real>& evidence = result_.evidence;
  Reason reason = judged();
  if constexpr (kStemSearch) {
    reason = explained_by_curve(reason, evidence, result_.loop, result_.health);
  }
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
  if (evidence.excluded_above > Real(0)) {
    result_.detectable_band =
        shown_or_excluded(evidence, false) * movement_.swing * u_range();
  }
  finish(reason);
  if (!is_fault(result_.verdict)) {
    result_.stick_band = result_.slip_jump = {};
  }
  if (kModelGap && !options_.verdict_only) stage_ = Stage::kGapStem;
}

}  // namespace ident
