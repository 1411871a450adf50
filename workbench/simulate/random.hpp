// Random numbers that are the same for a seed on every platform.
//
// The C++ standard fixes the bits of std::mt19937_64 but not those of its
// distributions, so the transforms are written out here.
#pragma once

#include <cstdint>
#include <random>
#include <string_view>

namespace workbench {

/// A stream of random draws. Two streams of one seed and label are equal; two
/// labels give unrelated streams for the same seed.
class Random {
 public:
  Random(std::string_view label, std::uint64_t seed);

  /// Uniform in [0, 1), 53 bits.
  double uniform();
  /// Uniform in [low, high).
  double uniform(double low, double high);
  /// Uniform in the logarithm; 0 < low < high.
  double log_uniform(double low, double high);
  /// Integer in [low, high], both included.
  int integer(int low, int high);
  /// True with probability p.
  bool chance(double p);
  /// +1 or -1 with equal probability.
  double sign();
  /// Standard normal (Marsaglia's polar method).
  double normal();

 private:
  std::mt19937_64 engine_;
  double spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace workbench
