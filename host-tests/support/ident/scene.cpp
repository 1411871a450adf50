#include "support/ident/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "support/ident/problems.hpp"

namespace test {

Scened play(const Scene& scene) {
  constexpr int kSettle = 1000;
  constexpr int kDeadTime = 5;
  Random random(1);
  const double pole = std::exp(-1 / scene.time_constant);
  ident::StickSlipValve<double> valve(scene.friction, 0);
  Scened out;
  std::vector<double> x;
  double process = 0, before = 0, u = 0;
  for (int t = 0; t < scene.samples + kSettle; ++t) {
    const double late = t >= kDeadTime ? x[static_cast<std::size_t>(t - kDeadTime)] : 0;
    process = pole * process + (1 - pole) * 1.25 * late;
    const double y = process + scene.load(t) + scene.noise * normal(random);
    const double error = scene.setpoint(t) - y;
    u += scene.proportional * (error - before) + scene.integral * error;
    u = std::clamp(u, scene.low, scene.high);
    before = error;
    x.push_back(valve.step(u));
    if (t >= kSettle) {
      out.u.push_back(u);
      out.y.push_back(y);
      out.sp.push_back(scene.setpoint(t));
    }
  }
  return out;
}

std::function<double(int)> steps(double size, int hold) {
  return [=](int t) { return 0.7 + (t / hold % 2 == 0 ? 0 : size); };
}

std::function<double(int)> wave(double size, double period) {
  return [=](int t) { return 0.7 + size * std::sin(2 * M_PI * t / period); };
}

}  // namespace test
