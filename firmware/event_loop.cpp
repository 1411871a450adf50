#include "firmware/event_loop.hpp"

#include <malloc.h>
#include <poll.h>
#include <sys/signalfd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "firmware/metrics.hpp"
#include "firmware/notice_text.hpp"
#include "firmware/replace_file.hpp"
#include "wire/big_endian.hpp"
#include "wire/crc32.hpp"

namespace firmware {
namespace {

constexpr int kSlice = 8;                        // pieces of identification at a time
constexpr std::int64_t kTurn_us = 3'000;         // with identification, about
constexpr std::int64_t kGather_us = 5'000;       // frames are collected that long
constexpr std::int64_t kRoom_us = 1'000;         // until a full bus is tried again
constexpr std::int64_t kOldest_us = 10'000'000;  // of a frame that can be believed
constexpr std::int64_t kPolled_us = 5'000;       // for buses without descriptor

sigset_t ending_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&set, signal);
  return set;
}

// Memory that is reserved is there at once: the allocator writes to all of it. Otherwise
// each page would come when it is first used, one that a rare search uses after weeks.
void fill_what_is_allocated() {
#ifdef __GLIBC__
  constexpr int kAnyByte = 0x5A;
  mallopt(M_PERTURB, kAnyByte);
#endif
}

}  // namespace

EventLoop::EventLoop(const hal::Clock& clock, Log& log)
    : clock_(clock), log_(log), random_(system_random()) {}

Now EventLoop::now() const {
  return {clock_.monotonic_us(), clock_.realtime_us()};
}

void EventLoop::run(const std::string& path) {
  path_ = path;
  fill_what_is_allocated();
  const sigset_t signals = ending_signals();
  sigprocmask(SIG_BLOCK, &signals, nullptr);
  signals_ = hal::Descriptor(signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC));
  gateway_ = std::make_unique<Gateway>(config::read_gateway(path), *random_, clock_);
  writes_.set(gateway_->configuration.writes_per_hour);
  state_ = take_state(gateway_->configuration);
  const std::string missing = gateway_->devices.open_all();
  if (!missing.empty()) throw std::runtime_error(missing);
  tell_devices();
  if (state_) state_->restore(gateway_->daemon, now());
  // Years of history may take a while to be read.
  drive(gateway_->daemon.flags(), now());
  const std::string taken = take_history();
  if (!taken.empty()) throw std::runtime_error(taken);
  states_.resize(gateway_->devices.buses.size());
  write_metrics({gateway_->daemon.gateway(), gateway_->daemon.loops()},
                gateway_->configuration.group, textfile_);
  manager_.tell("READY=1");
  log_.write(now().us, Priority::kNotice, "started");
  while (!ended_) turn();
  manager_.tell("STOPPING=1");
  for (std::size_t k = 0; k < gateway_->devices.lines.size(); ++k) {
    LineDevice& line = gateway_->devices.lines[k];
    if (line.open) (void)line.line->set(gateway_->configuration.loops[k].flag->fail_safe);
  }
  if (state_) state_->finish(gateway_->daemon, now());
  if (history_) history_->finish();
  log_.write(now().us, Priority::kNotice, "stopped");
}

void EventLoop::turn() {
  if (wait(busy_)) take_signals();
  const Now at = now();
  frame_count_ = reading_count_ = 0;
  read_buses(at);
  read_converters(at);
  const Inputs inputs{std::span(frames_).first(frame_count_),
                      std::span(readings_).first(reading_count_), states_, failures_};
  const Outputs& outputs = gateway_->daemon.step(at, inputs);
  step_us_ = outputs.next_us;
  received_ = frame_count_ > 0;
  send(outputs);
  drive(outputs.flags, at);
  tell(outputs, at);
  write_textfile(at);
  if (state_) {
    state_->keep(gateway_->daemon, at, writes_);
    failures_.state = state_->failures();
  }
  if (history_) {
    history_->take(outputs.rows);
    history_->keep(at.us, writes_);
    failures_.history = history_->failures();
  }
  if (manager_.watchdog_us() > 0 && at.us >= watchdog_us_) {
    watchdog_us_ = at.us + manager_.watchdog_us();
    manager_.tell("WATCHDOG=1");
  }
  busy_ = true;
  std::int64_t time_us = clock_.monotonic_us();
  while (busy_ && time_us < at.us + kTurn_us) {
    busy_ = gateway_->daemon.work(kSlice);
    const std::int64_t before_us = std::exchange(time_us, clock_.monotonic_us());
    gateway_->daemon.charge(time_us - before_us);
  }
}

