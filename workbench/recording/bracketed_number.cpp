#include "workbench/recording/bracketed_number.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/recording/letters.hpp"
#include "workbench/recording/number_spelling.hpp"

namespace workbench {

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

}  // namespace workbench
