// The notify socket of the service manager (sd_notify), a few lines instead of a library.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace firmware {

class ServiceManager {
 public:
  /// Reads NOTIFY_SOCKET and WATCHDOG_USEC; without them every call does nothing.
  ServiceManager();

  /// Sends e.g. "READY=1". Does not allocate.
  void tell(std::string_view state) const;
  /// How often "WATCHDOG=1" is due, µs; 0: never.
  [[nodiscard]] std::int64_t watchdog_us() const { return watchdog_us_; }

 private:
  std::string socket_;
  std::int64_t watchdog_us_ = 0;
};

}  // namespace firmware
