// Units that differ by a prefix alone: what monitoring pages write for large numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace workbench {

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
