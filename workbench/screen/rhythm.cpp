#include "workbench/screen/rhythm.hpp"

#include <algorithm>
#include <optional>

#include "ident/signal/oscillation_detector.hpp"
#include "workbench/analysis/listening.hpp"
#include "workbench/recording/written_time.hpp"
#include "workbench/recording/written_zone.hpp"

namespace workbench {
namespace {

// The detector goes up after some four cycles: they oscillated, too.
constexpr double kCyclesUnseen = 4;
// It needs up to ten before it says that an oscillation goes on.
constexpr double kFewCycles = 25;

std::vector<bool> times_of(const std::vector<double>& signal, const Heard& heard) {
  const std::vector<double> thin = means(signal, heard.thinned);
  ident::OscillationDetector<double> detector;
  std::vector<bool> out(thin.size(), false);
  bool before = false;
  for (std::size_t i = 0; i < thin.size(); ++i) {
    (void)detector.push(thin[i]);
    const auto rhythm = detector.rhythm();
    out[i] = rhythm.oscillating;
    if (rhythm.oscillating && !before) {
      const double unseen = kCyclesUnseen * rhythm.period_samples;
      const std::size_t first = i - std::min(i, static_cast<std::size_t>(unseen));
      std::fill(out.begin() + static_cast<std::ptrdiff_t>(first),
                out.begin() + static_cast<std::ptrdiff_t>(i), true);
    }
    before = rhythm.oscillating;
  }
  // A short record that oscillates as a whole is one piece.
  const bool is_short = static_cast<double>(signal.size()) < kFewCycles * heard.period;
  if (is_short && detector.report().detected) out.assign(out.size(), true);
  return out;
}

// Means over steps of `step` samples, the last `count` steps.
std::vector<float> stretch_of(const std::vector<double>& values, double step,
                              std::size_t count) {
  std::vector<float> out(count);
  const double first =
      static_cast<double>(values.size()) - step * static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto from =
        static_cast<std::size_t>(std::max(0.0, first + step * static_cast<double>(k)));
    const auto to = std::min(
        values.size(),
        std::max(from + 1,
                 static_cast<std::size_t>(first + step * static_cast<double>(k + 1))));
    double sum = 0;
    for (std::size_t i = from; i < to; ++i) sum += values[i];
    out[k] = static_cast<float>(sum / static_cast<double>(to - from));
  }
  return out;
}

}  // namespace

bool clock_seconds(const std::string& start, double& seconds) {
  const std::optional<WrittenTime> time = written_time(start);
  if (!time || time->kind != WrittenTime::Day::kKnown || !time->has_clock) return false;
  seconds = time->since_1970_s();
  return true;
}

bool of_one_clock(const Rhythm& a, const Rhythm& b) {
  return a.clock == b.clock && (!a.clock.empty() || one_clock(a.zone, b.zone));
}

RhythmOfRecording rhythm_of(const Recording& recording, const std::string& clock) {
  RhythmOfRecording out;
  out.time.all_s = static_cast<double>(recording.size()) * recording.period_s;
  const Heard in_u = listen(recording.u);
  const Heard heard = in_u.period > 0 ? in_u : listen(recording.y);
  if (in_u.period > 0) {
    out.oscillates = times_of(recording.u, in_u);
    out.thinned = in_u.thinned;
    const auto on = std::ranges::count(out.oscillates, true);
    out.time.oscillating_s = out.time.all_s * static_cast<double>(on) /
                             static_cast<double>(out.oscillates.size());
  }
  if (!(heard.period > 0)) return out;
  Rhythm& rhythm = out.rhythm;
  rhythm.period_s = heard.period * recording.period_s;
  const double step = std::max(1.0, heard.period / Rhythm::kValuesPerCycle);
  const auto count =
      std::min(Rhythm::kMostValues,
               static_cast<std::size_t>(static_cast<double>(recording.size()) / step));
  rhythm.step_s = step * recording.period_s;
  rhythm.u = stretch_of(recording.u, step, count);
  rhythm.y = stretch_of(recording.y, step, count);
  rhythm.zone = recording.zone;
  double begin = 0;
  if (!clock_seconds(recording.start, begin)) {
    begin = recording.t.front();
    rhythm.clock = clock;
  }
  const double end = begin + static_cast<double>(recording.size()) * recording.period_s;
  rhythm.start_s = end - static_cast<double>(count) * rhythm.step_s;
  return out;
}

}  // namespace workbench
