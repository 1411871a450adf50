// From the verdicts of overlapping windows to one alarm that does not chatter.
//
// Life: new → take, once for each evaluated window → raised, at any time.
//
// A window supports the alarm when its verdict is stiction and its larger stick band is
// at least `band_min_pct` of the span of u; while the alarm is raised, that limit is
// lower by `band_hysteresis_pct`. A window speaks against it when its verdict is
// no_stiction or backlash, when its band is too small, or when it is undecided and u does
// not oscillate: what the alarm complained about is gone. An undecided window of a loop
// that oscillates, and bad data, say nothing.
//
//   raise   after `on_delay_windows` supporting windows in a row, nothing in between
//   clear   after `off_delay_windows` windows against it, none that supports it in
//   between
//
// One thread; no heap, clock or exceptions. Memory: 16 bytes. Cost: constant.
#pragma once

#include <cstdint>

#include "ident/verdict/verdict.hpp"

namespace ident {

/// The longest delay, and the most windows that are counted, in windows.
inline constexpr int kLongestDelay = 1000;

/// Values outside the ranges are moved to the nearest bound.
struct AlarmSettings {
  int on_delay_windows = 2;   ///< windows, 1 … 1000, default 2
  int off_delay_windows = 6;  ///< windows, 1 … 1000, default 6
  float band_min_pct = 0.5f;  ///< smallest stick band, % of span, 0 … 100, default 0.5
  float band_hysteresis_pct = 20;  ///< % of band_min_pct, 0 … 100, default 20
};

/// What an alarm has counted so far: all that it remembers.
struct AlarmState {
  bool raised = false;
  int windows = 0;  ///< for it while it is down, against it while raised, 0 … 1000
};

/// What a window did to the alarm.
enum class AlarmChange : std::uint8_t { kNone, kRaised, kCleared };

class Alarm {
 public:
  explicit Alarm(const AlarmSettings& settings);

  /// Takes the next window. `band_pct`: its larger stick band, % of span; looked at only
  /// if the verdict is stiction. `oscillates`: u does, in this window.
  AlarmChange take(Verdict verdict, float band_pct, bool oscillates);

  [[nodiscard]] bool raised() const { return raised_; }
  /// Supporting windows in a row that raise it.
  [[nodiscard]] int on_delay() const { return on_delay_; }
  /// To go on after a restart, with these settings or others.
  [[nodiscard]] AlarmState state() const { return {raised_, windows_}; }
  void restore(const AlarmState& state);

 private:
  enum class Vote : std::uint8_t { kFor, kAgainst, kNone };

  [[nodiscard]] Vote vote(Verdict verdict, float band_pct, bool oscillates) const;

  float raise_pct_;
  float keep_pct_;
  std::int16_t on_delay_;
  std::int16_t off_delay_;
  std::int16_t windows_ = 0;  // for the alarm while it is down, against it while raised
  bool raised_ = false;
};

static_assert(sizeof(Alarm) <= 16, "two limits, two delays, a count and the state");

}  // namespace ident
