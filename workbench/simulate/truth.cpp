#include "workbench/simulate/truth.hpp"

#include <cmath>
#include <limits>

#include "workbench/recording/statistics.hpp"

namespace workbench {
namespace {

nlohmann::json number_or_null(double value, bool known) {
  if (!known || !std::isfinite(value)) return nullptr;
  return value;
}

}  // namespace

double noise_ceiling_percent(std::span<const double> y, std::span<const double> y_clean) {
  const double mean = mean_of(y);
  double missed = 0;
  double total = 0;
  for (std::size_t t = 0; t < y.size(); ++t) {
    missed += (y_clean[t] - y[t]) * (y_clean[t] - y[t]);
    total += (y[t] - mean) * (y[t] - mean);
  }
  if (total == 0) return std::numeric_limits<double>::quiet_NaN();
  return 100 * (1 - std::sqrt(missed / total));
}

nlohmann::json truth_json(const LoopTruth& truth) {
  const ValveTruth& valve = truth.valve;
  const bool low_limit = truth.controller.low > -1e299;
  const bool high_limit = truth.controller.high < 1e299;
  return {
      {"schema", 1},
      {"scenario", truth.scenario},
      {"seed", truth.seed},
      {"kind", truth.kind},
      {"cause", truth.cause},
      {"stick_band",
       {{"ascending", truth.stick_band_ascending},
        {"descending", truth.stick_band_descending}}},
      {"slip_jump",
       {{"ascending", truth.slip_jump_ascending},
        {"descending", truth.slip_jump_descending}}},
      {"valve",
       {{"model", valve.model},
        {"static_ascending", valve.friction.static_ascending},
        {"static_descending", valve.friction.static_descending},
        {"kinetic_ascending", valve.friction.kinetic_ascending},
        {"kinetic_descending", valve.friction.kinetic_descending},
        {"positioner_lag_s", valve.positioner_lag_s}}},
      {"process",
       {{"gain", truth.process.gain},
        {"lag_s", truth.process.lag_s},
        {"second_lag_s", truth.process.second_lag_s},
        {"dead_time_s", truth.process.dead_time_s},
        {"integrating", truth.process.integrating}}},
      {"controller",
       {{"gain", truth.controller.gain},
        {"reset_time_s", truth.controller.reset_time_s},
        {"low", number_or_null(truth.controller.low, low_limit)},
        {"high", number_or_null(truth.controller.high, high_limit)}}},
      {"u_limited", truth.u_limited},
      {"noise_std", truth.noise_std},
      {"noise_ceiling_percent", number_or_null(truth.noise_ceiling_percent, true)},
      {"oscillation_period_s",
       number_or_null(truth.oscillation_period_s, truth.oscillation_period_s > 0)},
  };
}

}  // namespace workbench
