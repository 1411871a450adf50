#include "ident/monitor.hpp"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <memory>

#include "workbench/analysis/identification_json.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/identification_text.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

using Json = nlohmann::ordered_json;
// The standard device's own: same precision, same window.
using Monitor = ident::Monitor<float, ident::kStandardWindow>;
using Event = ident::Event<float>;

struct Options {
  RecordingSource source;
  std::vector<float> span;
  bool json = false;
};

constexpr const char* kFooter = R"(
Examples:
  stickband monitor loop.csv
  stickband monitor bus.log --dbc plant.dbc --u LoopOP.OP --y LoopPV.PV --json

The recording is fed sample by sample to the monitor of the standard device: single
precision, a window of 2048 samples. With --json every event is one line: oscillation_-
started, oscillation_ended, stiction_raised, stiction_cleared, undecided, input_fault,
input_restored; the last line is the summary. The exit code is 4 where no alarm stands
and the last window cannot tell.)";

// Passes over the window in one slice of the evaluation, as between two samples.
constexpr int kSlice = 20;

ident::Estimate<double> widened(const ident::Estimate<float>& e) {
  return {e.known, static_cast<double>(e.value), static_cast<double>(e.low),
          static_cast<double>(e.high)};
}

ident::PerStroke<double> widened(const ident::PerStroke<float>& strokes) {
  return {widened(strokes.ascending), widened(strokes.descending)};
}

// Says what happens, one line each.
class Narrator {
 public:
  Narrator(bool json, double period_s) : json_(json), period_s_(period_s) {}

  void say(const Event& event) const {
    print(json_ ? json_line(event_json(event)) : event_text(event));
  }
  void sum_up(const Recording& recording, const ident::MonitorReport<float>& report,
              double worst_step_us) const {
    print(json_ ? json_line(summary_json(recording, report, worst_step_us))
                : summary_text(recording, report, worst_step_us));
  }

