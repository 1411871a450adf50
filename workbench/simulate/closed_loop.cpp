#include "workbench/simulate/closed_loop.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/simulate/he_valve.hpp"

namespace workbench {
namespace {

double at(const std::vector<double>& signal, std::size_t t) {
  return signal.empty() ? 0.0 : signal[std::min(t, signal.size() - 1)];
}

double quantise(double value, double resolution) {
  return resolution > 0 ? std::round(value / resolution) * resolution : value;
}

}  // namespace

Trajectory run_loop(const LoopSetup& setup, Valve& valve) {
  Process clean(setup.process, setup.period_s);
  Process loaded(setup.process, setup.period_s);
  Process positioner({1, setup.positioner_lag_s, 0, 0, false}, setup.period_s);
  PiController controller(setup.controller, setup.period_s, setup.rest_u);
  HeValve sensor(setup.sensor);
  valve.rest(setup.rest_u);

  Trajectory out;
  for (auto* signal : {&out.u, &out.y, &out.sp, &out.x, &out.y_clean}) {
    signal->reserve(setup.samples);
  }
  for (std::size_t t = 0; t < setup.warm_up + setup.samples; ++t) {
    const double y = quantise(
        sensor.step(loaded.output() + at(setup.output_load, t)) + at(setup.noise, t),
        setup.y_resolution);
    const double sp = at(setup.setpoint, t);
    const double u = quantise(controller.step(sp, y), setup.u_resolution);
    double signal = u;
    if (setup.positioner_lag_s > 0) {
      positioner.advance(u - setup.rest_u);
      signal = setup.rest_u + positioner.output();
    }
    const double x = valve.step(signal);
    if (t >= setup.warm_up) {
      out.u.push_back(u);
      out.y.push_back(y);
      out.sp.push_back(sp);
      out.x.push_back(x);
      out.y_clean.push_back(clean.output());
    }
    const double input = x - setup.rest_u + setup.input_bias;
    clean.advance(input);
    loaded.advance(input + at(setup.input_load, t));
  }
  return out;
}

}  // namespace workbench
