// How a loop oscillates: how long, how much of the time, and a short stretch of it that
// can be compared with other loops.
#pragma once

#include <string>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace workbench {

/// Seconds since 1970 of Recording::start, zones taken off; false: it names no time.
[[nodiscard]] bool clock_seconds(const std::string& start, double& seconds);

/// The latest stretch of a loop that oscillates, as far as it is regular.
struct Rhythm {
  double period_s = 0;   ///< 0: u and y do not oscillate
  double start_s = 0;    ///< of the stretch: since 1970 where `clock` is empty
  double step_s = 0;     ///< from one value to the next
  std::string clock;     ///< whose time start_s is; "": the calendar's
  std::string zone;      ///< of the calendar, as Recording::zone
  std::vector<float> u;  ///< means over a step, at most kMostValues
  std::vector<float> y;

  /// Values a cycle (fewer where the recording has fewer), and in all.
  static constexpr double kValuesPerCycle = 32;
  static constexpr std::size_t kMostValues = 1024;
};

/// Whether their times may be compared.
[[nodiscard]] bool of_one_clock(const Rhythm& a, const Rhythm& b);

/// Of a long time, which share.
struct OscillatingTime {
  double all_s = 0;
  double oscillating_s = 0;
  [[nodiscard]] double share() const { return all_s > 0 ? oscillating_s / all_s : 0; }
};

/// What one recording shows.
struct RhythmOfRecording {
  Rhythm rhythm;
  OscillatingTime time;  ///< of u
  /// For each sample of u after thinning by `thinned`, whether it oscillates then.
  std::vector<bool> oscillates;
  std::size_t thinned = 1;
};

/// `clock`: whose time the recording's is where it names no date, as a rule its file.
/// O(n): the detector of ident/signal/oscillation_detector.hpp at three rates.
[[nodiscard]] RhythmOfRecording rhythm_of(const Recording& recording,
                                          const std::string& clock);

}  // namespace workbench
