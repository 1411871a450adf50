// Time, so that tests can make it.
#pragma once

#include <cstdint>

namespace hal {

class Clock {
 public:
  virtual ~Clock() = default;
  /// µs from any origin; never goes back.
  [[nodiscard]] virtual std::int64_t monotonic_us() const = 0;
  /// µs since the Unix epoch; may be set at any time.
  [[nodiscard]] virtual std::int64_t realtime_us() const = 0;
};

/// The clocks of the system.
class SystemClock final : public Clock {
 public:
  [[nodiscard]] std::int64_t monotonic_us() const override;
  [[nodiscard]] std::int64_t realtime_us() const override;
};

/// A clock that stands until it is moved.
class FakeClock final : public Clock {
 public:
  [[nodiscard]] std::int64_t monotonic_us() const override { return now_us; }
  [[nodiscard]] std::int64_t realtime_us() const override { return now_us + epoch_us; }

  std::int64_t now_us = 0;
  std::int64_t epoch_us = 1'700'000'000'000'000;  ///< of now_us = 0
};

}  // namespace hal
