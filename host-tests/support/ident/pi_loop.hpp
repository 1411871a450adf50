// A small closed loop with every signal at hand, for the detectors of misleading records.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "support/ident/problems.hpp"

namespace test {

struct LoopRecord {
  std::vector<double> u, y;
};

/// What a loop under a wandering load consists of; times in samples.
struct PiLoop {
  double pole = 0.9;        ///< of the first-order process of gain 1
  double proportional = 1;  ///< of the controller
  double integral = 0.1;
  double load = 0.05;   ///< step of the wandering load, 1 sample
  double noise = 0.05;  ///< before the sensor
  std::function<double(double)> valve = [](double u) { return u; };
  std::function<double(double)> sensor = [](double y) { return y; };
};

/// Setpoint 0.3; the sensor reads, the controller answers in the same sample, the process
/// follows in the next.
inline LoopRecord run(const PiLoop& loop, std::size_t samples, std::uint64_t seed) {
  Random random(seed);
  LoopRecord out;
  double state = 0;
  double load = 0;
  double u = 0;
  double error = 0;
  for (std::size_t t = 0; t < samples; ++t) {
    const double y = loop.sensor(state + loop.noise * normal(random));
    const double now = 0.3 - y;
    u += loop.proportional * (now - error) + loop.integral * now;
    error = now;
    load = 0.99 * load + loop.load * normal(random);
    state = loop.pole * state + (1 - loop.pole) * (loop.valve(u) + load);
    out.u.push_back(u);
    out.y.push_back(y);
  }
  return out;
}

/// Stands still until its input is further away than `band`, then goes there.
inline std::function<double(double)> sticking(double band) {
  return [band, place = 0.0](double input) mutable {
    if (input - place > band || place - input > band) place = input;
    return place;
  };
}

}  // namespace test
