// Random draws of the hidden-effect loops: the same for a seed on every platform.
#pragma once

#include <cstdint>
#include <string_view>

namespace hidden {

/// SplitMix64 (Steele, Lea & Flood 2014). Streams of different labels are unrelated.
class Random {
 public:
  Random(std::string_view label, std::uint64_t seed);

  /// Uniform in [0, 1), 53 bits.
  double uniform();
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in the logarithm; 0 < low < high.
  double log_uniform(double low, double high);
  bool chance(double probability) { return uniform() < probability; }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }
  /// Standard normal (Box and Muller).
  double normal();

 private:
  std::uint64_t next();

  std::uint64_t state_;
};

}  // namespace hidden
