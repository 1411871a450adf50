// The daemon in the world: waits, reads the devices, steps, writes, reports, and loads
// the configuration anew on SIGHUP.
//
// After run() has told the service manager that it is ready, nothing allocates until the
// next SIGHUP. One thread, and one each that write the state file and the history.
// SIGTERM and SIGINT end it: the flag lines go to their fail-safe level and are given
// back.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "config/gateway.hpp"
#include "firmware/daemon.hpp"
#include "firmware/devices.hpp"
#include "firmware/history_keeper.hpp"
#include "firmware/log.hpp"
#include "firmware/loop_input.hpp"
#include "firmware/service_manager.hpp"
#include "firmware/state_keeper.hpp"
#include "firmware/write_budget.hpp"
#include "hal/clock.hpp"
#include "hal/descriptor.hpp"

namespace firmware {

/// A configuration with all that is made from it.
struct Gateway {
  Gateway(config::Gateway configuration, Random& random, const hal::Clock& clock);

  config::Gateway configuration;
  Daemon daemon;
  Devices devices;
};

class EventLoop {
 public:
  EventLoop(const hal::Clock& clock, Log& log);

  /// Runs the configuration until a signal ends it. Throws config::ConfigError when the
  /// file cannot be used, another exception when a device is not there or another process
  /// has the state file: what may be so for a while only.
  void run(const std::string& path);

 private:
  static constexpr std::size_t kMostFrames = 512;  // read in one turn
  static constexpr std::size_t kMostReadings = kRoles * wire::kMostLoops;

  [[nodiscard]] Now now() const;
  void turn();
  /// Until there is something to do; true: a signal has come.
  [[nodiscard]] bool wait(bool busy);
  void take_signals();
  void reload();
  /// Servers that do not answer, and recordings without their times.
  void tell_devices();
  void take_memory(Daemon& next);
  [[nodiscard]] std::unique_ptr<StateKeeper> take_state(const config::Gateway& gateway);
  /// Empty, or that another process has it.
  [[nodiscard]] std::string take_history();
  void read_buses(const Now& now);
  void sort_frames();
  void read_converters(const Now& now);
  void send(const Outputs& outputs);
  void drive(std::span<const bool> flags, const Now& now);
  void tell(const Outputs& outputs, const Now& now);
  void write_textfile(const Now& now);

  const hal::Clock& clock_;
  Log& log_;
  ServiceManager manager_;
  std::unique_ptr<Random> random_;
  std::unique_ptr<Gateway> gateway_;
  std::string path_;
  hal::Descriptor signals_;
  std::string textfile_;
  std::int64_t textfile_us_ = 0;  // when it is due
  std::int64_t watchdog_us_ = 0;  // the same
  std::int64_t step_us_ = 0;      // the same
  bool textfile_failed_ = false;
  FileFailures failures_;
  WriteBudget writes_{WriteBudget::kLeastAnHour};
  std::unique_ptr<StateKeeper> state_;      // nullptr: the configuration has none
  std::unique_ptr<HistoryKeeper> history_;  // the same
  bool ended_ = false;
  bool busy_ = false;      // there is identification to be done
  bool received_ = false;  // frames, in the turn before
  std::array<BusFrame, kMostFrames> frames_;
  std::size_t frame_count_ = 0;
  std::array<AnalogReading, kMostReadings> readings_;
  std::size_t reading_count_ = 0;
  std::vector<BusState> states_;
};

/// Bytes from the kernel.
[[nodiscard]] std::unique_ptr<Random> system_random();

/// What --check does: the configuration, its files and devices, one line for each fault
/// in the exception (config::ConfigError). `offline`: not the devices; folders that this
/// machine does not have are returned instead, one line each.
std::string check_gateway(const std::string& path, const hal::Clock& clock, bool offline);

}  // namespace firmware