bool EventLoop::wait(bool busy) {
  std::array<pollfd, 16> waiting;
  std::size_t count = 0;
  waiting[count++] = {signals_.get(), POLLIN, 0};
  std::int64_t until_us = step_us_;
  const std::int64_t now_us = clock_.monotonic_us();
  // A few frames at a time cost less than one by one.
  if (received_ && !busy) until_us = std::min(until_us, now_us + kGather_us);
  for (const BusDevice& device : gateway_->devices.buses) {
    const int descriptor = device.up ? device.bus->descriptor() : -1;
    if (device.up && descriptor < 0) until_us = std::min(until_us, now_us + kPolled_us);
    if (device.queued > 0) until_us = std::min(until_us, now_us + kRoom_us);
    if (descriptor >= 0 && !received_ && count < waiting.size()) {
      waiting[count++] = {descriptor, POLLIN, 0};
    }
  }
  for (const ConverterDevice& device : gateway_->devices.converters) {
    until_us = std::min(until_us, device.next_us);
  }
  const std::int64_t wait_us = busy || until_us <= now_us ? 0 : until_us - now_us;
  const timespec time{wait_us / 1'000'000, wait_us % 1'000'000 * 1000};
  return ppoll(waiting.data(), count, &time, nullptr) > 0 && waiting[0].revents != 0;
}

void EventLoop::take_signals() {
  signalfd_siginfo signal{};
  while (read(signals_.get(), &signal, sizeof signal) == sizeof signal) {
    if (signal.ssi_signo == SIGHUP) {
      reload();
    } else {
      ended_ = true;
    }
  }
}

std::unique_ptr<StateKeeper> EventLoop::take_state(const config::Gateway& gateway) {
  if (!gateway.state) return nullptr;
  auto state = std::make_unique<StateKeeper>(gateway, log_);
  if (!state->lock()) {
    throw std::runtime_error(config::at_place(
        gateway, gateway.state->place,
        "expected a state file of its own, found that another process has " +
            gateway.state->path + "; end that one, or name another file"));
  }
  return state;
}

std::string EventLoop::take_history() {
  const config::Gateway& gateway = gateway_->configuration;
  if (!gateway.history) return {};
  history_ = std::make_unique<HistoryKeeper>(*gateway.history, log_);
  if (history_->open(gateway_->daemon, now().us)) return {};
  history_.reset();
  return config::at_place(
      gateway, gateway.history->place,
      "expected a history of its own, found that another process has " +
          gateway.history->path + "; end that one, or name another file");
}

// What the gateway remembers goes on, with or without a file.
void EventLoop::take_memory(Daemon& next) {
  std::vector<std::uint8_t> image(wire::kMostStateBytes);
  image.resize(gateway_->daemon.save(image));
  const Now at = now();
  (void)next.restore(image, at);
  image.resize(
      wire::windows_bytes(gateway_->configuration.loops.size(), Monitor::kCapacity));
  const std::size_t size = gateway_->daemon.save_windows(at, 0, image);
  if (size == 0) return;
  image.resize(size + 4);
  wire::put_big_endian(wire::crc32(std::span(image).first(size)),
                       std::span(image).subspan(size));
  (void)next.restore_windows(image, at, true);
}

void EventLoop::reload() {
  manager_.tell("RELOADING=1");
  try {
    auto next = std::make_unique<Gateway>(config::read_gateway(path_), *random_, clock_);
    // All that can fail comes first, while the old gateway works.
    const auto& old_state = gateway_->configuration.state;
    const auto& new_state = next->configuration.state;
    const bool same_state = old_state && new_state && old_state->path == new_state->path;
    std::unique_ptr<StateKeeper> state;
    if (!same_state) state = take_state(next->configuration);
    const std::string missing = next->devices.open_new(gateway_->devices);
    if (!missing.empty()) throw config::ConfigError(missing);
    take_memory(next->daemon);
    // Lines and ports can be taken anew only once the old ones are given back.
    gateway_.reset();
    gateway_ = std::move(next);
    state_.reset();
    writes_.set(gateway_->configuration.writes_per_hour);
    state_ = same_state ? take_state(gateway_->configuration) : std::move(state);
    states_.assign(gateway_->devices.buses.size(), {});
    // Flag lines go on at once as they stood, before years of history are read.
    const std::span<const bool> flags = gateway_->daemon.flags();
    for (std::size_t k = 0; k < flags.size(); ++k) {
      gateway_->devices.lines[k].level = flags[k];
    }
    const std::string lost = gateway_->devices.open_all();
    if (!lost.empty())
      log_.write(now().us, Priority::kError, lost.c_str(), Topic::kDevices);
    tell_devices();
    if (history_) history_->finish();
    history_.reset();
    const std::string taken = take_history();
    if (!taken.empty()) log_.write(now().us, Priority::kError, taken.c_str());
    write_metrics({gateway_->daemon.gateway(), gateway_->daemon.loops()},
                  gateway_->configuration.group, textfile_);
    step_us_ = textfile_us_ = 0;
    log_.write(now().us, Priority::kNotice, "configuration loaded anew");
  } catch (const std::runtime_error& error) {
    log_.write(now().us, Priority::kError, error.what());
    log_.write(now().us, Priority::kError, "the configuration stays as it was");
  }
  manager_.tell("READY=1");
}

