#include "workbench/simulate/paper_example.hpp"

#include <cmath>

#include "workbench/simulate/cycles.hpp"
#include "workbench/simulate/draft.hpp"
#include "workbench/simulate/noise.hpp"

namespace workbench {

SimulatedLoop paper_example(std::string_view scenario, std::uint64_t seed,
                            const Friction& friction, double setpoint) {
  constexpr double kPeriod = 0.5;
  constexpr double kPole = -0.5;
  const double innovation_std = std::sqrt(0.001);

  Draft draft;
  LoopSetup& setup = draft.setup;
  setup.process = {1.25, 80, 0, 2, false};
  setup.controller = {1.303, 10};
  setup.period_s = kPeriod;
  setup.warm_up = 2000;
  setup.samples = 2800;
  setup.setpoint = {setpoint};
  Random random("paper-example-1", seed);
  setup.noise =
      first_order_noise(random, setup.warm_up + setup.samples, kPole, innovation_std);
  draft.noise_std = innovation_std / std::sqrt(1 - kPole * kPole);
  draft.valve_model = "he";
  draft.friction = friction;

  SimulatedLoop loop =
      finish(draft, run_draft(draft), {}, scenario, seed, "stiction", "stiction");
  loop.truth.oscillation_period_s = kPeriod * measure_cycles(loop.y_clean).period;
  return loop;
}

}  // namespace workbench
