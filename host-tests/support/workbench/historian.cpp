#include "support/workbench/historian.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "workbench/simulate/cycles.hpp"

namespace workbench::test {

std::string_view name(Historian historian) {
  constexpr std::array<std::string_view, kHistorians> kNames{
      "none", "boxcar", "swinging_door", "quantised", "every_second", "jitter"};
  return kNames[static_cast<std::size_t>(historian)];
}

std::vector<double> boxcar(const std::vector<double>& signal, double deviation,
                           std::size_t longest) {
  std::vector<double> out;
  std::size_t stored_at = 0;
  for (std::size_t t = 0; t < signal.size(); ++t) {
    const bool differs = std::abs(signal[t] - signal[stored_at]) > deviation;
    if (differs || t - stored_at >= longest) stored_at = t;
    out.push_back(signal[stored_at]);
  }
  return out;
}

std::vector<double> swinging_door(const std::vector<double>& signal, double deviation) {
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  std::vector<double> out(signal.size());
  std::size_t from = 0;
  double steepest = kOpen;
  double flattest = -kOpen;
  const auto draw_line = [&](std::size_t to) {
    const double slope = (signal[to] - signal[from]) / static_cast<double>(to - from);
    for (std::size_t t = from; t <= to; ++t) {
      out[t] = signal[from] + slope * static_cast<double>(t - from);
    }
    from = to;
  };
  for (std::size_t t = 1; t < signal.size(); ++t) {
    const auto slope = [&](double value) {
      return (value - signal[from]) / static_cast<double>(t - from);
    };
    const double here = slope(signal[t]);
    if (here > steepest || here < flattest) {
      draw_line(t - 1);
      steepest = kOpen;
      flattest = -kOpen;
    }
    steepest = std::min(steepest, slope(signal[t] + deviation));
    flattest = std::max(flattest, slope(signal[t] - deviation));
  }
  if (signal.size() == 1) out[0] = signal[0];
  if (from + 1 < signal.size()) draw_line(signal.size() - 1);
  return out;
}

std::vector<double> quantise(const std::vector<double>& signal, double step) {
  std::vector<double> out;
  for (const double value : signal) out.push_back(std::round(value / step) * step);
  return out;
}

std::vector<double> jitter(Random& random, const std::vector<double>& signal, double most,
                           bool held) {
  std::vector<double> out;
  for (std::size_t t = 0; t < signal.size(); ++t) {
    const double late = random.uniform(-most, most);
    const std::size_t other =
        late < 0 ? std::max<std::size_t>(t, 1) - 1 : std::min(t + 1, signal.size() - 1);
    const double share = held ? (late < 0 ? 1.0 : 0.0) : std::abs(late);
    out.push_back((1 - share) * signal[t] + share * signal[other]);
  }
  return out;
}

void every_second(SimulatedLoop& loop, bool means) {
  for (auto* signal : {&loop.u, &loop.y, &loop.sp, &loop.x, &loop.y_clean}) {
    for (std::size_t t = 0; t < signal->size() / 2; ++t) {
      const double first = (*signal)[2 * t];
      (*signal)[t] = means ? (first + (*signal)[2 * t + 1]) / 2 : first;
    }
    signal->resize(signal->size() / 2);
  }
  loop.t.resize(loop.u.size());
  for (double& time : loop.t) time *= 2;
  loop.period_s *= 2;
}

void record(Random& random, Historian historian, SimulatedLoop& loop) {
  switch (historian) {
    case Historian::kNone:
      break;
    case Historian::kBoxcar:
      for (auto* signal : {&loop.u, &loop.y}) {
        const double deviation = std_of(*signal) * random.log_uniform(0.02, 0.3);
        const int longest = random.integer(20, 200);
        *signal = boxcar(*signal, deviation, static_cast<std::size_t>(longest));
      }
      break;
    case Historian::kSwingingDoor:
      for (auto* signal : {&loop.u, &loop.y}) {
        *signal = swinging_door(*signal, std_of(*signal) * random.log_uniform(0.02, 0.3));
      }
      break;
    case Historian::kQuantised: {
      const int which = random.integer(0, 2);
      const double u_steps = random.log_uniform(8, 80);
      const double y_steps = random.log_uniform(8, 80);
      if (which != 0) loop.u = quantise(loop.u, swing_of(loop.u) / u_steps);
      if (which != 1) loop.y = quantise(loop.y, swing_of(loop.y) / y_steps);
      break;
    }
    case Historian::kEverySecond:
      every_second(loop, random.chance(0.5));
      break;
    case Historian::kJitter: {
      const double most = random.uniform(0.05, 0.5);
      loop.u = jitter(random, loop.u, most, true);
      loop.y = jitter(random, loop.y, most, false);
      break;
    }
  }
}

}  // namespace workbench::test
