#include "workbench/analysis/device_monitor.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "workbench/analysis/identification_json.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

ident::Estimate<double> widened(const ident::Estimate<float>& e) {
  return {e.known, static_cast<double>(e.value), static_cast<double>(e.low),
          static_cast<double>(e.high)};
}

// Shares of the squared error in the coordinates of the loop.
Json gap_json(const ident::MonitorReport<float>& report) {
  const ident::ModelGapReport<float>& gap = report.gap;
  const std::string_view suspect = ident::name(gap.suspect);
  Json json = {{"suspect", suspect.empty() ? Json() : Json(suspect)},
               {"share_of_error", gap.share_of_error},
               {"residual_rms", report.residual_rms}};
  const auto& views = gap.views;
  json["views"] = {
      {"ascending", views.ascending}, {"travel", views.travel},
      {"level", views.level},         {"phase", views.phase},
      {"time", views.time},           {"lag", views.lag},
      {"line", views.line},           {"line_period_samples", views.line_period}};
  return json;
}

}  // namespace

bool timed_step(DeviceMonitor& device, int budget, double& worst_step_us) {
  const auto begin = std::chrono::steady_clock::now();
  const bool more = device.step(budget);
  const std::chrono::duration<double, std::micro> spent =
      std::chrono::steady_clock::now() - begin;
  worst_step_us = std::max(worst_step_us, spent.count());
  return more;
}

ident::PerStroke<double> widened(const ident::PerStroke<float>& strokes) {
  return {widened(strokes.ascending), widened(strokes.descending)};
}

ident::MonitorSettings<float> device_settings(
    const RecordingView& recording, const std::optional<std::pair<float, float>>& span) {
  ident::MonitorSettings<float> settings;
  settings.sample_period_us = std::llround(recording.period_s * 1e6);
  if (span) {
    settings.span_low = span->first;
    settings.span_high = span->second;
  } else {
    const auto [low, high] = std::ranges::minmax_element(recording.u);
    settings.span_low = static_cast<float>(*low);
    settings.span_high = static_cast<float>(*high);
  }
  return settings;
}

ident::Sample<float> device_sample(const RecordingView& recording, std::size_t index) {
  ident::Sample<float> sample;
  sample.t_us = std::llround(recording.t[index] * 1e6);
  sample.u = static_cast<float>(recording.u[index]);
  sample.y = static_cast<float>(recording.y[index]);
  sample.has_sp = recording.has(Column::sp);
  if (sample.has_sp) sample.sp = static_cast<float>(recording.sp[index]);
  return sample;
}

Json event_json(const ident::Event<float>& event, double period_s) {
  Json json = {{"t", event.t_s()}, {"event", ident::name(event.kind)}};
  switch (event.kind) {
    case ident::EventKind::kOscillationStarted:
    case ident::EventKind::kOscillationEnded:
      json["period_s"] = static_cast<double>(event.period_samples) * period_s;
      break;
    case ident::EventKind::kStictionRaised:
    case ident::EventKind::kStictionCleared:
      json["verdict"] = ident::name(event.verdict);
      json["reason"] = ident::sentence(event.reason);
      json["stick_band"] = json_of(widened(event.stick_band));
      json["slip_jump"] = json_of(widened(event.slip_jump));
      break;
    case ident::EventKind::kUndecided:
      json["reason"] = ident::sentence(event.reason);
      break;
    case ident::EventKind::kInputFault:
    case ident::EventKind::kInputRestored:
      json["fault"] = ident::name(event.fault);
      break;
  }
  return json;
}

Json summary_json(std::size_t samples, const ident::MonitorReport<float>& report,
                  double worst_step_us) {
  return {{"event", "summary"},
          {"verdict", ident::name(report.verdict)},
          {"reason", ident::sentence(report.reason)},
          {"stiction_raised", report.stiction_raised},
          {"stick_band", json_of(widened(report.stick_band))},
          {"slip_jump", json_of(widened(report.slip_jump))},
          {"samples", samples},
          {"evaluations", report.counters.evaluations},
          {"events_lost", report.counters.events_lost},
          {"ram_bytes", DeviceMonitor::ram_bytes()},
          {"worst_step_us", worst_step_us},
          {"model_gap", gap_json(report)}};
}

}  // namespace workbench
