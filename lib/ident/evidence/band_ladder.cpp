#include "ident/evidence/band_ladder.hpp"

#include "ident/base/elementary.hpp"

namespace ident {

template <class Real>
Real rung_band(int rung, Real span) {
  return span * Real(kLowestRung) *
         elementary::pow(Real(kRungRatio), static_cast<Real>(rung));
}

template <class Real>
ValveFriction<Real> rung_valve(int rung, int slip, Real span) {
  const Real band = rung_band(rung, span);
  const Real jump = band * Real(kSlipShares[static_cast<std::size_t>(slip)]);
  return {band - jump, jump, jump, SlipMotion::kSlides};
}

template float rung_band<float>(int, float);
template double rung_band<double>(int, double);
template ValveFriction<float> rung_valve<float>(int, int, float);
template ValveFriction<double> rung_valve<double>(int, int, double);

}  // namespace ident
