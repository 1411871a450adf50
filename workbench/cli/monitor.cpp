#include <CLI/CLI.hpp>
#include <memory>

#include "workbench/analysis/device_monitor.hpp"
#include "workbench/analysis/identification_json.hpp"
#include "workbench/analysis/wording.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/console.hpp"
#include "workbench/cli/exit_code.hpp"
#include "workbench/cli/identification_text.hpp"
#include "workbench/cli/next_file.hpp"
#include "workbench/cli/recording_options.hpp"
#include "workbench/recording/option_words.hpp"

namespace workbench::cli {
namespace {

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
precision, a window of 2048 samples. With --json every event is one line:
oscillation_started, oscillation_ended, stiction_raised, stiction_cleared, undecided,
input_fault, input_restored; the last line is the summary. The exit code is 4 where no
alarm stands and the last window cannot tell.)";

// Says what happens, one line each.
class Narrator {
 public:
  Narrator(bool json, double period_s) : json_(json), period_s_(period_s) {}

  void say(const Event& event) const {
    print(json_ ? json_line(event_json(event, period_s_)) : event_text(event));
  }
  void sum_up(const Recording& recording, const ident::MonitorReport<float>& report,
              double worst_step_us, const std::string& ladder) const {
    print(json_ ? json_line(summary_json(recording.size(), report, worst_step_us))
                : summary_text(recording, report, worst_step_us, ladder));
  }

 private:
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
    return "stick band " + with_interval(widened(bands).ascending) + " ascending, " +
           with_interval(widened(bands).descending) + " descending, in units of u";
  }

  [[nodiscard]] static std::string summary_text(const Recording& recording,
                                                const ident::MonitorReport<float>& report,
                                                double worst_step_us,
                                                const std::string& ladder) {
    std::string text = '\n' + recording.name + ": " + std::to_string(recording.size()) +
                       " samples, " + std::to_string(report.counters.evaluations) +
                       " windows evaluated\n" + std::string(headline_of(report)) + '\n';
    if (report.stick_band.ascending.known || report.stick_band.descending.known) {
      text += wrapped("Last window: " + bands_text(report.stick_band), 0) + '\n';
    }
    const std::string_view suspect = ident::name(report.gap.suspect);
    if (!suspect.empty()) {
      text += wrapped("The model lacks something: " + std::string(suspect) +
                          " would explain " +
                          fixed(static_cast<double>(report.gap.share_of_error) * 100, 0) +
                          " % of its error. To see what it does:",
                      0) +
              "\n  " + ladder + '\n';
    }
    text += std::string("The flag is ") + (report.stiction_raised ? "raised" : "down") +
            ".\nMonitor: " +
            fixed(static_cast<double>(DeviceMonitor::ram_bytes()) / 1024, 0) +
            " KiB, longest step " + fixed(worst_step_us, 0) + " us on this machine\n";
    return text;
  }

  bool json_;
  double period_s_;
};

int monitor(const Options& options) {
  if (!options.span.empty() && !(options.span[0] < options.span[1])) {
    throw UsageError("--span: LOW must be below HIGH");
  }
  const Recording recording = read(options.source);
  for (const std::string& note : recording.resampling.notes) complain(note);
  std::optional<std::pair<float, float>> span;
  if (!options.span.empty()) {
    span.emplace(options.span[0], options.span[1]);
  } else if (const auto configured = configured_span(options.source)) {
    span.emplace((*configured)[0], (*configured)[1]);
  }
  const auto device = std::make_unique<DeviceMonitor>(device_settings(recording, span));
  const Narrator narrator(options.json, recording.period_s);
  double worst_step_us = 0;
  const auto finish_steps = [&device, &worst_step_us] {
    while (timed_step(*device, kDeviceSlice, worst_step_us)) {
    }
  };
  const auto tell = [&device, &narrator] {
    while (const auto event = device->poll()) narrator.say(*event);
  };
  {
    ProgressLine line;
    for (std::size_t i = 0; i < recording.size(); ++i) {
      device->push(device_sample(recording, i));
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
  narrator.sum_up(recording, report, worst_step_us,
                  "stickband ladder " + file_word(options.source.path) +
                      option_words(options.source) + " -o " + file_word(next_file("")));
  return report.stiction_raised ? kDone : exit_code_for(report.verdict, report.reason);
}

}  // namespace

void add_monitor(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "monitor", "Feed a recording sample by sample to the monitor of the device");
  add_recording_options(*command, options->source);
  command
      ->add_option(
          "--span", options->span,
          "span of u for the alarm limit; by default that of --config, or its range in "
          "the recording")
      ->type_name("LOW HIGH")
      ->expected(2);
  command->add_flag("--json", options->json, "one JSON object for each event");
  runs(*command, action, options, monitor, kFooter);
}

}  // namespace workbench::cli
