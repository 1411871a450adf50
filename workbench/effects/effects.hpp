// The effects, one file each: the table of contents of the physics.
#pragma once

#include "workbench/effects/effect.hpp"

namespace workbench::effects {

[[nodiscard]] const Effect& valve_positioner_lag();
[[nodiscard]] const Effect& valve_rate_limit();
[[nodiscard]] const Effect& valve_stiction();
[[nodiscard]] const Effect& valve_backlash();
[[nodiscard]] const Effect& valve_saturation();
[[nodiscard]] const Effect& valve_characteristic();
[[nodiscard]] const Effect& process_dead_time();
[[nodiscard]] const Effect& process_second_lag();
[[nodiscard]] const Effect& process_integrating();
[[nodiscard]] const Effect& process_directional_lag();
[[nodiscard]] const Effect& process_slow_tail();
[[nodiscard]] const Effect& process_nonlinear_gain();
[[nodiscard]] const Effect& process_gain_drift();
[[nodiscard]] const Effect& process_overflow();
[[nodiscard]] const Effect& disturbance_sinusoid();
[[nodiscard]] const Effect& disturbance_step();
[[nodiscard]] const Effect& disturbance_ramp();
/// The load recorded in a column, by its name (Load::name): one effect for each name,
/// made when first asked for, that lives as long as the program. From any thread.
inline constexpr std::string_view kMeasuredLoad = "disturbance.measured:";
[[nodiscard]] const Effect& disturbance_measured(std::string_view column);
[[nodiscard]] const Effect& sensor_lag();
[[nodiscard]] const Effect& sensor_quantisation();
[[nodiscard]] const Effect& process_inverse_response();
[[nodiscard]] const Effect& process_oscillatory();
[[nodiscard]] const Effect& sensor_saturation();
[[nodiscard]] const Effect& sensor_sticking();
[[nodiscard]] const Effect& sensor_spikes();
[[nodiscard]] const Effect& record_compression();

}  // namespace workbench::effects
