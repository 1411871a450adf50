// The pieces a loop under a real load is drawn from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/real_loads/loop.hpp"
#include "workbench/simulate/draft.hpp"

namespace workbench::test {

/// Drawn once for a seed.
struct RealLoadPlan {
  LoopKind kind = LoopKind::kSticking;
  std::uint64_t seed = 0;
  LoopType type = LoopType::kFlow;
  std::string motion = "none";   ///< as RealLoadTruth
  std::string strokes = "none";  ///< as RealLoadTruth
  std::string cause;             ///< stiction, backlash, or as real_load_loop says
  Historian historian = Historian::kNone;

  /// Simulated samples for one recorded.
  [[nodiscard]] std::size_t thinning() const {
    return historian == Historian::kEverySecond ? 2 : 1;
  }
};

/// A loop while it is drawn.
struct RealLoadDraft {
  Draft draft;
  RealLoadTruth truth;

  [[nodiscard]] std::size_t total() const {
    return draft.setup.warm_up + draft.setup.samples;
  }
};

[[nodiscard]] RealLoadPlan draw_plan(Random& random, LoopKind kind, std::uint64_t seed);

/// Process and controller, its tuning from sluggish to tight; false where the linear loop
/// does not settle.
[[nodiscard]] bool draw_tuned_loop(Random& random, LoopType type, Draft& draft);

/// The factor of the gain at which the linear loop rings for ever; nothing above 200.
[[nodiscard]] std::optional<double> ultimate_gain_factor(const Draft& draft);

[[nodiscard]] Friction draw_friction(Random& random, const RealLoadPlan& plan);

/// The name `make_valve` has for a motion.
[[nodiscard]] std::string_view valve_model(std::string_view motion);

/// Any length that holds 5 to 60 cycles of `period` samples, if there is one; 600 to 4000
/// recorded samples. 0: no period. Sets the warm-up too.
void draw_length(Random& random, const RealLoadPlan& plan, double period, Draft& draft);

/// A load of standard deviation 1 for the whole run, noted in the truth; empty where the
/// piece does not move.
[[nodiscard]] std::vector<double> draw_load(Random& random,
                                            const std::vector<RealLoad>& loads,
                                            RealLoadDraft& loop);

/// Adds `size` times `load` to the input or output of the process; empty signals are 0.
void add_load(std::vector<double>& place, const std::vector<double>& load, double size);

/// Size of what one unit of `load` makes of u when nothing else moves the linear loop
/// without limits: standard deviation after the warm-up.
[[nodiscard]] double linear_answer(const Draft& draft, const std::vector<double>& load,
                                   bool at_output);

/// Moves of the setpoint after the warm-up, around 0 and within ±1: constant, few_moves
/// (2 to 6 at random times) or step_test (3).
[[nodiscard]] std::vector<double> draw_setpoint(Random& random, RealLoadDraft& loop,
                                                bool moves);

/// White measurement noise of 0.5 to 10 % of `y_size`.
void add_noise(Random& random, RealLoadDraft& loop, double y_size);

/// Runs and records the loop; nothing where it is outside the ranges of real_load_loop.
[[nodiscard]] std::optional<RealLoadLoop> record_loop(Random& random,
                                                      const RealLoadPlan& plan,
                                                      RealLoadDraft& loop);

/// What moves y in a loop that is left alone, for loads to be measured against.
struct Movement {
  double x = 0;       ///< standard deviation of the stem, units of u
  double y = 0;       ///< standard deviation, units of y
  double period = 0;  ///< samples; 0 where the loop does not oscillate
};

/// Puts a sticking valve into a loop, off its balance so that it tends to a limit cycle,
/// and says how it moves. Nothing where the motion asks for a tuning that is not there.
[[nodiscard]] std::optional<Movement> draw_sticking_valve(Random& random,
                                                          const RealLoadPlan& plan,
                                                          Draft& draft);

/// One attempt at a loop of the plan; nothing where it is outside the ranges.
[[nodiscard]] std::optional<RealLoadLoop> draw_sticking(
    Random& random, const RealLoadPlan& plan, const std::vector<RealLoad>& loads);
[[nodiscard]] std::optional<RealLoadLoop> draw_healthy(
    Random& random, const RealLoadPlan& plan, const std::vector<RealLoad>& loads);

}  // namespace workbench::test
