#include "support/workbench/setpoint_loop.hpp"

#include <cmath>
#include <memory>
#include <random>

namespace workbench::test {

Recording simulated(const SetpointLoop& loop) {
  std::mt19937_64 random(loop.seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-10, 10);
  Recording out;
  out.name = "loop.csv";
  out.period_s = 1;
  const double a = std::exp(-1 / loop.lag_s);
  std::vector<double> v;
  double z = 0;
  double integral = 0;
  double setpoint = 50;
  for (std::size_t k = 0; k < loop.samples; ++k) {
    if (loop.setpoint_moves && k % 100 == 10) setpoint = 50 + uniform(random);
    const double y =
        loop.sensor(50 + 2 * z + loop.load(k) + loop.noise_std * normal(random));
    const double error = setpoint - y;
    integral += error / 20;
    const double u = 50 + 0.6 * (error + integral);
    v.push_back(loop.valve(u) - 50);
    z = a * z + (1 - a) * v[k >= loop.delay ? k - loop.delay : 0];
    out.t.push_back(static_cast<double>(k));
    out.u.push_back(u);
    out.y.push_back(y);
    out.sp.push_back(setpoint);
    out.x.push_back(v.back() + 50);
  }
  return out;
}

Recording stepped(std::span<const double> levels,
                  const std::function<double(double u)>& valve) {
  constexpr int kHeld = 150;
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal(0, 0.1);
  Recording out;
  out.name = "steps.csv";
  out.period_s = 1;
  double z = 0;
  for (const double level : levels) {
    for (int k = 0; k < kHeld; ++k) {
      out.t.push_back(static_cast<double>(out.t.size()));
      out.u.push_back(level);
      out.y.push_back(50 + 2 * z + normal(random));
      z += (valve(level) - 50 - z) / 20;
    }
  }
  return out;
}

std::function<double(double)> backlash(double width) {
  const auto position = std::make_shared<double>(50);
  return [position, width](double u) {
    *position = std::min(std::max(*position, u - width / 2), u + width / 2);
    return *position;
  };
}

std::function<double(double)> slipping() {
  return [x = 50.0](double u) mutable {
    const double pull = u - x;
    if (std::abs(pull) > 3) x = u - std::copysign(1, pull);
    return x;
  };
}

}  // namespace workbench::test
