// The part of an identification at the rate of the recording: the process behind the
// chosen valve, where the loop would become unstable, where the model fails.
// Definitions for in_place_identifier.cpp alone.
#pragma once

#include <algorithm>

#include "ident/in_place_identifier.hpp"

namespace ident {

// The process behind a stem at the full rate: where it starts to be solved.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::begin_process(const ValveModel<Real>& model,
                                                      std::span<const Real> stem) {
  full_rate_ = begin_full_rate_process<Real>(model, result_.decimation, stem, y(),
                                             valve().pass().regression());
}

template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::solve_process(int budget) {
  ProcessRegression<Real>& regression = valve().pass().regression();
  bool over = false;
  for (int left = budget * kUnit; left > 0 && !over;) {
    left -= regression.cost_of_step();
    over = regression.step();
  }
  full_rate_.fit = regression.result();
  return over;
}

// What it makes of a stem, into the scratch.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::begin_output(std::span<const Real> stem) {
  const std::size_t used = size_ - full_rate_.delay;
  valve().pass().simulation().start(stem.first(used), full_rate_.poles, full_rate_.fit,
                                    {scratch_.data(), used});
}

template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::simulate_process(int budget) {
  ProcessSimulation<Real>& simulation = valve().pass().simulation();
  const int samples = budget * kUnit * 1000 / simulation.cost_of_sample();
  return simulation.step(static_cast<std::size_t>(samples));
}

// The search may have seen the end of the window only: where the stem stood before the
// first sample is the best of some places that its band allows. Each is tried in turn,
// then the best once more.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_stem() {
  if constexpr (kMostSearched < Capacity) {
    if (samples_before_searched() > 0 && chosen_.start_known) {
      chosen_.start = placing_.next < kRestingPlaces
                          ? resting_range(chosen_.friction, u_[0]).place(placing_.next)
                          : placing_.start;
      ++placing_.next;
    }
  }
  const std::span<Real> stem{scratch_.data(), size_};
  scaled_stem(stem);
  begin_process(chosen_, stem);
  stage_ = Stage::kProcess;
}

// Whether the process that was solved is that of the chosen valve where it stands best.
template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::placed() {
  if constexpr (kMostSearched < Capacity) {
    if (placing_.next > 0 && placing_.next <= kRestingPlaces) {
      if (placing_.next == 1 || full_rate_.fit.error < placing_.error) {
        placing_.start = chosen_.start;
        placing_.error = full_rate_.fit.error;
      }
      return false;
    }
  }
  return true;
}

// Where the chosen valve and its process fail, at the full rate.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::lay_gap() {
  const std::size_t used = size_ - full_rate_.delay;
  const std::span<Real> stem{valve_stage().stem.data(), used};
  scaled_stem(stem);
  begin_output(stem);
  stage_ = Stage::kGapOutput;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::start_gap() {
  const std::size_t used = size_ - full_rate_.delay;
  const std::span<Real> stem{valve_stage().stem.data(), used};
  const std::span<Real> simulated{scratch_.data(), used};
  if constexpr (kModelGap) {
    last_.template emplace<GapStage>();
    gap().start({.stem = stem,
                 .y = y().last(used),
                 .simulated = simulated,
                 .ascending = {ascending_.data(), used},
                 .poles = full_rate_.poles,
                 .fit = full_rate_.fit,
                 .period = movement_.period,
                 .swing = movement_.swing,
                 .observations = result_.evidence.observations,
                 .y_step = result_.loop.y_step * kSwingOfUnit<Real>,
                 .upright = result_.gain_sign > 0});
    stage_ = Stage::kGap;
  }
}