 private:
  [[nodiscard]] Json event_json(const Event& event) const {
    Json json = {{"t", event.t_s()}, {"event", ident::name(event.kind)}};
    switch (event.kind) {
      case ident::EventKind::kOscillationStarted:
      case ident::EventKind::kOscillationEnded:
        json["period_s"] = static_cast<double>(event.period_samples) * period_s_;
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

  [[nodiscard]] std::string event_text(const Event& event) const {
    std::string what;
    switch (event.kind) {
      case ident::EventKind::kOscillationStarted:
        what = "oscillation started, period " +
               duration(static_cast<double>(event.period_samples) * period_s_);
        break;
      case ident::EventKind::kOscillationEnded:
        what = "oscillation ended";
        break;
      case ident::EventKind::kStictionRaised:
        what = "STICTION RAISED, " + bands_text(event.stick_band);
        break;
      case ident::EventKind::kStictionCleared:
        what = "stiction cleared";
        break;
      case ident::EventKind::kUndecided:
        what = "undecided: " + std::string(ident::sentence(event.reason));
        break;
      case ident::EventKind::kInputFault:
        what = "input fault: " + std::string(ident::name(event.fault));
        break;
      case ident::EventKind::kInputRestored:
        what = "input restored";
        break;
    }
    constexpr std::size_t kTime = 16;
    std::string time = fixed(event.t_s(), 1) + " s";
    time = std::string(time.size() < kTime - 2 ? kTime - 2 - time.size() : 0, ' ') + time;
    return time + "  " + wrapped(what, kTime) + '\n';
  }

  [[nodiscard]] static std::string bands_text(const ident::PerStroke<float>& bands) {
    return "stick band " + text_of(widened(bands.ascending)).value + " ascending, " +
           text_of(widened(bands.descending)).value + " descending";
  }

  [[nodiscard]] static Json summary_json(const Recording& recording,
                                         const ident::MonitorReport<float>& report,
                                         double worst_step_us) {
    return {{"event", "summary"},
            {"verdict", ident::name(report.verdict)},
            {"reason", ident::sentence(report.reason)},
            {"stiction_raised", report.stiction_raised},
            {"stick_band", json_of(widened(report.stick_band))},
            {"slip_jump", json_of(widened(report.slip_jump))},
            {"samples", recording.size()},
            {"evaluations", report.counters.evaluations},
            {"events_lost", report.counters.events_lost},
            {"ram_bytes", Monitor::ram_bytes()},
            {"worst_step_us", worst_step_us},
            {"model_gap", gap_json(report)}};
  }

  // Shares of the squared error in the coordinates of the loop.
  [[nodiscard]] static Json gap_json(const ident::MonitorReport<float>& report) {
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

  [[nodiscard]] static std::string summary_text(const Recording& recording,
                                                const ident::MonitorReport<float>& report,
                                                double worst_step_us) {
    std::string text = '\n' + recording.name + ": " + std::to_string(recording.size()) +
                       " samples, " + std::to_string(report.counters.evaluations) +
                       " windows evaluated\n" + std::string(headline(report.verdict)) +
                       '\n';
    if (report.stick_band.ascending.known || report.stick_band.descending.known) {
      text += "Last window: " + bands_text(report.stick_band) + " (units of u)\n";
    }
    const std::string_view suspect = ident::name(report.gap.suspect);
    if (!suspect.empty()) {
      text += wrapped("The model lacks something: " + std::string(suspect) +
                          " would explain " +
                          fixed(static_cast<double>(report.gap.share_of_error) * 100, 0) +
                          " % of its error. Try: stickband ladder " + recording.name,
                      0) +
              '\n';
    }
    text += std::string("The flag is ") + (report.stiction_raised ? "raised" : "down") +
            ".\nMonitor: " + fixed(static_cast<double>(Monitor::ram_bytes()) / 1024, 0) +
            " KiB, longest step " + fixed(worst_step_us, 0) + " us on this machine\n";
    return text;
  }

  bool json_;
  double period_s_;
};

ident::MonitorSettings<float> settings_for(const Recording& recording,
                                           const std::vector<float>& span) {
  ident::MonitorSettings<float> settings;
  settings.sample_period_us = std::llround(recording.period_s * 1e6);
  if (span.empty()) {
    const auto [low, high] = std::minmax_element(recording.u.begin(), recording.u.end());
    settings.span_low = static_cast<float>(*low);
    settings.span_high = static_cast<float>(*high);
  } else {
    settings.span_low = span[0];
    settings.span_high = span[1];
  }
  return settings;
}

ident::Sample<float> sample_at(const Recording& recording, std::size_t i) {
  ident::Sample<float> sample;
  sample.t_us = std::llround(recording.t[i] * 1e6);
  sample.u = static_cast<float>(recording.u[i]);
  sample.y = static_cast<float>(recording.y[i]);
  sample.has_sp = recording.has(Column::sp);
  if (sample.has_sp) sample.sp = static_cast<float>(recording.sp[i]);
  return sample;
}

int monitor(const Options& options) {
  if (!options.span.empty() && !(options.span[0] < options.span[1])) {
    throw UsageError("--span: LOW must be below HIGH");
  }
  const Recording recording = read(options.source);
  for (const std::string& note : recording.resampling.notes) complain(note);
  const auto device = std::make_unique<Monitor>(settings_for(recording, options.span));
  const Narrator narrator(options.json, recording.period_s);
  double worst_step_us = 0;
  const auto finish_steps = [&device, &worst_step_us] {
    for (bool busy = true; busy;) {
      const auto begin = std::chrono::steady_clock::now();
      busy = device->step(kSlice);
      const std::chrono::duration<double, std::micro> spent =
          std::chrono::steady_clock::now() - begin;
      worst_step_us = std::max(worst_step_us, spent.count());
    }
  };
  const auto tell = [&device, &narrator] {
    while (const auto event = device->poll()) narrator.say(*event);
  };
  {
    ProgressLine line;
    for (std::size_t i = 0; i < recording.size(); ++i) {
      device->push(sample_at(recording, i));
      finish_steps();
      tell();
      line.show("sample " + std::to_string(i + 1) + " of " +
                std::to_string(recording.size()));
    }
  }
  device->end_recording();
  finish_steps();
  tell();
  const ident::MonitorReport<float> report = device->report();
  narrator.sum_up(recording, report, worst_step_us);
  return report.stiction_raised ? kDone : exit_code_for(report.verdict, report.reason);
}

}  // namespace

void add_monitor(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "monitor", "Feed a recording sample by sample to the monitor of the device");
  add_recording_options(*command, options->source);
  command
      ->add_option("--span", options->span,
                   "span of u for the alarm limit; its range in the recording by default")
      ->type_name("LOW HIGH")
      ->expected(2);
  command->add_flag("--json", options->json, "one JSON object for each event");
  command->footer(kFooter);
  command->callback(
      [&action, options] { action = [options] { return monitor(*options); }; });
}

}  // namespace workbench::cli
