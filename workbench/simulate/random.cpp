#include "workbench/simulate/random.hpp"

#include <cmath>

namespace workbench {
namespace {

// FNV-1a of the label, then one splitmix64 step so that neighbouring seeds
// start far apart.
std::uint64_t mix(std::string_view label, std::uint64_t seed) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : label) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  std::uint64_t z = hash + seed * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace

Random::Random(std::string_view label, std::uint64_t seed) : engine_(mix(label, seed)) {}

double Random::uniform() {
  return static_cast<double>(engine_() >> 11) * 0x1.0p-53;
}

double Random::uniform(double low, double high) {
  return low + (high - low) * uniform();
}

double Random::log_uniform(double low, double high) {
  return std::exp(uniform(std::log(low), std::log(high)));
}

int Random::integer(int low, int high) {
  const double width = static_cast<double>(high) - low + 1;
  return low + static_cast<int>(width * uniform());
}

bool Random::chance(double p) {
  return uniform() < p;
}

double Random::sign() {
  return chance(0.5) ? 1.0 : -1.0;
}

double Random::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  for (;;) {
    const double a = uniform(-1, 1);
    const double b = uniform(-1, 1);
    const double r = a * a + b * b;
    if (r >= 1 || r == 0) continue;
    const double scale = std::sqrt(-2 * std::log(r) / r);
    spare_ = b * scale;
    has_spare_ = true;
    return a * scale;
  }
}

}  // namespace workbench
