#include "workbench/effects/two_pieces.hpp"

#include <algorithm>

namespace workbench {

TwoPieces::TwoPieces(double from, double to, double at, double dead, double ratio)
    : from_(from), span_(to - from) {
  const double span = span_ > 0 ? span_ : 1;
  below_ = std::clamp((at - dead / 2 - from) / span, 0.0, 1.0);
  above_ = std::clamp((at + dead / 2 - from) / span, below_, 1.0);
  const double way = below_ + ratio * (1 - above_);
  slope_below_ = way > 0 ? 1 / way : 0;
  slope_above_ = ratio * slope_below_;
}

double TwoPieces::share(double at) const {
  const double inside = at > 0 ? std::min(at, 1.0) : 0;  // NaN: 0
  return slope_below_ * std::min(inside, below_) +
         slope_above_ * std::max(inside - above_, 0.0);
}

void TwoPieces::bend(std::span<double> signal) const {
  if (!(span_ > 0)) return;
  for (double& value : signal) value = from_ + span_ * share((value - from_) / span_);
}

}  // namespace workbench
