// Marks with three digits behind them: decimals or thousands, told from their column.
#pragma once

#include <cstddef>
#include <string_view>

namespace workbench {

/// How a number is written, as far as its marks say.
enum class NumberShape {
  kWhole,  ///< digits alone
  kThree,  ///< one mark, one to three digits before it, the first no zero, three behind
  kOther,  ///< anything else: it shows which mark is which
};
[[nodiscard]] NumberShape number_shape(std::string_view number);

/// The numbers of one column, in order.
class MarkDoubt {
 public:
  /// `value`: with the mark read as the decimal one.
  void add(std::string_view number, double value);
  /// Some number shows the decimal mark.
  [[nodiscard]] bool settled() const { return settled_; }
  /// Whole numbers beside marked ones, and the column moves less from one to the other if
  /// the marks are of thousands: 998, 1.002.
  [[nodiscard]] bool likely_thousands() const {
    return !settled_ && three_ > 0 && whole_ > 0 && as_thousands_ < as_decimals_;
  }
  /// All have a point with three digits behind it: where columns are apart by something
  /// else, a comma is the decimal mark unless a number shows otherwise.
  [[nodiscard]] bool open() const {
    return !settled_ && !comma_ && three_ > 0 && whole_ == 0;
  }

 private:
  std::size_t three_ = 0;
  std::size_t whole_ = 0;
  bool settled_ = false;
  bool comma_ = false;
  bool last_three_ = false;
  double last_ = 0;
  double as_thousands_ = 0;  // moves between whole and marked numbers, in sum
  double as_decimals_ = 0;
};

/// Numbers of one column that may be what a decimal comma left of another one, where
/// commas separate columns, too: 45,07 in two cells.
class FractionDoubt {
 public:
  void add(std::string_view number);
  /// Digits alone, without a sign, in all of them.
  [[nodiscard]] bool are_digits() const { return digits_ && width_ > 0; }
  /// Those, equally many of at least two, some with a zero in front.
  [[nodiscard]] bool are_likely() const { return are_digits() && even_ && padded_; }

 private:
  std::size_t width_ = 0;
  bool digits_ = true;
  bool even_ = true;
  bool padded_ = false;
};

}  // namespace workbench
