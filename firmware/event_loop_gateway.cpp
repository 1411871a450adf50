// What the event loop serves: a gateway made from its configuration.
#include <sys/random.h>

#include <utility>

#include "firmware/event_loop.hpp"
#include "firmware/target_files.hpp"

namespace firmware {
namespace {

class SystemRandom final : public Random {
 public:
  bool fill(std::span<std::uint8_t> out) override {
    return getrandom(out.data(), out.size(), GRND_NONBLOCK) ==
           static_cast<ssize_t>(out.size());
  }
};

}  // namespace

std::unique_ptr<Random> system_random() {
  return std::make_unique<SystemRandom>();
}

Gateway::Gateway(config::Gateway values, Random& random, const hal::Clock& clock)
    : configuration(std::move(values)),
      daemon(configuration, random, STICKBAND_VERSION),
      devices(configuration, daemon, clock) {}

void EventLoop::tell_devices() {
  for (const std::string& server : gateway_->devices.unanswered) {
    log_.write(now().us, Priority::kWarning, server.c_str(), Topic::kDevices);
  }
  for (const config::Bus& bus : gateway_->configuration.buses) {
    if (bus.backend != config::Backend::kFile || bus.real_time) continue;
    const std::string line = config::at_place(
        gateway_->configuration, bus.place,
        "expected a log in real time, found real_time = false: its times are lost, and "
        "what is said of its loops means nothing; judge a log with --replay");
    log_.write(now().us, Priority::kWarning, line.c_str(), Topic::kDevices);
  }
}

std::string check_gateway(const std::string& path, const hal::Clock& clock,
                          bool offline) {
  const std::unique_ptr<Random> random = system_random();
  Gateway gateway(config::read_gateway(path), *random, clock);
  const TargetFaults targets = check_targets(gateway.configuration);
  std::string faults = targets.wrong;
  const auto add = [&faults](const std::string& lines) {
    if (!lines.empty()) faults += (faults.empty() ? "" : "\n") + lines;
  };
  if (!offline) {
    add(targets.missing);
    add(gateway.devices.open_all());
    for (const std::string& server : gateway.devices.unanswered) add(server);
  }
  if (!faults.empty()) throw config::ConfigError(faults);
  return targets.missing;
}

}  // namespace firmware
