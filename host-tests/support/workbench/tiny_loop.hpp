// Two samples of a simulated loop, for tests of how loops are written.
#pragma once

#include "workbench/simulate/scenarios.hpp"

namespace workbench::test {

[[nodiscard]] inline SimulatedLoop tiny_loop() {
  SimulatedLoop loop;
  loop.period_s = 0.5;
  loop.t = {0, 0.5};
  loop.u = {1, -2.5};
  loop.y = {0.1, 1e-7};
  loop.sp = {3, 3};
  loop.x = {0, 1.0 / 3};
  loop.y_clean = {0, 0};
  return loop;
}

}  // namespace workbench::test
