#include "ident/in_place_identifier.hpp"

#include <algorithm>
#include <cmath>

#include "ident/configurations.hpp"
#include "ident/cycle_comparison.hpp"
#include "ident/judge.hpp"
#include "ident/path_simulation.hpp"
#include "ident/signal_scale.hpp"

namespace ident {
namespace {

// Decimation leaves at least this many samples in all and in each cycle.
constexpr double kFewestSearched = 600;
constexpr double kFewestPerCycle = 40;
// A valve with a memory is fitted to a first part with so many turning points, then to
// more.
constexpr std::size_t kFirstReversals = 4;

// A setpoint that moves by this share of the standard deviation of y moves the loop.
constexpr double kLeastStep = 0.5;

// What stands for a signal where there is no model.
template <class Real>
Real resting(const SignalScale<Real>& scale, std::span<const Real> values) {
  return scale.moves || values.empty() ? scale.offset : values[0];
}

}  // namespace

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::finish(Verdict verdict, Reason reason) {
  result_.verdict = verdict;
  result_.reason = reason;
  stage_ = Stage::kDone;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::start(std::span<Real> u, std::span<Real> y,
                                              std::span<const Real> sp, int gain_sign) {
  result_ = {};
  two_path_ = linear_ = {};
  chosen_ = {};
  setpoint_ = {};
  scale_of_u_ = scale_of_y_ = {};
  size_ = std::min({u.size(), y.size(), Capacity});
  u_ = u.first(size_);
  y_ = y.first(size_);
  const auto finite = [](Real value) { return std::isfinite(value); };
  if (!std::all_of(u_.begin(), u_.end(), finite) ||
      !std::all_of(y_.begin(), y_.end(), finite)) {
    size_ = 0;
    u_ = y_ = {};
    finish(Verdict::kBadData, Reason::kNotFinite);
    return;
  }
  if (size_ < kFewestSamples) {
    finish(Verdict::kUndecided, Reason::kTooShort);
    return;
  }
  if (sp.size() >= size_ && std::all_of(sp.begin(), sp.begin() + size_, finite)) {
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
    finish(Verdict::kUndecided, survey().refusal());
    return;
  }
  search_.template emplace<StructureSearch<Real>>();
  start_paths(StructureSearch<Real>::ValveKind::kTwoPath);
  stage_ = Stage::kTwoPath;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::start_paths(
    typename StructureSearch<Real>::ValveKind kind) {
  structure().start(window(), kind, {scratch_.data(), size_});
}

template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::step(int budget) {
  switch (stage_) {
    case Stage::kSurvey:
      survey_next();
      break;
    case Stage::kTwoPath:
      if (structure().step(budget)) {
        two_path_ = structure().best();
        start_paths(StructureSearch<Real>::ValveKind::kLinear);
        stage_ = Stage::kLinear;
      }
      break;
    case Stage::kLinear:
      if (structure().step(budget)) {
        linear_ = structure().best();
        take_two_path();
        start_valve();
      }
      break;
    case Stage::kValve:
      if (valve().step(budget)) {
        stage_ = Stage::kWeigh;
      }
      break;
    case Stage::kWeigh:
      weigh();
      break;
    case Stage::kCompare:
      compare_cycles();
      if (doubtful()) {
        last_.template emplace<LoadRival<Real>>();
        rival().start();
        stage_ = Stage::kRival;
      } else {
        start_intervals();
      }
      break;
    case Stage::kRival:
      if (rival().step(valve(), chosen_, scratch_, budget)) {
        result_.evidence.load_ratio = rival().error_ratio();
        start_intervals();
      }
      break;
    case Stage::kIntervals:
      if (intervals_.step(valve(), budget)) {
        stage_ = Stage::kLinearProcess;
      }
      break;
    case Stage::kLinearProcess:
      full_rate_ =
          full_rate_process<Real>(valve().best(ValveForm::kLinear), result_.decimation,
                                  u(), y(), valve().regression());
      stage_ = Stage::kMargin;
      break;
    case Stage::kMargin:
      look_at_margin();
      break;
    case Stage::kSetpoint:
      look_at_setpoint();
      break;
    case Stage::kJudge:
      take_valve();
      break;
    case Stage::kGapWindow:
      start_gap();
      break;
    case Stage::kGap:
      for (int left = budget * kUnit; left > 0 && !gap().done();
           left -= gap().cost_of_step()) {
        gap().step();
      }
      if (gap().done()) {
        take_gap();
      }
      break;
    case Stage::kDone:
      break;
  }
  return done();
}

// The two-path model in the units of the recording.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_two_path() {
  const Real samples = static_cast<Real>(size_);
  const auto fit = [&](const StructureCandidate<Real>& c) {
    return c.known ? Real(100) * (Real(1) - std::sqrt(c.error / samples)) : Real(0);
  };
  result_.fit_percent = fit(two_path_);
  result_.fit_linear_percent = fit(linear_);
  // Equation (8) in the units of y: the scale adds the same to both.
  const Real scale_part = samples * Real(2) * std::log(y_scale());
  result_.aic = two_path_.aic + scale_part;
  result_.aic_linear = linear_.aic + scale_part;

  TwoPathModel<Real>& model = result_.model;
  model = two_path_.model;
  const Real sign = static_cast<Real>(result_.gain_sign);
  Real a_sum = 1;
  for (int i = 0; i < model.process.na; ++i) {
    a_sum += model.process.a[i];
  }
  for (int j = 0; j < model.process.nb; ++j) {
    model.process.b[j] *= sign;
  }
  model.process.d = scale_of_y_.factor * model.process.d + scale_of_y_.offset * a_sum;
  for (Path<Real>* path : {&model.ascending, &model.descending}) {
    for (int k = 0; k <= path->segments; ++k) {
      path->knots[k] = scale_of_u_.back(path->knots[k]);
      path->x[k] *= y_scale();
    }
  }
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::start_valve() {
  const Real samples = static_cast<Real>(size_);
  const Real room =
      std::min(movement_.period / Real(kFewestPerCycle), samples / Real(kFewestSearched));
  const int decimation = std::max(static_cast<int>(room), 1);
  std::size_t count = size_ / decimation;
  std::size_t first = 0;
  if (count > kMostSearched) {
    first = size_ - kMostSearched * decimation;
    count = kMostSearched;
  }
  search_.template emplace<ValveStage>();
  std::span<const Real> means = y();
  if (decimation > 1 || count < size_) {
    const std::span<Real> scaled{valve_stage().stem.data() + count, count};
    if (!scaled_means<Real>(y().subspan(first), decimation, scaled)) {
      finish(Verdict::kUndecided, Reason::kConstant);
      return;
    }
    means = scaled;
  }
  std::size_t reversals = 0;
  std::size_t fifth = first;
  while (reversals < kFirstReversals && ++fifth < first + count * decimation) {
    reversals += ascending_[fifth] != ascending_[fifth - 1] ? 1 : 0;
  }
  SearchWindow<Real> search;
  search.first_part = (fifth - first) / decimation;
  search.u = {u_.data() + first, count * decimation};
  search.y = means;
  search.decimation = decimation;
  search.period = movement_.period / static_cast<Real>(decimation);
  search.warm_up = first_return<Real>(
      u().subspan(first), {ascending_.data() + first, size_ - first}, movement_.period);
  search.swing = movement_.swing;
  search.drift = true;
  result_.decimation = decimation;
  valve().start(search, {valve_stage().stem.data(), count}, {scratch_.data(), count});
  stage_ = Stage::kValve;
}

// Whether the chosen valve explains nearly every cycle better, or a lucky few.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::compare_cycles() {
  const SearchWindow<Real>& search = valve().window();
  CycleComparison<Real> comparison(search.y, search.period);
  comparison.add_reference(valve().simulate(valve().best(ValveForm::kLinear)));
  comparison.add_candidate(valve().simulate(chosen_));
  const CycleGain<Real> gain = comparison.gain();
  result_.evidence.cycles = gain.cycles;
  result_.evidence.cycles_better = gain.better;
  result_.evidence.consistency = gain.consistency;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::weigh() {
  Evidence<Real>& evidence = result_.evidence;
  // The residual of the richest model tells how many samples count.
  const ValveModel<Real>& mixed = valve().best(ValveForm::kMixed);
  evidence.observations = independent_observations<Real>(
      valve().window().y,
      valve().simulate(mixed.known ? mixed : valve().best(ValveForm::kLinear)),
      valve().window().period);
  weigh_forms(valve(), evidence);
  chosen_ = valve().best(evidence.form);
  if (evidence.form == ValveForm::kLinear) {
    start_intervals();
  } else {
    stage_ = Stage::kCompare;
  }
}

// Whether a fault would be found in a few setpoint steps, as far as can be seen.
template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::doubtful() const {
  const Verdict verdict = judge(result_.evidence, result_.loop).verdict;
  const bool fault = verdict == Verdict::kStiction || verdict == Verdict::kBacklash;
  if (!fault || result_.evidence.reversals >= kFiveCycles) {
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
  // χ²(1) at 95 %, widened as calibrated on simulated loops.
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
  intervals_.start(chosen_, limit, movement_.swing, margin);
  for (int form = 1; form < kValveForms; ++form) {
    intervals_.include(valve().best(static_cast<ValveForm>(form)));
  }
  stage_ = Stage::kIntervals;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_valve() {
  const Judgement judgement = judge(result_.evidence, result_.loop);
  result_.cause = cause_of(result_.loop, judgement.verdict);
  const std::span<Real> stem{scratch_.data(), size_};
  scaled_stem(stem);
  full_rate_ = full_rate_process<Real>(chosen_, result_.decimation, stem, y(),
                                       valve().regression());
  result_.fit_valve_percent = full_rate_.fit_percent(size_);
  const ValveFriction<Real>& f = chosen_.friction;
  const ValveIntervals<Real>& bounds = intervals_.intervals();
  const auto estimate = [&](Real value, const typename ValveIntervals<Real>::Bounds& b) {
    return Estimate<Real>{true, value * u_range(), b.low * u_range(), b.high * u_range()};
  };
  if (judgement.verdict == Verdict::kStiction ||
      judgement.verdict == Verdict::kBacklash) {
    result_.stick_band = {estimate(f.stick_ascending(), bounds.stick_ascending),
                          estimate(f.stick_descending(), bounds.stick_descending)};
    result_.slip_jump = {estimate(f.slip_ascending, bounds.slip_ascending),
                         estimate(f.slip_descending, bounds.slip_descending)};
  }
  result_.valve = chosen_;
  result_.valve.friction.deadband *= u_range();
  result_.valve.friction.slip_ascending *= u_range();
  result_.valve.friction.slip_descending *= u_range();
  result_.verdict = judgement.verdict;
  result_.reason =
      strokes_that_stick(judgement.reason, result_.stick_band.ascending.low > Real(0),
                         result_.stick_band.descending.low > Real(0));
  stage_ = Stage::kGapWindow;
}

// Where the chosen valve and its process fail, at the full rate.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::start_gap() {
  const std::size_t used = size_ - full_rate_.delay;
  const std::span<Real> stem{valve_stage().stem.data(), used};
  const std::span<Real> simulated{scratch_.data(), used};
  scaled_stem(stem);
  valve().regression().simulate(stem, full_rate_.poles, full_rate_.fit, simulated);
  GapWindow<Real> view;
  view.stem = stem;
  view.y = y().last(used);
  view.simulated = simulated;
  view.ascending = {ascending_.data(), used};
  view.poles = full_rate_.poles;
  view.fit = full_rate_.fit;
  view.period = movement_.period;
  view.swing = movement_.swing;
  view.observations = result_.evidence.observations;
  view.y_step = result_.loop.y_step * kSwingOfUnit<Real>;
  view.upright = result_.gain_sign > 0;
  last_.template emplace<ModelGap<Real>>();
  gap().start(view);
  stage_ = Stage::kGap;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_gap() {
  result_.gap = gap().report();
  result_.residual_rms = result_.gap.residual * y_scale();
  stage_ = Stage::kDone;
}

// The controller's law around the linear valve's process, which stands in full_rate_.
template <class Real, std::size_t Capacity>
LinearLoop<Real> InPlaceIdentifier<Real, Capacity>::linear_loop() const {
  const Real scale = scale_of_y_.factor / u_range();
  LinearLoop<Real> loop;
  loop.proportional = result_.controller.proportional * scale;
  loop.integral = result_.controller.integral * scale;
  loop.poles = full_rate_.poles;
  loop.fit = full_rate_.fit;
  loop.delay = static_cast<int>(full_rate_.delay);
  loop.samples = static_cast<int>(size_ - full_rate_.delay);
  return loop;
}

// How near to instability the loop is, and whether its model holds.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::look_at_margin() {
  const std::size_t used = size_ - full_rate_.delay;
  LoopEvidence<Real>& loop = result_.loop;
  loop.fit_linear_percent = result_.evidence.fit_linear_percent;
  const Crossover<Real> edge = crossover(linear_loop(), movement_.period);
  if (edge.known) {
    loop.crossover_gain = edge.gain;
    loop.crossover_period = edge.period / movement_.period;
  }
  const std::span<Real> simulated{scratch_.data(), used};
  valve().regression().simulate(u().first(used), full_rate_.poles, full_rate_.fit,
                                simulated);
  loop.gain_beside = gain_beside<Real>(y().last(used), simulated, movement_.period);
  stage_ = setpoint_.empty() ? Stage::kJudge : Stage::kSetpoint;
}

// What the loop makes of the setpoint.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::look_at_setpoint() {
  const std::span<Real> moved{valve_stage().stem.data(), size_};
  for (std::size_t t = 0; t < size_; ++t) {
    moved[t] = (setpoint_[t] - setpoint_[0]) / scale_of_y_.factor;
  }
  result_.loop.setpoint_share = setpoint_share<Real>(linear_loop(), u(), moved, scratch_);
  stage_ = Stage::kJudge;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::simulate_two_path(std::span<Real> y) const {
  const WindowView<Real> view = window();
  if (!two_path_.known) {
    std::fill(y.begin(), y.end(), resting<Real>(scale_of_y_, y_));
    return;
  }
  simulate_paths<Real>(view, PathValve::kPaths, {}, two_path_.model, two_path_.initial,
                       y.first(size_));
  for (Real& value : y.first(size_)) {
    value = scale_of_y_.back(value);
  }
}

// Stem of the chosen valve over the whole window, scaled like u_.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::scaled_stem(std::span<Real> x) const {
  const SearchWindow<Real>& search = valve().window();
  // The start belongs to the searched part, which may be the end of the window only.
  const bool whole =
      search.u.size() + static_cast<std::size_t>(result_.decimation) > size_;
  StickSlipValve<Real> stick_slip = whole ? valve().valve_at_start(chosen_)
                                          : StickSlipValve<Real>(chosen_.friction, u_[0]);
  const bool linear = result_.evidence.form == ValveForm::kLinear;
  const std::size_t count = std::min(x.size(), size_);
  for (std::size_t t = 0; t < count; ++t) {
    x[t] = linear ? u_[t] : stick_slip.step(u_[t]);
  }
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::stem_positions(std::span<Real> x) const {
  if (!chosen_.known) {
    std::fill(x.begin(), x.end(), resting<Real>(scale_of_u_, u_));
    return;
  }
  scaled_stem(x);
  for (std::size_t t = 0; t < size_; ++t) {
    x[t] = scale_of_u_.back(x[t]);
  }
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::simulate_valve(std::span<Real> y) const {
  if (!chosen_.known) {
    std::fill(y.begin(), y.end(), resting<Real>(scale_of_y_, y_));
    return;
  }
  scaled_stem(y);
  const std::size_t used = size_ - full_rate_.delay;
  valve().regression().simulate(y.first(used), full_rate_.poles, full_rate_.fit,
                                y.first(used));
  for (std::size_t t = size_; t-- > 0;) {
    const Real value = y[t >= full_rate_.delay ? t - full_rate_.delay : 0];
    y[t] = scale_of_y_.back(value);
  }
}

template class InPlaceIdentifier<float, kSmallWindow>;
template class InPlaceIdentifier<float, kStandardWindow>;
template class InPlaceIdentifier<float, kLargeWindow>;
template class InPlaceIdentifier<double, kStandardWindow>;
template class InPlaceIdentifier<double, kLargeWindow>;

}  // namespace ident
