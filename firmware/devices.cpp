#include "firmware/devices.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hal/candump_file.hpp"
#include "hal/gpio_line.hpp"
#include "hal/modbus.hpp"
#include "hal/slcan.hpp"
#include "hal/socketcan.hpp"
#include "hal/sysfs_adc.hpp"

namespace firmware {
namespace {

constexpr int kReadingsPerSample = 4;

bool needs_fd(const config::Gateway& configuration, std::size_t bus) {
  for (const config::Loop& loop : configuration.loops) {
    for (const config::Source* source : sources_of(loop)) {
      if (source && source->kind == config::SourceKind::kCan && source->bus == bus &&
          wire::needs_fd(source->signal)) {
        return true;
      }
    }
  }
  return false;
}

std::unique_ptr<hal::CanBus> make_bus(const config::Gateway& configuration,
                                      std::size_t index,
                                      std::vector<hal::CanFilter> filters,
                                      const hal::Clock& clock) {
  const config::Bus& bus = configuration.buses[index];
  switch (bus.backend) {
    case config::Backend::kSocketCan:
      return std::make_unique<hal::SocketCan>(bus.interface, std::move(filters),
                                              needs_fd(configuration, index));
    case config::Backend::kSlcan:
      return std::make_unique<hal::SlcanServer>(bus.port, clock);
    case config::Backend::kFile:
      return std::make_unique<hal::CandumpFile>(
          bus.path, bus.interface,
          bus.real_time ? hal::ReplayPace::kRealTime : hal::ReplayPace::kFast, clock);
  }
  return nullptr;
}

// One link for all registers of a server.
class ModbusLinks {
 public:
  std::unique_ptr<hal::AnalogInput> input(const config::Modbus& source,
                                          std::int64_t period_us) {
    const hal::ModbusAddress address{source.host, source.port, source.device, source.baud,
                                     source.parity};
    auto link = std::ranges::find_if(
        links_, [&](const auto& known) { return known->address() == address; });
    if (link == links_.end()) {
      link = links_.insert(link, std::make_shared<hal::ModbusLink>(address));
    }
    const hal::ModbusRegister from{
        source.unit,
        source.input_table ? hal::ModbusTable::kInput : hal::ModbusTable::kHolding,
        source.address, static_cast<hal::ModbusType>(source.type), source.low_word_first};
    return std::make_unique<hal::ModbusInput>(*link, from, period_us);
  }

