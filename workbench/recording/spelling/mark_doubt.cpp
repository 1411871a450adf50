#include "workbench/recording/spelling/mark_doubt.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "workbench/recording/letters.hpp"
#include "workbench/recording/spelling/cell_number.hpp"

namespace workbench {
namespace {

bool all_digits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, is_digit);
}

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

NumberShape number_shape(std::string_view number) {
  if (!number.empty() && (number[0] == '-' || number[0] == '+')) number.remove_prefix(1);
  if (all_digits(number)) return NumberShape::kWhole;
  const std::size_t mark = number.find_first_of(".,");
  const bool three = mark >= 1 && mark <= 3 && number.size() == mark + 4 &&
                     number[0] != '0' && all_digits(number.substr(0, mark)) &&
                     all_digits(number.substr(mark + 1));
  return three ? NumberShape::kThree : NumberShape::kOther;
}

void MarkDoubt::add(std::string_view number, double value) {
  if (settled_) return;
  const NumberShape shape = number_shape(number);
  settled_ = shape == NumberShape::kOther;
  const bool three = shape == NumberShape::kThree;
  comma_ = comma_ || (three && number.find(',') != std::string_view::npos);
  if (three_ + whole_ > 0 && three != last_three_) {
    constexpr double kThousand = 1000;
    as_decimals_ += std::abs(value - last_);
    as_thousands_ +=
        std::abs(value * (three ? kThousand : 1) - last_ * (last_three_ ? kThousand : 1));
  }
  ++(three ? three_ : whole_);
  last_three_ = three;
  last_ = value;
}

void FractionDoubt::add(std::string_view number) {
  if (!digits_) return;
  digits_ = all_digits(number);
  if (width_ == 0) width_ = number.size();
  even_ = even_ && number.size() == width_;
  padded_ = padded_ || (number.size() > 1 && number[0] == '0');
}

std::optional<std::string> negative_of(std::string_view cell) {
  cell = without_blanks(cell);
  if (cell.size() < 3 || cell.front() != '(' || cell.back() != ')') return std::nullopt;
  const std::string_view inside = without_blanks(cell.substr(1, cell.size() - 2));
  if (inside.empty() || !(is_digit(inside[0]) || inside[0] == '.' || inside[0] == ',')) {
    return std::nullopt;
  }
  return '-' + std::string(inside);
}

void BracketDoubt::add(double value, bool bracketed) {
  const double move = any_ ? std::abs(value - last_) : 0;
  if (any_ && bracketed != last_bracketed_) {
    ++changes_;
    across_ += move;
  } else {
    within_ = std::max(within_, move);
  }
  total_ += bracketed;
  any_ = true;
  last_bracketed_ = bracketed;
  last_ = value;
}

bool BracketDoubt::likely_marks() const {
  constexpr double kFarther = 3;
  return changes_ > 0 && across_ > kFarther * within_ * static_cast<double>(changes_);
}

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
