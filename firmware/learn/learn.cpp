#include "firmware/learn/learn.hpp"

#include <poll.h>
#include <sys/signalfd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <memory>
#include <stdexcept>

#include "config/source_reader.hpp"
#include "hal/clock.hpp"
#include "hal/descriptor.hpp"
#include "hal/slcan_client.hpp"
#include "hal/socketcan.hpp"
#include "wire/candump_reader.hpp"

namespace firmware {
namespace {

constexpr std::size_t kMostLogBytes = std::size_t{512} << 20;

// The number of the last line where it was cut and left out, else 0.
std::size_t read_log(const std::string& path, FrameSurvey& survey) {
  std::string text;
  std::string error;
  if (!config::read_text(path, kMostLogBytes, text, error)) {
    throw config::ConfigError(path + ": " + error);
  }
  wire::CandumpReader log(text);
  while (log.next()) {
    if (log.is_xl()) continue;
    if (!log.status().ok()) {
      throw config::ConfigError(path + ':' + std::to_string(log.number()) + ':' +
                                std::to_string(log.status().column) + ": expected " +
                                wire::expected_at(log.status().error) +
                                "; repair the line or record with candump -L");
    }
    const wire::CandumpLine& line = log.line();
    survey.take(std::string(line.interface), line.time_ns / 1000, line.frame);
  }
  if (survey.frames() == 0) {
    throw config::ConfigError(path + ": expected frames, found none; name a candump log");
  }
  return log.cut_line();
}

std::unique_ptr<hal::CanBus> open_bus(const std::string& name) {
  std::unique_ptr<hal::CanBus> bus;
  if (const std::optional<std::uint16_t> port = hal::slcan_port(name)) {
    bus = std::make_unique<hal::SlcanClient>(*port);
  } else {
    const std::vector<hal::CanFilter> everything = {{.extended = false, .mask = 0},
                                                    {.extended = true, .mask = 0}};
    bus = std::make_unique<hal::SocketCan>(name, everything);
  }
  if (!bus->open()) throw std::runtime_error(bus->error());
  return bus;
}

void listen(const LearnSettings& settings, FrameSurvey& survey) {
  const hal::SystemClock clock;
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  sigprocmask(SIG_BLOCK, &signals, nullptr);
  const hal::Descriptor ending(signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC));
  const std::unique_ptr<hal::CanBus> bus = open_bus(settings.can);
  const std::int64_t end_us = clock.monotonic_us() + std::llround(settings.seconds * 1e6);
  std::array<hal::ReceivedFrame, 64> frames;
  while (clock.monotonic_us() < end_us) {
    constexpr int kWait_ms = 100;
    std::array<pollfd, 2> waiting = {
        {{ending.get(), POLLIN, 0}, {bus->descriptor(), POLLIN, 0}}};
    poll(waiting.data(), waiting.size(), kWait_ms);
    if (waiting[0].revents != 0) break;
    std::size_t count = 0;
    const hal::CanStatus status = bus->read(frames, count);
    for (const hal::ReceivedFrame& received : std::span(frames).first(count)) {
      const std::int64_t t_us =
          received.time_us > 0 ? received.time_us : clock.realtime_us();
      survey.take(settings.can, t_us, received.frame);
    }
    if (status == hal::CanStatus::kDown || status == hal::CanStatus::kLost) {
      throw std::runtime_error(bus->error());
    }
  }
  if (survey.frames() == 0) {
    throw std::runtime_error(settings.can +
                             ": expected frames, found none; is the bit rate right?");
  }
}

}  // namespace

Learned learn(const LearnSettings& settings) {
  Learned out{.source = settings.log.empty() ? settings.can : settings.log,
              .dbc = settings.dbc};
  std::unique_ptr<config::DbcFile> dbc;
  if (!settings.dbc.empty()) {
    std::string text;
    std::string error;
    if (!config::read_text(settings.dbc, config::DbcFile::kMaxBytes, text, error)) {
      throw config::ConfigError(settings.dbc + ": " + error);
    }
    dbc = std::make_unique<config::DbcFile>(std::move(text), settings.dbc);
    if (!dbc->error().empty()) throw config::ConfigError(dbc->error());
  }
  if (settings.log.empty()) {
    listen(settings, out.survey);
  } else {
    out.cut_line = read_log(settings.log, out.survey);
  }
  out.signals =
      dbc ? named_signals(out.survey, *dbc, settings.dbc) : guessed_signals(out.survey);
  out.proposals = propose_loops(out.signals);
  return out;
}

}  // namespace firmware
