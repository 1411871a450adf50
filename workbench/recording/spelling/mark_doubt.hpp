// What the numbers of a column leave open, told from all of them: marks that group or
// divide, brackets that negate or doubt, units that differ by a prefix.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// "-45.2" of "(45.2)"; nothing where no digit or mark follows the bracket. The number is
/// not looked at.
[[nodiscard]] std::optional<std::string> negative_of(std::string_view cell);

/// The numbers of one column, in order: brackets may also mark what is doubtful.
class BracketDoubt {
 public:
  /// `value`: negative where it is bracketed.
  void add(double value, bool bracketed);
  /// Cells in brackets.
  [[nodiscard]] std::size_t total() const { return total_; }
  /// From plain to bracketed numbers the column moves, in the mean, more than three times
  /// as far as it does anywhere else: through zero it would not.
  [[nodiscard]] bool likely_marks() const;

 private:
  std::size_t total_ = 0;
  bool any_ = false;
  bool last_bracketed_ = false;
  double last_ = 0;
  std::size_t changes_ = 0;  // from plain to bracketed or back
  double across_ = 0;        // moves there, in sum
  double within_ = 0;        // the largest move elsewhere
};

/// What a number in `unit` is multiplied by to be one in `base`: 1000 for kW and W, 0.001
/// for mbar and bar. Nothing where they differ by more than a prefix; with regard to
/// case.
[[nodiscard]] std::optional<double> unit_ratio(std::string_view unit,
                                               std::string_view base);

/// True for K or k, which stands for a thousand where other cells have no unit.
[[nodiscard]] bool says_thousand(std::string_view unit);

/// Cells of a column that were scaled.
class ScaledCells {
 public:
  /// A cell with another prefix, in `unit`.
  void add(std::string_view unit);
  /// A cell with a K behind its number, as written. False: none of thousands.
  [[nodiscard]] bool add_thousand(double written);
  /// The values leave no gap where the K begins: 995, then 1.005 K.
  [[nodiscard]] bool are_thousands(const std::vector<double>& values) const;
  [[nodiscard]] std::size_t thousands() const { return thousands_; }
  [[nodiscard]] std::size_t prefixed() const { return prefixed_; }
  /// The first with another prefix.
  [[nodiscard]] const std::string& unit() const { return unit_; }

 private:
  std::size_t thousands_ = 0;
  std::size_t prefixed_ = 0;
  std::string unit_;
};

}  // namespace workbench
