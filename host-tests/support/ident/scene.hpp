// Loops that are told apart by one thing each: valve, load, setpoint, limits or tuning.
#pragma once

#include <functional>
#include <vector>

#include "ident/valve/stick_slip_valve.hpp"

namespace test {

/// A PI loop around a first-order process, anything in it to be replaced.
struct Scene {
  ident::ValveFriction<double> friction = {};
  double time_constant = 80;  // samples
  double proportional = 1.3;
  double integral = 0.065;  // per sample
  double low = -100;        // limits of u
  double high = 100;
  double noise = 0.02;
  std::function<double(int)> setpoint = [](int) { return 0.7; };
  std::function<double(int)> load = [](int) { return 0.0; };  // at y
  int samples = 1200;
};

/// What is recorded of it, after it has settled.
struct Scened {
  std::vector<double> u;
  std::vector<double> y;
  std::vector<double> sp;
};

[[nodiscard]] Scened play(const Scene& scene);

/// A setpoint that steps up and down by `size`, or a wave.
[[nodiscard]] std::function<double(int)> steps(double size, int hold);
[[nodiscard]] std::function<double(int)> wave(double size, double period);

}  // namespace test
