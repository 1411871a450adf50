// A valve that follows its signal.
#pragma once

#include "workbench/simulate/valve.hpp"

namespace workbench {

/// x(t) = u(t).
class LinearValve final : public Valve {
 public:
  void rest(double /*u*/) override {}
  double step(double u) override { return u; }
};

}  // namespace workbench
