#include "support/hidden/loop.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hidden {
namespace {

class Controller {
 public:
  Controller(const ControllerSettings& settings, double period_s, double rest_u)
      : settings_(settings),
        period_(period_s),
        rest_(rest_u),
        integral_(rest_u),
        u_(rest_u) {}

  double step(double error) {
    switch (settings_.kind) {
      case ControllerKind::kPi:
        return pi(error);
      case ControllerKind::kOnOff:
        turn(error);
        return bound(rest_ + settings_.centre_offset + direction_ * settings_.swing);
      case ControllerKind::kFloating:
        turn(error);
        return u_ = bound(u_ + direction_ * settings_.ramp_rate * period_);
    }
    return rest_;
  }

 private:
  [[nodiscard]] double bound(double u) const {
    return std::clamp(u, settings_.low, settings_.high);
  }

  // Positional, the integral frozen while u is at the limit it pushes against.
  double pi(double error) {
    const double proportional = settings_.gain * error;
    const double increment = proportional * period_ / settings_.reset_s;
    const double free = integral_ + increment + proportional;
    const double u = bound(free);
    if (u == free || (free - u) * increment < 0) {
      integral_ += increment;
    }
    return u;
  }

  void turn(double error) {
    if (std::abs(error) > settings_.hysteresis || direction_ == 0) {
      direction_ = error * settings_.gain > 0 ? 1 : -1;
    }
  }

  ControllerSettings settings_;
  double period_;
  double rest_;
  double integral_;
  double u_;
  int direction_ = 0;
};

double load_at(const Loads& loads, double t, double duration) {
  const double sinusoid =
      loads.sinusoid *
      std::sin(2 * std::numbers::pi * t / loads.sinusoid_period_s + loads.sinusoid_phase);
  const double step = t >= loads.step_at_s ? loads.step : 0;
  const double share = (t - loads.ramp_from_s) / (duration - loads.ramp_from_s);
  return sinusoid + step + loads.ramp * std::max(0.0, share);
}

// Swinging-door compression (Bristol 1990) from sample `from` on: a line goes on while a
// door of twice the tolerance, hinged at its start, lets every sample through.
void compress(double tolerance, std::size_t from, std::vector<double>& y) {
  const std::vector<double> raw = y;
  std::size_t start = from;
  while (start + 1 < raw.size()) {
    double steepest = kUnlimited;
    double flattest = -kUnlimited;
    std::size_t end = start + 1;
    for (; end < raw.size(); ++end) {
      const auto run = static_cast<double>(end - start);
      const double slope = (raw[end] - raw[start]) / run;
      if (slope > steepest || slope < flattest) break;
      steepest = std::min(steepest, slope + tolerance / run);
      flattest = std::max(flattest, slope - tolerance / run);
    }
    --end;
    for (std::size_t k = start + 1; k < end; ++k) {
      const double share =
          static_cast<double>(k - start) / static_cast<double>(end - start);
      y[k] = raw[start] + share * (raw[end] - raw[start]);
    }
    start = end;
  }
}

// What a sensor or a historian with a deadband makes of a value.
double held(double value, double band, double before) {
  return std::abs(value - before) > band ? value : before;
}

double quantise(double value, double quantum) {
  return quantum > 0 ? std::round(value / quantum) * quantum : value;
}

}  // namespace

Trace run_loop(const LoopSetup& setup, const std::vector<double>* imposed_u) {
  const double dt = setup.period_s / setup.sub_steps;
  const double duration = setup.period_s * static_cast<double>(setup.samples);
  const std::size_t n = setup.warm_up + setup.samples;
  HiddenValve valve(setup.valve, setup.rest_u);
  HiddenProcess process(setup.process, dt);
  Controller controller(setup.controller, setup.period_s, setup.rest_u);

  Trace trace;
  ValveEvents before;
  int overflows_before = 0;
  bool held_back = false;
  bool was_cut_off = false;
  for (std::size_t k = 0; k < n; ++k) {
    if (k == setup.warm_up) {
      before = valve.events();
      overflows_before = process.overflows();
    }
    const double sensed = setup.rest_y + process.sensed();
    const double noise = setup.noise.empty() ? 0 : setup.noise_std * setup.noise[k];
    const double spike = setup.spikes.empty() ? 0 : setup.spikes[k];
    const double reading =
        trace.y.empty() ? sensed + noise
                        : held(sensed + noise, setup.sticking_band, trace.y.back());
    const double whole = reading + spike;
    const double inside = std::clamp(whole, setup.reading_low, setup.reading_high);
    const double y = quantise(inside, setup.quantum);
    const bool cut_off = inside != whole;
    trace.cut_off += k >= setup.warm_up && cut_off && !was_cut_off ? 1 : 0;
    was_cut_off = cut_off;
    const double sp = setup.rest_y + setup.setpoint[k];
    const double u = imposed_u != nullptr ? (*imposed_u)[k] : controller.step(sp - y);
    trace.u.push_back(u);
    trace.y.push_back(y);
    trace.sensed.push_back(sensed);
    trace.sp.push_back(sp);
    const double start =
        setup.period_s * (static_cast<double>(k) - static_cast<double>(setup.warm_up));
    for (int i = 0; i < setup.sub_steps; ++i) {
      const double middle = start + dt * (i + 0.5);
      const double drift =
          1 + setup.process.gain_drift * (std::clamp(middle / duration, 0.0, 1.0) - 0.5);
      process.advance(valve.advance(u, dt) - setup.rest_u,
                      load_at(setup.loads, middle, duration), drift);
    }
    trace.stem.push_back(valve.stem());
    trace.rate_limited += k >= setup.warm_up && valve.held_back() && !held_back ? 1 : 0;
    held_back = valve.held_back();
  }
  if (setup.compression > 0 && setup.holds_stored) {
    for (std::size_t k = setup.warm_up + 1; k < n; ++k) {
      trace.y[k] = held(trace.y[k], setup.compression, trace.y[k - 1]);
    }
  } else if (setup.compression > 0) {
    compress(setup.compression, setup.warm_up, trace.y);
  }
  trace.valve = valve.events();
  trace.valve.turns -= before.turns;
  trace.valve.limit_hits -= before.limit_hits;
  trace.overflows = process.overflows() - overflows_before;
  trace.ran_dry = process.ran_dry();
  return trace;
}

std::vector<double> recorded(const LoopSetup& setup, const std::vector<double>& signal) {
  return {signal.begin() + static_cast<std::ptrdiff_t>(setup.warm_up), signal.end()};
}

}  // namespace hidden