 private:
  std::vector<std::shared_ptr<hal::ModbusLink>> links_;
};

}  // namespace

void BackOff::failed(std::int64_t now_us) {
  constexpr std::int64_t kFirst_us = 100'000;
  constexpr std::int64_t kLongest_us = 5'000'000;
  wait_us_ = wait_us_ == 0 ? kFirst_us : std::min(2 * wait_us_, kLongest_us);
  next_us_ = now_us + wait_us_;
}

void BusDevice::reopen(std::int64_t now_us) {
  if (ended || !back_off.due(now_us)) return;
  up = bus->open();
  queued = 0;
  if (up) {
    back_off.succeeded();
  } else {
    back_off.failed(now_us);
  }
}

void BusDevice::lost(hal::CanStatus status, std::int64_t now_us) {
  up = false;
  ended = status == hal::CanStatus::kEnded;
  queued = 0;
  back_off.failed(now_us);
}

Devices::Devices(const config::Gateway& configuration, const Daemon& daemon,
                 const hal::Clock& clock)
    : buses(configuration.buses.size()),
      lines(configuration.loops.size()),
      converters(daemon.analog_points().size()),
      configuration_(configuration),
      daemon_(daemon) {
  for (std::size_t k = 0; k < buses.size(); ++k) {
    buses[k].bus = make_bus(configuration, k, daemon.filters(k), clock);
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (const auto& flag = configuration.loops[k].flag) {
      lines[k].line =
          std::make_unique<hal::GpioLine>(flag->chip, flag->line, flag->active_low);
      lines[k].level = flag->fail_safe;
    }
  }
  ModbusLinks modbus;
  for (std::size_t k = 0; k < converters.size(); ++k) {
    const AnalogPoint& point = daemon.analog_points()[k];
    const config::Loop& loop = configuration.loops[point.loop];
    const config::Source& source = *source_of(loop, point.role);
    converters[k].period_us =
        std::llround(loop.sample_period_s * 1e6 / kReadingsPerSample);
    const auto adc = [&](hal::AdcKind kind) {
      return std::make_unique<hal::SysfsAdc>(
          kind, configuration.sysfs_root, source.name, source.channel, source.index,
          hal::AdcFactors{source.scale, source.offset});
    };
    switch (source.kind) {
      case config::SourceKind::kCan:  // a bus, and no analog point
        break;
      case config::SourceKind::kIio:
        converters[k].converter = adc(hal::AdcKind::kIio);
        break;
      case config::SourceKind::kHwmon:
        converters[k].converter = adc(hal::AdcKind::kHwmon);
        break;
      case config::SourceKind::kModbus:
        converters[k].converter = modbus.input(source.modbus, converters[k].period_us);
        break;
    }
  }
}

// `is_old` is asked for each bus, flag line and source of a converter.
template <class IsOld>
std::string Devices::open(IsOld is_old) {
  std::string missing;
  unanswered.clear();
  const auto complaint = [&](const config::Place& place, const char* error) {
    return config::at_place(configuration_, place,
                            std::string("expected a device, found that ") + error);
  };
  for (std::size_t k = 0; k < buses.size(); ++k) {
    if (buses[k].up || is_old(configuration_.buses[k])) continue;
    buses[k].up = buses[k].bus->open();
    if (!buses[k].up) {
      missing += complaint(configuration_.buses[k].place, buses[k].bus->error()) + '\n';
    }
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    LineDevice& line = lines[k];
    if (!line.line || line.open || is_old(*configuration_.loops[k].flag)) continue;
    line.open = line.line->open(line.level);
    if (!line.open) {
      missing +=
          complaint(configuration_.loops[k].flag->place, line.line->error()) + '\n';
    }
  }
  const auto source_at = [this](std::size_t k) -> const config::Source& {
    const AnalogPoint& point = daemon_.analog_points()[k];
    return *source_of(configuration_.loops[point.loop], point.role);
  };
  // All servers are asked before the first is waited for.
  for (std::size_t k = 0; k < converters.size(); ++k) {
    if (!converters[k].open && !is_old(source_at(k))) converters[k].converter->start();
  }
  for (std::size_t k = 0; k < converters.size(); ++k) {
    const config::Source& source = source_at(k);
    if (converters[k].open || is_old(source)) continue;
    converters[k].open = converters[k].converter->open();
    if (converters[k].open) continue;
    std::string line = complaint(source.place, converters[k].converter->error());
    // A server may come back; what is built into the gateway does not.
    if (source.kind == config::SourceKind::kModbus) {
      unanswered.push_back(std::move(line));
    } else {
      missing += line + '\n';
    }
  }
  if (!missing.empty()) missing.pop_back();
  return missing;
}

std::string Devices::open_all() {
  return open([](const auto&) { return false; });
}

std::string Devices::open_new(const Devices& old) {
  struct IsOld {
    const config::Gateway& configuration;
    bool operator()(const config::Bus& bus) const {
      return std::ranges::any_of(configuration.buses, [&](const config::Bus& b) {
        return b.backend == bus.backend && b.port == bus.port &&
               b.interface == bus.interface && b.path == bus.path;
      });
    }
    bool operator()(const config::Flag& flag) const {
      return std::ranges::any_of(configuration.loops, [&](const config::Loop& l) {
        return l.flag && l.flag->chip == flag.chip && l.flag->line == flag.line;
      });
    }
    // Converters can be opened twice; one that is away now is no new fault.
    bool operator()(const config::Source& source) const {
      return std::ranges::any_of(configuration.loops, [&](const config::Loop& l) {
        return std::ranges::any_of(sources_of(l), [&](const config::Source* old) {
          return old && old->kind == source.kind && old->name == source.name &&
                 old->channel == source.channel && old->index == source.index;
        });
      });
    }
  };
  return open(IsOld{old.configuration_});
}

}  // namespace firmware
