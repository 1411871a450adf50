#include "wire/decimal.hpp"

#include <array>
#include <cmath>
#include <cstdint>

#include "wire/text.hpp"

namespace wire {
namespace {

constexpr std::array<double, 23> kPowersOfTen = {
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr int kLargestPower = 22;
constexpr int kEnough = 10'000;  // beyond any exponent of a double
constexpr std::uint64_t kMantissaFull = 1'000'000'000'000'000'000;  // 19 digits fit

}  // namespace

bool parse_decimal(std::string_view text, double& value) {
  std::size_t at = 0;
  const auto peek = [&] { return at < text.size() ? text[at] : '\0'; };
  const bool negative = peek() == '-';
  if (peek() == '-' || peek() == '+') ++at;

  std::uint64_t mantissa = 0;
  int exponent = 0;
  bool any = false;
  bool in_fraction = false;
  for (; is_digit(peek()) || (peek() == '.' && !in_fraction); ++at) {
    if (text[at] == '.') {
      in_fraction = true;
      continue;
    }
    any = true;
    if (mantissa < kMantissaFull) {
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(text[at] - '0');
      if (in_fraction && exponent > -kEnough) --exponent;
    } else if (!in_fraction && exponent < kEnough) {
      ++exponent;
    }
  }
  if (!any) return false;
  if (peek() == 'e' || peek() == 'E') {
    ++at;
    const bool down = peek() == '-';
    if (peek() == '-' || peek() == '+') ++at;
    if (!is_digit(peek())) return false;
    int written = 0;
    for (; is_digit(peek()); ++at) {
      if (written < kEnough) written = written * 10 + (text[at] - '0');
    }
    exponent += down ? -written : written;
  }
  if (at != text.size()) return false;

  auto result = static_cast<double>(mantissa);
  if (mantissa != 0) {
    while (exponent > 0 && std::isfinite(result)) {
      const int step = exponent < kLargestPower ? exponent : kLargestPower;
      result *= kPowersOfTen[static_cast<std::size_t>(step)];
      exponent -= step;
    }
    while (exponent < 0 && result != 0) {
      const int step = -exponent < kLargestPower ? -exponent : kLargestPower;
      result /= kPowersOfTen[static_cast<std::size_t>(step)];
      exponent += step;
    }
  }
  if (!std::isfinite(result)) return false;
  value = negative ? -result : result;
  return true;
}

}  // namespace wire
