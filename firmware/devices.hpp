// The hardware of a configuration: buses, flag lines, converters, each reopened with
// back-off when it goes away.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "config/gateway.hpp"
#include "firmware/daemon.hpp"
#include "hal/analog_input.hpp"
#include "hal/can_bus.hpp"
#include "hal/clock.hpp"
#include "hal/digital_output.hpp"

namespace firmware {

/// When to try again: 0.1 s after the first failure, twice as long after each, up to 5 s.
class BackOff {
 public:
  [[nodiscard]] bool due(std::int64_t now_us) const { return now_us >= next_us_; }
  void failed(std::int64_t now_us);
  void succeeded() { wait_us_ = 0; }

 private:
  std::int64_t next_us_ = 0;
  std::int64_t wait_us_ = 0;
};

struct BusDevice {
  static constexpr std::size_t kQueue = 2 * Daemon::kMostFrames;

  /// Opens the bus where it is time to; what waited for room is void.
  void reopen(std::int64_t now_us);
  /// Takes the bus as it is after a status other than kOk and kWait.
  void lost(hal::CanStatus status, std::int64_t now_us);

  std::unique_ptr<hal::CanBus> bus;
  BackOff back_off;
  bool up = false;
  bool ended = false;  ///< a recording is over: it is not opened again
  std::array<wire::CanFrame, kQueue> queue;  // waits for room on the bus
  std::size_t queued = 0;
};
struct LineDevice {
  std::unique_ptr<hal::DigitalOutput> line;  ///< nullptr: the loop has no flag
  BackOff back_off;
  bool open = false;
  bool told = false;  ///< that it is away
  bool level = false;
};
struct ConverterDevice {
  std::unique_ptr<hal::AnalogInput> converter;
  BackOff back_off;
  bool open = false;
  bool told = false;  ///< that it is away
  std::int64_t period_us = 0;
  std::int64_t next_us = 0;
};

class Devices {
 public:
  /// `daemon` is made from `configuration`; both and `clock` outlive this object.
  Devices(const config::Gateway& configuration, const Daemon& daemon,
          const hal::Clock& clock);

  /// Opens everything once that is not open; one line for each device that is not there,
  /// empty: all are. Servers that do not answer are in `unanswered`: they are asked again
  /// as long as the gateway runs.
  [[nodiscard]] std::string open_all();
  /// The same, but leaves out what `old` has: it cannot be taken twice.
  [[nodiscard]] std::string open_new(const Devices& old);

  std::vector<BusDevice> buses;             ///< as Gateway::buses
  std::vector<LineDevice> lines;            ///< as Gateway::loops
  std::vector<ConverterDevice> converters;  ///< as Daemon::analog_points()
  std::vector<std::string> unanswered;      ///< one line for each, when opened last

 private:
  template <class IsOld>
  std::string open(IsOld is_old);

  const config::Gateway& configuration_;
  const Daemon& daemon_;
};

}  // namespace firmware
