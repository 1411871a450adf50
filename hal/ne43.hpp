// What a 4–20 mA signal says about its own health: NAMUR NE 43.
//
//   I ≤ failure_low   or I ≥ failure_high     failure (sensor or wire)
//   I ≤ saturated_low or I ≥ saturated_high   saturated: the value is at its limit
//
// A failure is confirmed, and ends, once it has lasted, or been absent, for the debounce
// time. Until it is confirmed the current is settling; its value is used in neither. One
// thread; no heap. Cost: constant.
#pragma once

#include <cstdint>

namespace hal {

/// mA; low limits ascending, high limits descending towards the range 4 … 20.
struct Ne43Limits {
  double failure_low_ma = 3.6;
  double saturated_low_ma = 3.8;
  double saturated_high_ma = 20.5;
  double failure_high_ma = 21.0;
  std::int64_t debounce_us = 3'000'000;  ///< µs, ≥ 0, default 3 s
};

enum class CurrentState : std::uint8_t {
  kGood,
  kSaturated,
  kSettling,  ///< a failure that is not confirmed yet
  kFailureLow,
  kFailureHigh,
};

class Ne43 {
 public:
  explicit Ne43(const Ne43Limits& limits) : limits_(limits) {}

  /// Takes the current at a time that does not go back; a value that is not finite counts
  /// as 0 mA.
  CurrentState take(std::int64_t t_us, double current_ma);
  [[nodiscard]] CurrentState state() const { return state_; }

 private:
  enum class Failure : std::uint8_t { kNone, kLow, kHigh };

  Ne43Limits limits_;
  std::int64_t since_us_ = 0;  // of what is seen, once it differs from what is confirmed
  Failure confirmed_ = Failure::kNone;
  Failure seen_ = Failure::kNone;
  CurrentState state_ = CurrentState::kGood;
};

}  // namespace hal
