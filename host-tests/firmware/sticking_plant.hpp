// A loop sampled once a second, for tests of the daemon.
#pragma once

#include <cmath>
#include <cstdint>

#include "ident/valve/stick_slip_valve.hpp"
#include "support/ident/published_valves.hpp"
#include "wire/can_frame.hpp"

namespace firmware {

// A first-order process behind a valve that sticks under a PI controller, or behind a
// linear one that u sways.
class Plant {
 public:
  explicit Plant(bool sticks)
      : sticks_(sticks),
        valve_(sticks ? test::from_he<double>(6, 2) : ident::ValveFriction<double>{},
               50) {}
  void next() {
    const double error = 50.3 - (y = y_ + 0.15 * noise());
    integral_ += error / 12;
    u = sticks_ ? integral_ + error / 2 : 50 + 10 * std::sin(0.06 * ++samples_);
    y_ += (oldest_ - y_) / 8;
    oldest_ = old_;
    old_ = valve_.step(u);
  }
  double u = 50;
  double y = 50;

 private:
  // Sum of four uniform numbers, unit variance.
  double noise() {
    double sum = 0;
    for (int k = 0; k < 4; ++k) {
      state_ = state_ * 6364136223846793005U + 1442695040888963407U;
      sum += static_cast<double>(state_ >> 33) / 2147483648.0 - 0.5;
    }
    return sum * std::sqrt(3.0);
  }

  bool sticks_;
  int samples_ = 0;
  ident::StickSlipValve<double> valve_;
  double integral_ = 50;
  double y_ = 50;
  double old_ = 50;
  double oldest_ = 50;
  std::uint64_t state_ = 1;
};

/// A frame that carries a value in hundredths of a percent, little-endian.
inline wire::CanFrame percent_frame(std::uint32_t id, double percent) {
  const auto raw = static_cast<std::uint16_t>(std::lround(percent * 100));
  wire::CanFrame frame{.id = id, .dlc = 2, .data = {}};
  frame.data[0] = static_cast<std::uint8_t>(raw);
  frame.data[1] = static_cast<std::uint8_t>(raw >> 8);
  return frame;
}

}  // namespace firmware
