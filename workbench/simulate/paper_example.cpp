#include "workbench/simulate/paper_example.hpp"

#include <cmath>
#include <utility>

#include "workbench/simulate/closed_loop.hpp"
#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/he_valve.hpp"
#include "workbench/simulate/noise.hpp"

namespace workbench {

SimulatedLoop paper_example(std::string_view scenario, std::uint64_t seed,
                            const Friction& friction, double setpoint) {
  constexpr double kPeriod = 0.5;
  constexpr double kPole = -0.5;
  const double innovation_std = std::sqrt(0.001);

  LoopSetup setup;
  setup.process = {1.25, 80, 0, 2, false};
  setup.controller = {1.303, 10};
  setup.period_s = kPeriod;
  setup.warm_up = 2000;
  setup.samples = 2800;
  setup.setpoint = {setpoint};
  Random random("paper-example-1", seed);
  setup.noise =
      first_order_noise(random, setup.warm_up + setup.samples, kPole, innovation_std);

  HeValve valve(friction);
  Trajectory run = run_loop(setup, valve);

  SimulatedLoop loop;
  loop.period_s = kPeriod;
  for (std::size_t t = 0; t < setup.samples; ++t) {
    loop.t.push_back(static_cast<double>(t) * kPeriod);
  }
  loop.u = std::move(run.u);
  loop.y = std::move(run.y);
  loop.sp = std::move(run.sp);
  loop.x = std::move(run.x);
  loop.y_clean = std::move(run.y_clean);

  LoopTruth& truth = loop.truth;
  truth.scenario = scenario;
  truth.seed = seed;
  truth.kind = "stiction";
  truth.cause = "stiction";
  truth.stick_band_ascending = friction.stick_band_ascending();
  truth.stick_band_descending = friction.stick_band_descending();
  truth.slip_jump_ascending = friction.slip_jump_ascending();
  truth.slip_jump_descending = friction.slip_jump_descending();
  truth.valve = {"he", friction, 0};
  truth.process = setup.process;
  truth.controller = setup.controller;
  truth.noise_std = innovation_std / std::sqrt(1 - kPole * kPole);
  truth.noise_ceiling_percent = noise_ceiling_percent(loop.y, loop.y_clean);
  truth.oscillation_period_s = kPeriod * measure_cycles(loop.y_clean).period;
  return loop;
}

}  // namespace workbench
