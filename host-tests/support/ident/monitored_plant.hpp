// A small monitor in a loop whose valve sticks.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "ident/monitor.hpp"
#include "ident/valve/stick_slip_valve.hpp"
#include "support/ident/microseconds.hpp"
#include "support/ident/published_valves.hpp"

namespace test {

using SmallMonitor = ident::Monitor<float, ident::kSmallWindow>;
using Events = std::vector<ident::Event<float>>;

// A PI loop around a first-order process, sampled once a second: u oscillates with a
// period of some 110 samples while the valve sticks.
class StickingLoop {
 public:
  StickingLoop() : valve_(from_he<double>(6, 2), 50) {}

  void heal() { valve_ = ident::StickSlipValve<double>({}, 50); }
  ident::Sample<float> next(std::int64_t t_us) {
    const double y = y_ + 0.15 * noise();
    const double error = kSetpoint - y;
    integral_ += error / 12;
    const double u = integral_ + error / 2;
    y_ += (oldest_ - 50 - y_) / 8;
    oldest_ = old_;
    old_ = valve_.step(u);
    return {t_us, static_cast<float>(u), static_cast<float>(y),
            static_cast<float>(kSetpoint), true};
  }

 private:
  static constexpr double kSetpoint = 0.3;

  // Sum of four uniform numbers, unit variance.
  double noise() {
    double sum = 0;
    for (int k = 0; k < 4; ++k) {
      state_ = state_ * 6364136223846793005U + 1442695040888963407U;
      sum += static_cast<double>(state_ >> 33) / 2147483648.0 - 0.5;
    }
    return sum * std::sqrt(3.0);
  }

  ident::StickSlipValve<double> valve_;
  double integral_ = 50;
  double y_ = 0;
  double old_ = 0;
  double oldest_ = 0;
  std::uint64_t state_ = 1;
};

// A monitor that is fed by a loop, `budgets` in turn for its slices.
struct MonitoredPlant {
  explicit MonitoredPlant(const ident::MonitorSettings<float>& settings = {},
                          std::vector<int> slices = {100})
      : monitor(std::make_unique<SmallMonitor>(settings)), budgets(std::move(slices)) {}

  void run(int samples) {
    for (int k = 0; k < samples; ++k) {
      t_us += kSecond;
      monitor->push(loop.next(t_us));
      while (monitor->step(budgets[turn++ % budgets.size()])) {
      }
      drain();
    }
  }
  // Samples only, no evaluation.
  template <class Signal>
  void feed(int samples, Signal signal) {
    for (int k = 0; k < samples; ++k) {
      t_us += kSecond;
      const auto [u, y] = signal(count++);
      monitor->push({t_us, u, y});
      drain();
    }
  }
  void drain() {
    while (const auto event = monitor->poll()) {
      events.push_back(*event);
    }
  }
  [[nodiscard]] Events of(ident::EventKind kind) const {
    Events out;
    std::copy_if(events.begin(), events.end(), std::back_inserter(out),
                 [&](const ident::Event<float>& event) { return event.kind == kind; });
    return out;
  }
  [[nodiscard]] ident::MonitorReport<float> report() const { return monitor->report(); }

  std::unique_ptr<SmallMonitor> monitor;
  StickingLoop loop;
  std::vector<int> budgets;
  std::size_t turn = 0;
  std::int64_t t_us = 0;
  int count = 0;
  Events events;
};

}  // namespace test
