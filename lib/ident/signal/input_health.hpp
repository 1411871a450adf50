// Whether the samples that come in can be believed.
//
// Life: new → push, after each SampleWindow::push → fault, at any time. Where a clock is
// at hand, `advance` finds out that samples have stopped coming; without it the next
// sample does.
//
// Faults:
//   stale       no usable sample for longer than `stale_after_us`, or the clock of the
//               samples stands still: kStanding in a row with the time of the one before
//               (not in the least sizes)
//   non_finite  the same, and what came instead was not a finite number
//   frozen_u    u kept one value for `frozen_after_samples` and for three periods of the
//   frozen_y    oscillation, if there is one, while the other signal changed in at least
//               every eighth sample; y alike. A stuck valve holds y for part of a period
//               only
// A plant at rest, u and y both constant, is not a fault. A controller in manual, or at
// its limit, is frozen_u: no verdict on the valve is possible then.
//
// A fault ends after `restore_after_samples` usable samples in a row; a frozen signal
// must have changed in each that counts. One fault at a time: the first stays until it
// ends.
//
// One thread; no heap, clock or exceptions. Memory: 64 bytes (float), 80 (double). Cost
// of each call: constant.
#pragma once

#include <cstdint>
#include <string_view>

#include "ident/signal/sample_window.hpp"

namespace ident {

/// What is wrong with the samples.
enum class InputFault : std::uint8_t { kNone, kStale, kNonFinite, kFrozenU, kFrozenY };

/// "none", "stale", "non_finite", "frozen_u", "frozen_y".
[[nodiscard]] std::string_view name(InputFault fault);

/// Values outside the ranges are moved to the nearest bound.
struct InputHealthSettings {
  std::int64_t stale_after_us = 0;  ///< µs, 2 periods … 2⁶¹; 0, the default: 5 periods
  int frozen_after_samples = 512;  ///< samples, 8 … 2²⁰; 0: never; default 512
  int restore_after_samples = 5;   ///< samples, 1 … 1000, default 5
};

/// What a sample did to the health.
enum class HealthChange : std::uint8_t { kNone, kFault, kRestored };

template <class Real>
class InputHealth {
 public:
  static constexpr int kStanding = 32;

  InputHealth(const InputHealthSettings& settings, std::int64_t period_us);

  /// Takes a sample and what the window did with it. `period_samples`: of the
  /// oscillation, 0 if there is none.
  HealthChange push(const Sample<Real>& sample, PushResult result, Real period_samples);
  /// Takes the time, µs, on the clock of the samples.
  HealthChange advance(std::int64_t now_us);

  /// The fault that is present, or kNone.
  [[nodiscard]] InputFault fault() const { return fault_; }
  /// When the newest change happened, µs; a fault by staleness dates from the moment at
  /// which the sample was overdue. Meaningless before the first change.
  [[nodiscard]] std::int64_t changed_us() const { return changed_us_; }

 private:
  /// How long a signal has kept its value.
  struct Run {
    Real value = 0;
    std::int32_t length = 0;  // samples after the one that brought the value
    std::int32_t moves = 0;   // samples among them in which the other signal changed
  };

  [[nodiscard]] bool overdue(std::int64_t t_us) const;
  [[nodiscard]] static bool frozen(const Run& run, std::int32_t limit);
  HealthChange begin(InputFault fault, std::int64_t t_us);
  HealthChange take_usable(const Sample<Real>& sample, Real period_samples);

  std::int64_t stale_after_us_;
  std::int64_t usable_us_ = 0;  // newest usable sample, or the first that came
  std::int64_t changed_us_ = 0;
  std::int32_t frozen_after_;
  std::uint32_t stamp_ = 0;  // lower half of the newest time
  std::int16_t restore_after_;
  std::int16_t good_ = 0;  // usable samples in a row since the fault
  Run u_;
  Run y_;
  InputFault fault_ = InputFault::kNone;
  std::uint8_t standing_ = 0;  // samples in a row with the time of the one before
  bool seen_ = false;          // a sample has come
  bool usable_ = false;        // one of them was usable
};

static_assert(sizeof(InputHealth<float>) <= 64 && sizeof(InputHealth<double>) <= 80,
              "times and limits, one run for each signal, and the state");

}  // namespace ident
