#include "workbench/recording/unit_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

constexpr double kThousand = 1000;
constexpr std::string_view kBases = "W|Pa|bar|V|A|N|g/h";
constexpr std::array<std::pair<char, double>, 4> kPrefixes = {
    {{'m', 1e-3}, {'h', 1e2}, {'k', 1e3}, {'M', 1e6}}};

// The base of a unit and its prefix as a number.
std::optional<std::pair<std::string_view, double>> taken_apart(std::string_view unit) {
  if (is_one_of(unit, kBases)) return std::pair(unit, 1.0);
  for (const auto& [letter, factor] : kPrefixes) {
    if (unit.starts_with(letter) && is_one_of(unit.substr(1), kBases)) {
      return std::pair(unit.substr(1), factor);
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> unit_ratio(std::string_view unit, std::string_view base) {
  const auto from = taken_apart(unit);
  const auto to = taken_apart(base);
  if (!from || !to || from->first != to->first) return std::nullopt;
  return from->second / to->second;
}

bool says_thousand(std::string_view unit) {
  return unit == "K" || unit == "k";
}

void ScaledCells::add(std::string_view unit) {
  if (prefixed_++ == 0) unit_ = unit;
}

bool ScaledCells::add_thousand(double written) {
  constexpr double kRounded = 0.995;  // 999.6 is 1.00 K
  ++thousands_;
  return std::abs(written) >= kRounded && std::abs(written) < kThousand;
}

bool ScaledCells::are_thousands(const std::vector<double>& values) const {
  constexpr double kMostGap = 0.5;  // of the range of the magnitudes
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
  double below = 0;
  double above = low;
  for (const double value : values) {
    const double size = std::abs(value);
    if (std::isnan(size)) continue;
    low = std::min(low, size);
    high = std::max(high, size);
    (size < kThousand ? below : above) =
        size < kThousand ? std::max(below, size) : std::min(above, size);
  }
  return above - below <= kMostGap * (high - low);
}

}  // namespace workbench
