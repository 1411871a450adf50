// What every valve model offers the loop.
#pragma once

namespace workbench {

/// A valve: signal u in, stem position x out, both in units of u, one sample at
/// a time.
class Valve {
 public:
  virtual ~Valve() = default;
  /// Puts stem and signal at rest at `u`; forgets the past.
  virtual void rest(double u) = 0;
  /// Takes the signal of this sample, returns the stem position it leads to.
  virtual double step(double u) = 0;
};

}  // namespace workbench
