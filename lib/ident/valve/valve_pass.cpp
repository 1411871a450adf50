#include "ident/valve/valve_pass.hpp"

#include <algorithm>

namespace ident {
namespace {

// What a piece may take, and what one sample of u takes, instructions of a Cortex-M4F.
constexpr int kMostOfPiece = 60'000;
constexpr int kPerPosition = 35;
constexpr int kPerError = 20;
constexpr int kCostOfStart = 5;

}  // namespace

template <class Real>
void ValvePass<Real>::start(const SearchWindow<Real>& window, std::span<Real> x,
                            std::span<Real> scratch) {
  window_ = window;
  x_ = x.first(window.y.size());
  scratch_ = scratch.first(window.y.size());
  used_ = window.y.size();
  regression_.forget_output();
  stage_ = Stage::kDone;
}

template <class Real>
StickSlipValve<Real> ValvePass<Real>::valve_at_start(
    const ValveModel<Real>& model) const {
  const ValveFriction<Real>& friction = model.friction;
  // Where the stem stood before the window is not known. At the highest u of the first
  // cycle a valve that moves at all trails by half the deadband; the rest of that cycle
  // leads to the state at its start.
  Real start = model.start_known ? model.start : window_.u[0];
  std::size_t top = window_.warm_up;
  if (!model.start_known && window_.warm_up > 0) {
    const auto cycle = window_.u.first(window_.warm_up);
    top = static_cast<std::size_t>(std::max_element(cycle.begin(), cycle.end()) -
                                   cycle.begin());
    start = cycle[top] - friction.deadband / Real(2);
  }
  StickSlipValve<Real> valve(friction, start);
  for (std::size_t t = top; t < window_.warm_up; ++t) {
    valve.step(window_.u[t]);
  }
  return valve;
}

template <class Real>
void ValvePass<Real>::begin(const ValveModel<Real>& model, Stage then, Stage at_last) {
  model_ = model;
  then_ = then;
  at_last_ = at_last;
  next_ = 0;
  stage_ = Stage::kPlace;
}

template <class Real>
void ValvePass<Real>::place(const ValveModel<Real>& model) {
  begin(model, Stage::kDone, Stage::kDone);
}

template <class Real>
void ValvePass<Real>::fit(const ValveModel<Real>& model, bool all_delays) {
  delays_ = all_delays ? every_delay(window_) : delays_near(window_, model.fit.delay);
  begin(model, Stage::kFit, Stage::kDone);
}

template <class Real>
void ValvePass<Real>::fit_next(const ValveModel<Real>& model) {
  const bool placed_already = model.friction == model_.friction &&
                              model.start_known == model_.start_known &&
                              model.start == model_.start;
  fit(model, false);
  if (placed_already) {
    placed();
  }
}

template <class Real>
void ValvePass<Real>::simulate(const ValveModel<Real>& model) {
  begin(model, Stage::kSimulate, Stage::kDone);
}

template <class Real>
void ValvePass<Real>::explain(const ValveModel<Real>& model) {
  begin(model, Stage::kSimulate, Stage::kExplain);
}

template <class Real>
void ValvePass<Real>::screen(const ProcessPoles<Real>& poles) {
  model_.poles = poles;
  regression_.start_screen(positions(), window_.y.first(used_), poles, true);
  stage_ = Stage::kFit;
}

template <class Real>
void ValvePass<Real>::fit_laid(const ProcessPoles<Real>& poles) {
  model_.poles = poles;
  delays_ = every_delay(window_);
  then_ = Stage::kFit;
  placed();
}

template <class Real>
int ValvePass<Real>::place_some() {
  const int decimation = window_.decimation;
  int cost = kCostOfStart;
  if (next_ == 0) {
    valve_ = valve_at_start(model_);
    cost += static_cast<int>(window_.warm_up) * kPerPosition / 1000;
  }
  StickSlipValve<Real> valve = valve_;
  const Real share = Real(1) / static_cast<Real>(decimation);
  const std::size_t at_once =
      static_cast<std::size_t>(kMostOfPiece / kPerPosition / decimation + 1);
  const std::size_t end = std::min(next_ + at_once, used_);
  cost += static_cast<int>(end - next_) * decimation * kPerPosition / 1000;
  const Real* u = &window_.u[next_ * static_cast<std::size_t>(decimation)];
  for (Real& mean : x_.subspan(next_, end - next_)) {
    Real sum = 0;
    for (const Real* const last = u + decimation; u < last; ++u) {
      sum += valve.step(*u);
    }
    mean = sum * share;
  }
  valve_ = valve;
  next_ = end;
  if (next_ == used_) {
    placed();
  }
  return cost;
}

template <class Real>
void ValvePass<Real>::placed() {
  stage_ = then_;
  if (stage_ == Stage::kFit) {
    regression_.start_fit(positions(), window_.y.first(used_), model_.poles,
                          delays_.first, delays_.last, window_.drift, true);
  } else if (stage_ == Stage::kSimulate) {
    simulation_.start(positions(), model_.poles, model_.fit, scratch_.first(used_));
    model_.fit.error = 0;
  }
}

template <class Real>
int ValvePass<Real>::simulate_some() {
  const int per_sample = simulation_.cost_of_sample() + kPerError;
  const std::size_t from = simulation_.simulated();
  const bool over = simulation_.step(static_cast<std::size_t>(kMostOfPiece / per_sample));
  const std::size_t end = simulation_.simulated();
  for (std::size_t t = from; t < end; ++t) {
    const Real e = window_.y[t] - scratch_[t];
    model_.fit.error += e * e;
  }
  if (over) {
    stage_ = at_last_;
    structure_ = {};
    next_ = 0;
  }
  return static_cast<int>(end - from) * per_sample / 1000 + 1;
}

template <class Real>
int ValvePass<Real>::explain_some() {
  constexpr int kPerSample = ResidualStructure<Real>::kPerSample;
  const std::size_t from = next_;
  const std::size_t end = std::min<std::size_t>(from + kMostOfPiece / kPerSample, used_);
  for (; next_ < end; ++next_) {
    structure_.add(window_.y[next_] - scratch_[next_]);
  }
  if (next_ == used_) {
    stage_ = Stage::kDone;
  }
  return static_cast<int>(end - from) * kPerSample / 1000 + 1;
}

template <class Real>
int ValvePass<Real>::step() {
  switch (stage_) {
    case Stage::kPlace:
      return place_some();
    case Stage::kFit: {
      const int cost = regression_.cost_of_step();
      if (regression_.step()) {
        model_.fit = regression_.result();
        model_.known = true;
        stage_ = Stage::kDone;
      }
      return cost;
    }
    case Stage::kSimulate:
      return simulate_some();
    case Stage::kExplain:
      return explain_some();
    case Stage::kDone:
      break;
  }
  return 0;
}

template <class Real>
bool ValvePass<Real>::run(int& left) {
  while (!done() && left > 0) {
    left -= step();
  }
  return done();
}

template class ValvePass<float>;
template class ValvePass<double>;

}  // namespace ident
