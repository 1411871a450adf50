// Numbers in brackets, as bookkeepers write negative ones.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace workbench {

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

}  // namespace workbench
