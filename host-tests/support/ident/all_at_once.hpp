// What the library does piece by piece, without a pause.
#pragma once

#include <span>

#include "ident/base/residual_structure.hpp"
#include "ident/process/process_regression.hpp"
#include "ident/process/process_simulation.hpp"
#include "ident/signal/signal_shape.hpp"
#include "ident/two_path/lagged_gram.hpp"
#include "ident/two_path/output_error.hpp"
#include "ident/two_path/two_path_iteration.hpp"
#include "ident/valve/valve_pass.hpp"

namespace test {

template <class Work>
void finish(Work& work) {
  while (!work.step()) {
  }
}

template <class Real>
void finish(ident::ValvePass<Real>& pass) {
  while (!pass.done()) {
    pass.step();
  }
}

template <class Real>
ident::ProcessFit<Real> fit(ident::ProcessRegression<Real>& regression,
                            std::type_identity_t<std::span<const Real>> x,
                            std::type_identity_t<std::span<const Real>> y,
                            const ident::ProcessPoles<Real>& poles, int first_delay,
                            int last_delay, bool drift) {
  regression.start_fit(x, y, poles, first_delay, last_delay, drift);
  finish(regression);
  return regression.result();
}

template <class Real>
ident::ProcessFit<Real> screen(ident::ProcessRegression<Real>& regression,
                               std::type_identity_t<std::span<const Real>> x,
                               std::type_identity_t<std::span<const Real>> y,
                               const ident::ProcessPoles<Real>& poles) {
  regression.start_screen(x, y, poles);
  finish(regression);
  return regression.result();
}

template <class Real>
void simulate(std::type_identity_t<std::span<const Real>> x,
              const ident::ProcessPoles<Real>& poles, const ident::ProcessFit<Real>& fit,
              std::type_identity_t<std::span<Real>> y) {
  ident::ProcessSimulation<Real> simulation;
  simulation.start(x, poles, fit, y);
  simulation.step(y.size());
}

template <class Real>
void accumulate(ident::LaggedGram<Real>& gram, const ident::KnotGrid<Real>& grid,
                const ident::WindowView<Real>& window) {
  gram.start(grid, window);
  gram.step(static_cast<int>(window.u.size()));
}

/// Whether it solved.
template <class Real>
bool fit(ident::TwoPathIteration<Real>& iteration, const ident::LaggedGram<Real>& gram,
         const ident::Structure& structure, ident::TwoPathModel<Real>& model) {
  iteration.start(gram, structure, model);
  finish(iteration);
  return iteration.solved();
}

/// The same behind a linear valve.
template <class Real>
bool fit_linear(ident::TwoPathIteration<Real>& iteration,
                const ident::LaggedGram<Real>& gram, const ident::Structure& structure,
                ident::TwoPathModel<Real>& model) {
  iteration.start_linear(gram, structure, model);
  finish(iteration);
  return iteration.solved();
}

/// The error that is left.
template <class Real>
Real refine(ident::OutputErrorFit<Real>& fit, const ident::WindowView<Real>& window,
            std::type_identity_t<std::span<const Real>> x, int max_steps,
            ident::TwoPathModel<Real>& model, ident::InitialState<Real>& initial,
            std::type_identity_t<std::span<Real>> scratch) {
  fit.start(window, x, max_steps, model, initial, scratch);
  while (!fit.done()) {
    fit.step();
  }
  return fit.error();
}

/// Of y − simulated.
template <class Real>
Real residual_structure(std::span<const Real> y, std::span<const Real> simulated) {
  ident::ResidualStructure<Real> structure;
  for (std::size_t t = 0; t < y.size(); ++t) {
    structure.add(y[t] - simulated[t]);
  }
  return structure.value();
}

template <class Real>
Real level_step(std::span<Real> values) {
  ident::LevelStep<Real> step;
  step.start(values);
  finish(step);
  return step.value();
}

}  // namespace test
