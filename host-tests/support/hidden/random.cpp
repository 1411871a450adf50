#include "support/hidden/random.hpp"

#include <cmath>
#include <numbers>

namespace hidden {

Random::Random(std::string_view label, std::uint64_t seed)
    : state_(0xcbf29ce484222325u) {  // FNV-1a of the label, then the seed
  for (const char c : label) {
    state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  state_ ^= next() ^ (seed * 0xd1342543de82ef95u);
  next();
}

std::uint64_t Random::next() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double Random::uniform() {
  return static_cast<double>(next() >> 11) * 0x1p-53;
}

double Random::log_uniform(double low, double high) {
  return low * std::pow(high / low, uniform());
}

double Random::normal() {
  const double radius = std::sqrt(-2 * std::log(1 - uniform()));
  return radius * std::cos(2 * std::numbers::pi * uniform());
}

}  // namespace hidden
