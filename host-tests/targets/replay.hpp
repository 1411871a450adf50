// One recording through one monitor, and what it found as lines of text: the same code on
// the emulated board and on the host, so that their answers can be compared.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "host-tests/targets/line.hpp"
#include "ident/monitor.hpp"

namespace targets {

/// How a packed recording begins (pack_recording.py); then u, y, sp of each sample, sp
/// not a number where it is unknown.
struct Header {
  std::array<char, 4> magic{};
  std::uint32_t samples = 0;
  std::int64_t period_us = 0;
};
inline constexpr std::array<char, 4> kMagic{'S', 'B', 'R', '1'};

/// What is measured around a call; the host measures nothing.
struct NoMeter {
  template <class Call>
  auto around(const char*, Call call) {
    return call();
  }
};

enum class Life : unsigned char {
  kWhole,  ///< steps after every sample, as on a device; at last the newest samples
  kLast,   ///< no step until all samples are there: one evaluation, of the newest window
};

/// `read(bytes)` fills a span from the recording and says whether it could; `say(text)`
/// prints. False when the recording is broken. `budget`: of each step.
template <class Monitor, class Real, class Read, class Say, class Meter>
bool replay(Read read, Say say, Meter& meter, Life life, int budget) {
  Header header;
  if (!read(std::as_writable_bytes(std::span(&header, 1))) || header.magic != kMagic) {
    say("error: expected a packed recording, found something else\n");
    return false;
  }
  ident::MonitorSettings<Real> settings;
  settings.sample_period_us = header.period_us;
  static Monitor monitor(settings);
  std::int64_t slices = 0;
  const auto finish_steps = [&] {
    while (meter.around("step", [&] { return monitor.step(budget); })) {
      ++slices;
    }
  };
  std::array<std::int64_t, ident::kEventKinds> events{};
  const auto read_events = [&] {
    while (const auto event = monitor.poll()) {
      ++events[static_cast<std::size_t>(event->kind)];
    }
  };
  for (std::uint32_t k = 0; k < header.samples; ++k) {
    std::array<float, 3> values;
    if (!read(std::as_writable_bytes(std::span(values)))) {
      say("error: the recording ends before its last sample\n");
      return false;
    }
    ident::Sample<Real> sample;
    sample.t_us = static_cast<std::int64_t>(k) * header.period_us;
    sample.u = static_cast<Real>(values[0]);
    sample.y = static_cast<Real>(values[1]);
    sample.has_sp = std::isfinite(values[2]);
    sample.sp = sample.has_sp ? static_cast<Real>(values[2]) : Real(0);
    meter.around("push", [&] { return monitor.push(sample); });
    if (life == Life::kWhole) {
      finish_steps();
    }
    read_events();
  }
  if (life == Life::kWhole) {
    monitor.end_recording();
  }
  finish_steps();
  read_events();
  const ident::MonitorReport<Real> report =
      meter.around("report", [&] { return monitor.report(); });
  const auto tell = [&](const char* name, const ident::Estimate<Real>& estimate) {
    Line line(name);
    say(estimate.known ? line.fixed(estimate.value).text() : (line << "-").text());
  };
  const auto count = [&](const char* name, std::int64_t value) {
    say((Line(name) << value).text());
  };
  say((Line("verdict") << ident::name(report.verdict)).text());
  tell("stick_band_ascending", report.stick_band.ascending);
  tell("stick_band_descending", report.stick_band.descending);
  tell("slip_jump_ascending", report.slip_jump.ascending);
  tell("slip_jump_descending", report.slip_jump.descending);
  count("reason", static_cast<std::int64_t>(report.reason));
  count("raised", report.stiction_raised ? 1 : 0);
  count("samples", header.samples);
  count("window_samples", static_cast<std::int64_t>(report.window_samples));
  count("evaluations", report.counters.evaluations);
  count("slices", slices);
  count("ram_bytes", static_cast<std::int64_t>(Monitor::ram_bytes()));
  for (std::size_t kind = 0; kind < events.size(); ++kind) {
    count(ident::name(static_cast<ident::EventKind>(kind)).data(), events[kind]);
  }
  return true;
}

}  // namespace targets
