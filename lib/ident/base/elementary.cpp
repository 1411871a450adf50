#include "ident/base/elementary.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

namespace ident::elementary {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
// The logarithm of 2 and a quarter turn in parts, the first ones short: their products
// with small integers are exact.
constexpr float kLog2 = 0.693359375F;
constexpr float kLog2Rest = -2.12194440e-4F;
constexpr float kQuarter = 1.5703125F;
constexpr float kQuarterRest = 4.837512969970703e-4F;
constexpr float kQuarterLast = 7.549789948768648e-8F;
constexpr float kPi = std::numbers::pi_v<float>;

/// Σ of terms[k]·x^k.
template <std::size_t Count>
float series(const std::array<float, Count>& terms, float x) {
  float sum = 0;
  for (std::size_t k = Count; k > 0; --k) {
    sum = sum * x + terms[k - 1];
  }
  return sum;
}

/// 2^power of a normal number.
float power_of_2(int power) {
  constexpr int kBias = 127;
  constexpr int kDigits = 23;
  return std::bit_cast<float>(static_cast<std::uint32_t>(power + kBias) << kDigits);
}

int nearest(float x) {
  return static_cast<int>(x < 0 ? x - 0.5F : x + 0.5F);
}

/// The sine, in turns of a quarter beyond x.
float sine(float x, int quarters) {
  const int turns = nearest(x / (kPi / 2));
  const float k = static_cast<float>(turns);
  const float rest = ((x - k * kQuarter) - k * kQuarterRest) - k * kQuarterLast;
  const float square = rest * rest;
  constexpr std::array kSine{-1 / 6.0F, 1 / 120.0F, -1 / 5040.0F, 1 / 362880.0F};
  constexpr std::array kCosine{-1 / 2.0F, 1 / 24.0F, -1 / 720.0F, 1 / 40320.0F,
                               -1 / 3628800.0F};
  const unsigned quadrant = static_cast<unsigned>(turns + quarters) % 4;
  const float value = quadrant % 2 == 0 ? rest + rest * square * series(kSine, square)
                                        : 1 + square * series(kCosine, square);
  return quadrant < 2 ? value : -value;
}

/// e^x for −87 < x < 88.7; `power`: nearest(x / log 2).
inline float bounded_exp(float x, int power) {
  const float k = static_cast<float>(power);
  const float rest = (x - k * kLog2) - k * kLog2Rest;
  // Written out, or a compiler would not take several at a time.
  float sum = rest * (1 / 5040.0F) + 1 / 720.0F;
  sum = sum * rest + 1 / 120.0F;
  sum = sum * rest + 1 / 24.0F;
  sum = sum * rest + 1 / 6.0F;
  sum = sum * rest + 1 / 2.0F;
  const float value = 1 + (rest + rest * rest * sum);
  // In two factors: the highest power has no number of its own.
  return value * power_of_2(power / 2) * power_of_2(power - power / 2);
}

}  // namespace

float exp(float x) {
  constexpr float kLargest = 88.7F;
  constexpr float kSmallest = -87;
  if (!(x > kSmallest)) {
    return x <= kSmallest ? 0 : x;
  }
  return x > kLargest ? kInfinity : bounded_exp(x, nearest(x / 0.69314718F));
}

void exp_of_negative(std::span<const float> x, std::span<float> out) {
  constexpr float kNothing = -16;
  const float* const from = x.data();
  float* const to = out.data();
  const std::size_t count = x.size();
  for (std::size_t i = 0; i < count; ++i) {
    const float bounded = from[i] > kNothing ? from[i] : kNothing;
    const int power = static_cast<int>(bounded / 0.69314718F - 0.5F);
    const float value = bounded_exp(bounded, power);
    to[i] = from[i] > kNothing ? value : 0;
  }
}

void exp_of_negative(std::span<const double> x, std::span<double> out) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    out[i] = x[i] > -16 ? std::exp(x[i]) : 0;
  }
}

float log(float x) {
  if (!(x > 0)) {
    return x == 0 ? -kInfinity : std::numeric_limits<float>::quiet_NaN();
  }
  if (x == kInfinity) {
    return x;
  }
  int power = 0;
  float share = std::frexp(x, &power);  // ½ … 1
  if (share < 0.70710678F) {
    share *= 2;
    --power;
  }
  // log((1 + s) / (1 − s)) = 2·(s + s³/3 + s⁵/5 + …)
  const float s = (share - 1) / (share + 1);
  const float square = s * s;
  constexpr std::array kTerms{2 / 3.0F, 2 / 5.0F, 2 / 7.0F, 2 / 9.0F};
  const float k = static_cast<float>(power);
  return k * kLog2 + (k * kLog2Rest + (2 * s + s * square * series(kTerms, square)));
}

float pow(float base, float exponent) {
  return exp(exponent * log(base));
}

float sin(float x) {
  return sine(x, 0);
}

float cos(float x) {
  return sine(x, 1);
}

float tan(float x) {
  return sin(x) / cos(x);
}

float atan2(float y, float x) {
  const float high = std::max(std::abs(x), std::abs(y));
  if (!(high > 0)) {
    return high;
  }
  const float low = std::min(std::abs(x), std::abs(y));
  // Beyond an eighth of a half turn: from there.
  const bool far = low > 0.41421356F * high;
  const float t = far ? (low - high) / (low + high) : low / high;
  const float square = t * t;
  constexpr std::array kTerms{-1 / 3.0F,  1 / 5.0F,  -1 / 7.0F, 1 / 9.0F,
                              -1 / 11.0F, 1 / 13.0F, -1 / 15.0F};
  float angle = (far ? kPi / 4 : 0) + (t + t * square * series(kTerms, square));
  angle = std::abs(y) > std::abs(x) ? kPi / 2 - angle : angle;
  angle = x < 0 ? kPi - angle : angle;
  return y < 0 ? -angle : angle;
}

float hypot(float x, float y) {
  return std::sqrt(x * x + y * y);
}

}  // namespace ident::elementary
