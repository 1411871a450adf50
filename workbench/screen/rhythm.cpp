#include "workbench/screen/rhythm.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ident/signal/oscillation_detector.hpp"

namespace workbench {
namespace {

constexpr std::size_t kFewestSamples = 256;  // at a lower rate
// The detector goes up after some four cycles: they oscillated, too.
constexpr double kCyclesUnseen = 4;
// It needs up to ten before it says that an oscillation goes on.
constexpr double kFewCycles = 25;

std::vector<double> means(const std::vector<double>& values, std::size_t count) {
  std::vector<double> out(values.size() / count);
  for (std::size_t i = 0; i < out.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) sum += values[i * count + k];
    out[i] = sum / static_cast<double>(count);
  }
  return out;
}

struct Heard {
  double period = 0;  // samples of the recording; 0: none
  double amplitude = 0;
  std::size_t thinned = 1;
};

Heard listen(const std::vector<double>& signal) {
  Heard best;
  for (std::size_t factor = 1; factor == 1 || signal.size() / factor >= kFewestSamples;
       factor *= 16) {
    ident::OscillationDetector<double> detector;
    for (const double value : factor == 1 ? signal : means(signal, factor)) {
      (void)detector.push(value);
    }
    const auto report = detector.report();
    if (!report.detected || report.amplitude <= best.amplitude) continue;
    best = {report.period_samples * static_cast<double>(factor), report.amplitude,
            factor};
  }
  return best;
}

std::vector<bool> times_of(const std::vector<double>& signal, const Heard& heard) {
  const std::vector<double> thin = means(signal, heard.thinned);
  // A short record is one piece: as a whole it oscillates.
  const bool is_short = static_cast<double>(signal.size()) < kFewCycles * heard.period;
  std::vector<bool> out(thin.size(), is_short);
  if (is_short) return out;
  ident::OscillationDetector<double> detector;
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

std::int64_t days_from_civil(int year, int month, int day) {
  const int y = month <= 2 ? year - 1 : year;
  const int era = y / 400;
  const int of_era = y - era * 400;
  const int of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
  return std::int64_t{era} * 146097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year -
         719468;
}

}  // namespace

bool clock_seconds(const std::string& start, double& seconds) {
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, used = 0;
  double second = 0;
  if (std::sscanf(start.c_str(), "%d-%d-%dT%d:%d:%lf%n", &year, &month, &day, &hour,
                  &minute, &second, &used) < 6) {
    return false;
  }
  seconds = static_cast<double>(days_from_civil(year, month, day)) * 86400 + hour * 3600 +
            minute * 60 + second;
  int zone_hours = 0, zone_minutes = 0;
  char sign = 0;
  if (std::sscanf(start.c_str() + used, "%c%d:%d", &sign, &zone_hours, &zone_minutes) ==
      3) {
    const double zone = zone_hours * 3600 + zone_minutes * 60;
    if (sign == '+') seconds -= zone;
    if (sign == '-') seconds += zone;
  }
  return true;
}

RhythmOfRecording rhythm_of(const Recording& recording, const std::string& clock) {
  RhythmOfRecording out;
  out.time.all_s = static_cast<double>(recording.size()) * recording.period_s;
  const Heard in_u = listen(recording.u);
  const Heard heard = in_u.period > 0 ? in_u : listen(recording.y);
  if (in_u.period > 0) {
    out.oscillates = times_of(recording.u, in_u);
    out.thinned = in_u.thinned;
    const auto on = std::count(out.oscillates.begin(), out.oscillates.end(), true);
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
