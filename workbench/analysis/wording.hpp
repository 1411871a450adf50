// What people read about an identification: plain words and rounded numbers.
#pragma once

#include <string>
#include <string_view>

#include "workbench/analysis/analysis.hpp"

namespace workbench {

/// The verdict as one short sentence, "The valve sticks." Of a valve that does not, it
/// says no more than was seen. `detectable_band`: 0: none.
[[nodiscard]] std::string_view headline(ident::Verdict verdict, ident::Reason reason,
                                        double detectable_band);

/// What to do next; empty where the reason itself says what data would tell. `slips`:
/// whether a slip jump was told from none; play looks the same without.
[[nodiscard]] std::string_view advice(ident::Reason reason, ident::Cause cause,
                                      double detectable_band, bool slips);

/// Both for what was found, in any precision: Identification or MonitorReport, which has
/// no cause.
template <class Found>
[[nodiscard]] std::string_view headline_of(const Found& found) {
  return headline(found.verdict, found.reason,
                  static_cast<double>(found.detectable_band));
}
template <class Found>
[[nodiscard]] std::string_view advice_of(const Found& found) {
  const auto& jump = found.slip_jump;
  return advice(found.reason, found.cause, static_cast<double>(found.detectable_band),
                jump.ascending.low > 0 || jump.descending.low > 0);
}

/// `value` with `decimals` places, from 1e15 on with four digits; zero has no sign; "–"
/// unless finite.
[[nodiscard]] std::string fixed(double value, int decimals);

/// Places after the point that show `resolution` with two digits, 0 … 9.
[[nodiscard]] int decimals_for(double resolution);

/// An estimate rounded to what its interval supports.
struct EstimateText {
  std::string value;     ///< "5.02", or "unknown"
  std::string interval;  ///< "4.83 to 5.21", empty when unknown
};
[[nodiscard]] EstimateText text_of(const ident::Estimate<double>& estimate);

/// A duration in the unit that suits it: "29.2 s", "2.3 min", "1.4 h".
[[nodiscard]] std::string duration(double seconds);

/// Distance from the smallest to the largest value.
[[nodiscard]] double span_of(const std::vector<double>& values);

}  // namespace workbench