template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::look_for_gap(int budget) {
  if constexpr (kModelGap) {
    for (int left = budget * kUnit; left > 0 && !gap().done();
         left -= gap().cost_of_step()) {
      gap().step();
    }
    return gap().done();
  } else {
    return true;
  }
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_gap() {
  if constexpr (kModelGap) {
    result_.gap = gap().report();
    result_.residual_rms = result_.gap.residual * y_scale();
    stage_ = Stage::kDone;
  }
}

// The controller's law around the linear valve's process, which stands in full_rate_.
template <class Real, std::size_t Capacity>
LinearLoop<Real> InPlaceIdentifier<Real, Capacity>::linear_loop() const {
  const Real scale = scale_of_y_.factor / u_range();
  return {.proportional = result_.controller.proportional * scale,
          .integral = result_.controller.integral * scale,
          .poles = full_rate_.poles,
          .fit = full_rate_.fit,
          .delay = static_cast<int>(full_rate_.delay),
          .samples = static_cast<int>(size_ - full_rate_.delay)};
}

// The process behind a valve that follows u; what asks for it comes next.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::look_at_loop() {
  if (!kNamesCause && setpoint_.empty()) {
    stage_ = Stage::kStem;
    return;
  }
  begin_process(valve().best(ValveForm::kLinear), u());
  stage_ = Stage::kLinearProcess;
}

// How near to instability the loop is.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::look_at_crossover() {
  LoopEvidence<Real>& loop = result_.loop;
  loop.fit_linear_percent = result_.evidence.fit_linear_percent;
  const Crossover<Real> edge = crossover(linear_loop(), movement_.period);
  if (edge.known) {
    loop.crossover_gain = edge.gain;
    loop.crossover_period = edge.period / movement_.period;
  }
  begin_output(u());
  stage_ = Stage::kLinearOutput;
}

// Whether its model holds.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::look_at_margin() {
  const std::size_t used = size_ - full_rate_.delay;
  const std::span<const Real> simulated{scratch_.data(), used};
  result_.loop.gain_beside =
      gain_beside<Real>(y().last(used), simulated, movement_.period);
  stage_ = setpoint_.empty() ? Stage::kStem : Stage::kSetpoint;
}

// What the loop makes of the setpoint.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::look_at_setpoint() {
  const std::span<Real> moved{valve_stage().stem.data(), size_};
  for (std::size_t t = 0; t < size_; ++t) {
    moved[t] = (setpoint_[t] - setpoint_[0]) / scale_of_y_.factor;
  }
  result_.loop.setpoint_share = setpoint_share<Real>(linear_loop(), u(), moved, scratch_);
  stage_ = Stage::kStem;
}

// The chosen valve before the first sample of the window, once it is placed there.
template <class Real, std::size_t Capacity>
StickSlipValve<Real> InPlaceIdentifier<Real, Capacity>::chosen_valve() const {
  if (samples_before_searched() == 0) {
    return valve().pass().valve_at_start(chosen_);
  }
  return {chosen_.friction, chosen_.start_known ? chosen_.start : u_[0]};
}

// Stem of the chosen valve over the whole window, scaled like u_.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::scaled_stem(std::span<Real> x) const {
  StickSlipValve<Real> stick_slip = chosen_valve();
  const bool linear = result_.evidence.form == ValveForm::kLinear;
  const std::size_t count = std::min(x.size(), size_);
  for (std::size_t t = 0; t < count; ++t) {
    x[t] = linear ? u_[t] : stick_slip.step(u_[t]);
  }
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::stem_positions(std::span<Real> x) const {
  if (!chosen_.known) {
    std::fill(x.begin(), x.end(), scale_of_u_.resting(u_));
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
    std::fill(y.begin(), y.end(), scale_of_y_.resting(y_));
    return;
  }
  scaled_stem(y);
  const std::size_t used = size_ - full_rate_.delay;
  ProcessSimulation<Real> simulation;
  simulation.start(y.first(used), full_rate_.poles, full_rate_.fit, y.first(used));
  simulation.step(used);
  for (std::size_t t = size_; t-- > 0;) {
    const Real value = y[t >= full_rate_.delay ? t - full_rate_.delay : 0];
    y[t] = scale_of_y_.back(value);
  }
}

template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::searched() const {
  const ValveStage* stage = std::get_if<ValveStage>(&search_);
  return stage == nullptr || stage->search.searched();
}

template <class Real, std::size_t Capacity>
EarlierValve InPlaceIdentifier<Real, Capacity>::next_start() const {
  EarlierValve found;
  if (is_fault(result_.verdict) && result_.valve.known) {
    found = earlier_valve(result_.valve, result_.decimation, valve().window().y.size());
  }
  return next_earlier(options_.earlier != nullptr ? *options_.earlier : EarlierValve{},
                      found, searched());
}

}  // namespace ident
