// Runs cases of the benchmark through the engine and judges the answers.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hidden/engine.hpp"
#include "support/hidden/case.hpp"

namespace hidden {

/// An interval of the engine for a parameter whose true value is known.
struct Interval {
  std::string parameter;  ///< "valve.backlash deadband"
  double truth = 0;
  double low = 0;
  double high = 0;

  [[nodiscard]] bool covers() const;
};

struct Outcome {
  CaseKey key;
  bool possible = true;  ///< false: no loop of this key shows every effect
  double size = 0;       ///< of the smaller effect (support/hidden/case.hpp)
  Named named;
  double noise = 0;                 ///< rms of what noise and rounding added to y
  double true_model_rmse = 0;       ///< validation error of the true model refitted
  std::vector<Interval> intervals;  ///< of effects in the final model that are true
  double seconds = 0;               ///< of the ladder
};

// One hidden effect; the first that the ladder adds counts, even if it is removed later.
[[nodiscard]] bool right_first(const Outcome& outcome);
[[nodiscard]] bool wrong_first(const Outcome& outcome);

/// Hidden effects that an effect of their own in the final model names, itself or by its
/// group; the assignment that names most.
[[nodiscard]] int hidden_found(const Outcome& outcome);
/// Effects of the final model that name no hidden one, or one that another already named.
[[nodiscard]] int needless(const Outcome& outcome);

/// Validation error after the ladder over that of the true model refitted; NaN or
/// infinite where that could not be fitted.
[[nodiscard]] double error_ratio(const Outcome& outcome);

/// Runs every key, on two threads. `done` is called after each, one at a time.
[[nodiscard]] std::vector<Outcome> run_cases(
    const std::vector<CaseKey>& keys, const std::function<void(const Outcome&)>& done);

/// One line for people: the key and what was answered.
[[nodiscard]] std::string describe(const Outcome& outcome);

}  // namespace hidden
