// The monitor of the standard device on a desk: fed with recordings, told as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "ident/monitor.hpp"
#include "workbench/recording/recording_view.hpp"

namespace workbench {

/// The standard device's own: same precision, same window.
using DeviceMonitor = ident::Monitor<float, ident::kStandardWindow>;

/// Passes over the window in one slice of the evaluation, as between two samples.
inline constexpr int kDeviceSlice = 20;

/// Its step(budget), timed; `worst_step_us`: the longest one so far on this machine.
[[nodiscard]] bool timed_step(DeviceMonitor& device, int budget, double& worst_step_us);

/// Settings for a recording: its sample period, and `span` of u for the alarm limit (low,
/// high), its range in the recording by default.
[[nodiscard]] ident::MonitorSettings<float> device_settings(
    const RecordingView& recording, const std::optional<std::pair<float, float>>& span);

/// One sample of it, with the setpoint where there is one.
[[nodiscard]] ident::Sample<float> device_sample(const RecordingView& recording,
                                                 std::size_t index);

/// The same band or jump in the precision of the desk.
[[nodiscard]] ident::PerStroke<double> widened(const ident::PerStroke<float>& strokes);

/// One line of `stickband monitor --json`. `period_s` is that of the samples.
[[nodiscard]] nlohmann::ordered_json event_json(const ident::Event<float>& event,
                                                double period_s);

/// Its last line. `samples` that were pushed; longest step on this machine, µs.
[[nodiscard]] nlohmann::ordered_json summary_json(
    std::size_t samples, const ident::MonitorReport<float>& report, double worst_step_us);

}  // namespace workbench
