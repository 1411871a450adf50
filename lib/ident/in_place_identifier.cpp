#include "ident/in_place_identifier.hpp"

#include <algorithm>
#include <cmath>

#include "ident/base/configurations.hpp"
#include "ident/base/elementary.hpp"

namespace ident {
namespace {
// Decimation leaves at least this many samples in each cycle.
constexpr double kFewestPerCycle = 40;
// A valve with a memory is fitted to a first part with so many turning points, then to
// more.
constexpr std::size_t kFirstReversals = 4;
// A setpoint that moves by this share of the standard deviation of y moves the loop.
constexpr double kLeastStep = 0.5;

}  // namespace

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::finish(Judgement judgement) {
  result_.verdict = judgement.verdict;
  result_.reason = judgement.reason;
  stage_ = Stage::kDone;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::start(std::span<Real> u, std::span<Real> y,
                                              std::span<const Real> sp, int gain_sign,
                                              const WindowOptions& options) {
  options_ = options;
  result_ = {};
  if constexpr (kTwoPathSearch) {
    two_path_ = {};
    linear_ = {};
  }
  chosen_ = {};
  setpoint_ = {};
  scale_of_u_ = scale_of_y_ = {};
  size_ = std::min({u.size(), y.size(), Capacity});
  u_ = u.first(size_);
  y_ = y.first(size_);
  if (!all_finite<Real>(u_) || !all_finite<Real>(y_)) {
    size_ = 0;
    u_ = y_ = {};
    finish({Verdict::kBadData, Reason::kNotFinite});
    return;
  }
  if (size_ < kFewestSamples) {
    finish({Verdict::kUndecided, Reason::kTooShort});
    return;
  }
  if (sp.size() >= size_ && all_finite<Real>(sp.first(size_))) {
    setpoint_ = sp.first(size_);
  }
  search_.template emplace<WindowSurvey<Real>>();
  survey().start({u_, y_, setpoint_, {ascending_.data(), size_}, scratch_, gain_sign});
  stage_ = Stage::kSurvey;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::survey_next() {
  const bool over = survey().step(result_);
  scale_of_u_ = survey().of_u();
  scale_of_y_ = survey().of_y();
  if (!over) {
    return;
  }
  movement_ = survey().movement();
  if (survey().refusal() != Reason::kNone) {
    finish({Verdict::kUndecided, survey().refusal()});
    return;
  }
  search_.template emplace<LadderStage>();
  last_.template emplace<ClosedLoopEvidence<Real>>();
  closed_loop().start(evidence_window(ladder_stage().sums), ladder_stage().ladder);
  stage_ = Stage::kLadder;
}

template <class Real, std::size_t Capacity>
EvidenceWindow<Real> InPlaceIdentifier<Real, Capacity>::evidence_window(
    OneStepSums<Real>& sums) {
  EvidenceWindow<Real> window;
  window.u = u();
  window.y = y();
  window.scratch = {scratch_.data(), size_};
  window.sums = &sums;
  window.period = movement_.period;
  window.swing = movement_.swing;
  window.span =
      options_.span > 0 ? static_cast<Real>(options_.span) / u_range() : movement_.swing;
  return window;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_ladder() {
  LadderFinding<Real> found = closed_loop().finding();
  if (options_.pool != nullptr && !result_.health.compressed) {
    options_.pool->add(ladder_stage().ladder, found.predicted, options_.weight,
                       options_.keep);
  }
  result_.detectable_band = found.detectable_band * u_range();
  for (Real* band : {&found.band, &found.low, &found.high, &found.detectable_band}) {
    *band /= movement_.swing;
  }
  result_.evidence.ladder = found;
  if (options_.ends_early && nats_below(0)) {
    finish(doubt_compressed(judge_unfitted(result_.evidence, result_.loop),
                            result_.evidence, result_.health));
    return;
  }
  if constexpr (kTwoPathSearch) {
    if (!options_.verdict_only) {
      search_.template emplace<TwoPathStage>();
      start_paths(StructureSearch<Real>::ValveKind::kTwoPath);
      stage_ = Stage::kTwoPath;
      return;
    }
  }
  start_valve();
}

// The ladder of symmetric valves misses stems that move in another way, but not wholly.
template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::nats_below(double nats) const {
  const Evidence<Real>& evidence = result_.evidence;
  return evidence.ladder.predicted > 0 && evidence.ladder.nats < Real(nats) &&
         evidence.reversals >= kFiveCycles;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::start_paths(
    typename StructureSearch<Real>::ValveKind kind) {
  if constexpr (kTwoPathSearch) {
    structure().start(window(), kind, {scratch_.data(), size_});
  }
}

template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::step(int budget) {
  switch (stage_) {
    case Stage::kSurvey:
      survey_next();
      break;
    case Stage::kLadder:
      if (closed_loop().step(budget)) {
        take_ladder();
      }
      break;
    case Stage::kTwoPath:
      if constexpr (kTwoPathSearch) {
        if (structure().step(budget)) {
          two_path_ = structure().best();
          start_paths(StructureSearch<Real>::ValveKind::kLinear);
          stage_ = Stage::kLinear;
        }
      }
      break;
    case Stage::kLinear:
      if constexpr (kTwoPathSearch) {
        if (structure().step(budget)) {
          const StructureCandidate<Real>& best = structure().best();
          linear_ = {best.known, best.error, best.aic};
          take_two_path();
          start_valve();
        }
      }
      break;
    case Stage::kValve:
      if (valve().step(budget)) {
        begin_weighing();
      }
      break;
    case Stage::kWeigh:
      if (run_pass(budget)) {
        weigh();
      }
      break;
    case Stage::kReference:
      if (run_pass(budget)) {
        begin_comparison();
      }
      break;
    case Stage::kCompare:
      if (run_pass(budget)) {
        compare_cycles();
      }
      break;
    case Stage::kRival:
      if (rival().step(valve(), chosen_, scratch_, budget)) {
        result_.evidence.load_ratio = rival().error_ratio();
        start_intervals();
      }
      break;
    case Stage::kIntervals:
      if (intervals().step(valve(), budget)) {
        look_at_loop();
      }
      break;
    case Stage::kLinearProcess:
      if (solve_process(budget)) {
        stage_ = kNamesCause ? Stage::kCrossover : Stage::kSetpoint;
      }
      break;
    case Stage::kCrossover:
      if constexpr (kNamesCause) {
        look_at_crossover();
      }
      break;
    case Stage::kLinearOutput:
      if constexpr (kNamesCause) {
        if (simulate_process(budget)) {
          stage_ = Stage::kMargin;
        }
      }
      break;
    case Stage::kMargin:
      if constexpr (kNamesCause) {
        look_at_margin();
      }
      break;
    case Stage::kSetpoint:
      look_at_setpoint();
      break;
    case Stage::kStem:
      take_stem();
      break;
    case Stage::kProcess:
      if (solve_process(budget)) {
        take_bands();
      }
      break;
    case Stage::kStemEvidence:
      if (closed_loop().step(budget)) {
        weigh_stem();
      }
      break;
    case Stage::kJudge:
      take_verdict();
      break;
    case Stage::kGapStem:
      if constexpr (kModelGap) {
        lay_gap();
      }
      break;
    case Stage::kGapOutput:
      if constexpr (kModelGap) {
        if (simulate_process(budget)) {
          start_gap();
        }
      }
      break;
    case Stage::kGap:
      if constexpr (kModelGap) {
        for (int left = budget * kUnit; left > 0 && !gap().done();
             left -= gap().cost_of_step()) {
          gap().step();
        }
        if (gap().done()) {
          take_gap();
        }
      }
      break;
    case Stage::kDone:
      break;
  }
  return done();
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::start_valve() {
  int decimation = 1;
  if constexpr (kDecimates) {
    const Real room = std::min(movement_.period / Real(kFewestPerCycle),
                               static_cast<Real>(size_) / Real(kFewestSearched));
    decimation = std::max(static_cast<int>(room), 1);
  }
  std::size_t count = size_ / decimation;
  std::size_t first = 0;
  if (count > kMostSearched) {
    first = size_ - kMostSearched * decimation;
    count = kMostSearched;
  }
  search_.template emplace<ValveStage>();
  std::span<const Real> means = y();
  if (kDecimates && (decimation > 1 || count < size_)) {
    const std::span<Real> scaled{scratch_.data() + count, count};
    if (!scaled_means<Real>(y().subspan(first), decimation, scaled)) {
      finish({Verdict::kUndecided, Reason::kConstant});
      return;
    }
    means = scaled;
  }
  std::size_t fifth = first;
  const std::size_t end = first + count * decimation;
  for (std::size_t reversals = 0; reversals < kFirstReversals && ++fifth < end;) {
    reversals += ascending_[fifth] != ascending_[fifth - 1] ? 1 : 0;
  }
  SearchWindow<Real> search;
  search.first_part = (fifth - first) / decimation;
  search.u = {u_.data() + first, end - first};
  search.y = means;
  search.decimation = decimation;
  search.period = movement_.period / static_cast<Real>(decimation);
  search.warm_up = first_return<Real>(
      u().subspan(first), {ascending_.data() + first, size_ - first}, movement_.period);
  search.swing = movement_.swing;
  search.drift = true;
  result_.decimation = decimation;
  ValveStage& stage = valve_stage();
  stage.search.start(search, {stage.stem.data(), count}, {scratch_.data(), count},
                     stage.stems, options_.earlier, u_range(), nats_below(kNoNats));
  stage_ = Stage::kValve;
}

template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::run_pass(int budget) {
  int left = budget * kUnit;
  return valve().pass().run(left);
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
  comparison().add_reference(valve().pass().simulated());
  valve().pass().simulate(chosen_);
  stage_ = Stage::kCompare;
}

// Whether the chosen valve explains nearly every cycle better, or a lucky few.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::compare_cycles() {
  comparison().add_candidate(valve().pass().simulated());
  const CycleGain<Real> gain = comparison().gain();
  result_.evidence.cycles = gain.cycles;
  result_.evidence.cycles_better = gain.better;
  result_.evidence.consistency = gain.consistency;
  if (doubtful()) {
    last_.template emplace<LoadRival<Real>>();
    rival().start();
    stage_ = Stage::kRival;
  } else {
    start_intervals();
  }
}

// Whether a fault might be found in a few setpoint steps, as far as can be seen before
// its stem is weighed.
template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::doubtful() const {
  if (!better_running_free(result_.evidence) ||
      result_.evidence.reversals >= kFiveCycles) {
    return false;
  }
  if (setpoint_.empty()) {
    return !result_.oscillation.detected;
  }
  const auto [low, high] = std::minmax_element(setpoint_.begin(), setpoint_.end());
  return *high - *low > Real(kLeastStep) * y_scale();
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::start_intervals() {
  const Evidence<Real>& evidence = result_.evidence;
  // (I1) χ²(1) at 95 %, widened as calibrated on simulated loops.
  constexpr Real kQuantile = Real(3.84);
  constexpr Real kWidening = Real(20);
  const Real limit =
      chosen_.fit.error *
      (Real(1) + kWidening * kQuantile / std::max(evidence.observations, Real(4)));
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
  result_.valve = chosen_;
  result_.valve.friction.deadband *= u_range();
  result_.valve.friction.slip_ascending *= u_range();
  result_.valve.friction.slip_descending *= u_range();
  stage_ = Stage::kJudge;
  if (result_.evidence.form != ValveForm::kLinear) {
    last_.template emplace<ClosedLoopEvidence<Real>>();
    valve_stage().sums = OneStepSums<Real>();
    closed_loop().start_with(evidence_window(valve_stage().sums), chosen_valve(),
                             free_parameters(result_.evidence.form));
    stage_ = Stage::kStemEvidence;
  }
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::weigh_stem() {
  result_.evidence.stem_weighed = closed_loop().predicted() > 0;
  result_.evidence.stem_nats = closed_loop().nats();
  result_.evidence.stem_strokes = closed_loop().strokes();
  stage_ = Stage::kJudge;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_verdict() {
  const Judgement judgement = doubt_compressed(judge(result_.evidence, result_.loop),
                                               result_.evidence, result_.health);
  if constexpr (kNamesCause) {
    result_.cause = cause_of(result_.loop, judgement.verdict);
  }
  finish(judgement);
  const bool sticks =
      judgement.verdict == Verdict::kStiction || judgement.verdict == Verdict::kBacklash;
  const bool under_load = sticks && judgement.reason == Reason::kSticksUnderLoad;
  if (!sticks || under_load) {
    result_.stick_band = result_.slip_jump = {};
  }
  if (under_load) {
    const LadderFinding<Real>& found = result_.evidence.ladder;
    const Real unit = movement_.swing * u_range();
    const Estimate<Real> band{true, found.band * unit, found.low * unit,
                              found.high * unit};
    result_.stick_band = {band, band};
  } else if (sticks) {
    result_.reason = strokes_that_stick(judgement.reason, result_.stick_band);
  }
  if (kModelGap && !options_.verdict_only) stage_ = Stage::kGapStem;
}

template class InPlaceIdentifier<float, kSmallWindow>;
template class InPlaceIdentifier<float, kStandardWindow>;
template class InPlaceIdentifier<float, kLargeWindow>;
template class InPlaceIdentifier<double, kSmallWindow>;
template class InPlaceIdentifier<double, kStandardWindow>;
template class InPlaceIdentifier<double, kLargeWindow>;

}  // namespace ident