void EventLoop::read_buses(const Now& at) {
  const std::int64_t epoch_us = at.epoch_us - at.us;
  std::array<hal::ReceivedFrame, 256> received;
  auto& buses = gateway_->devices.buses;
  for (std::size_t k = 0; k < buses.size(); ++k) {
    BusDevice& device = buses[k];
    if (!device.up) device.reopen(at.us);
    while (device.up && frame_count_ < kMostFrames) {
      const std::size_t room = std::min(received.size(), kMostFrames - frame_count_);
      std::size_t count = 0;
      const hal::CanStatus status =
          device.bus->read(std::span(received).first(room), count);
      for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t t_us = received[i].time_us - epoch_us;
        const bool believable = t_us <= at.us && t_us >= at.us - kOldest_us;
        frames_[frame_count_++] = {k, believable ? t_us : at.us, received[i].frame};
      }
      if (status == hal::CanStatus::kOk) continue;
      if (status == hal::CanStatus::kWait) break;
      log_.write(at.us, Priority::kWarning, device.bus->error(), Topic::kDevices);
      device.lost(status, at.us);
    }
    states_[k] = {device.up, device.queued == 0, device.bus->drops()};
  }
  if (buses.size() > 1) sort_frames();
}

// By time; those of one instant stay as they came, for they may be parts of a message.
void EventLoop::sort_frames() {
  const auto begin = frames_.begin();
  for (auto at = begin; at < begin + static_cast<std::ptrdiff_t>(frame_count_); ++at) {
    const auto place = std::upper_bound(
        begin, at, *at,
        [](const BusFrame& a, const BusFrame& b) { return a.t_us < b.t_us; });
    std::rotate(place, at, at + 1);
  }
}

void EventLoop::read_converters(const Now& at) {
  auto& converters = gateway_->devices.converters;
  for (std::size_t k = 0; k < converters.size(); ++k) {
    ConverterDevice& device = converters[k];
    if (at.us < device.next_us) continue;
    device.next_us = std::max(device.next_us + device.period_us, at.us);
    if (!device.open && device.back_off.due(at.us)) {
      device.open = device.converter->open();
      if (device.open) device.back_off.succeeded();
    }
    double value = 0;
    const bool ok = device.open && device.converter->read(value);
    if (ok) device.told = false;
    if (!ok && device.back_off.due(at.us)) {
      if (!std::exchange(device.told, true)) {
        log_.write(at.us, Priority::kWarning, device.converter->error(), Topic::kDevices);
      }
      device.open = false;
      device.back_off.failed(at.us);
    }
    readings_[reading_count_++] = {k, clock_.monotonic_us(), ok, value};
  }
}

void EventLoop::send(const Outputs& outputs) {
  auto& buses = gateway_->devices.buses;
  for (const OutFrame& out : outputs.frames) {
    BusDevice& device = buses[out.bus];
    if (device.up && device.queued < BusDevice::kQueue) {
      device.queue[device.queued++] = out.frame;
    }
  }
  for (BusDevice& device : buses) {
    std::size_t sent = 0;
    while (device.up && sent < device.queued &&
           device.bus->write(device.queue[sent]) == hal::CanStatus::kOk) {
      ++sent;
    }
    std::copy(device.queue.begin() + static_cast<std::ptrdiff_t>(sent),
              device.queue.begin() + static_cast<std::ptrdiff_t>(device.queued),
              device.queue.begin());
    device.queued -= sent;
  }
}

void EventLoop::drive(std::span<const bool> flags, const Now& at) {
  auto& lines = gateway_->devices.lines;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    LineDevice& device = lines[k];
    if (!device.line || (device.open && device.level == flags[k])) continue;
    device.level = flags[k];
    if (device.open) {
      device.open = device.line->set(device.level);
    } else if (device.back_off.due(at.us)) {
      device.open = device.line->open(device.level);
    } else {
      continue;
    }
    if (device.open) {
      device.back_off.succeeded();
      device.told = false;
    } else {
      device.back_off.failed(at.us);
      if (std::exchange(device.told, true)) continue;
      log_.write(at.us, Priority::kError, device.line->error(), Topic::kDevices);
    }
  }
}

void EventLoop::tell(const Outputs& outputs, const Now& at) {
  for (const Notice& notice : outputs.notices) {
    log_.write(at.us, priority_of(notice),
               text_of(notice, gateway_->configuration).c_str(), topic_of(notice));
  }
}

void EventLoop::write_textfile(const Now& at) {
  const auto& metrics = gateway_->configuration.metrics;
  if (!metrics || at.us < textfile_us_) return;
  textfile_us_ = at.us + std::llround(metrics->period_s * 1e6);
  write_metrics({gateway_->daemon.gateway(), gateway_->daemon.loops()},
                gateway_->configuration.group, textfile_);
  const bool good = replace_file(metrics->path.c_str(), textfile_, Readers::kEverybody);
  if (!good && !textfile_failed_) {
    log_.print(at.us, Priority::kError, "%s: cannot be written: %s; it stays as it was",
               metrics->path.c_str(), std::strerror(errno));
  }
  textfile_failed_ = !good;
  failures_.textfile += good ? 0 : 1;
}

}  // namespace firmware
