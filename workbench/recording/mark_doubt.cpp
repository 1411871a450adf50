#include "workbench/recording/mark_doubt.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

bool all_digits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, is_digit);
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

}  // namespace workbench
