// What a verdict on the valve says of its strokes.
#include "ident/verdict/judge.hpp"

namespace ident {

template <class Real>
Reason strokes_that_stick(Reason reason, const PerStroke<Real>& band) {
  if (reason != Reason::kSticksBothStrokes && reason != Reason::kSticksAscending &&
      reason != Reason::kSticksDescending) {
    return reason;
  }
  const bool up = band.ascending.low > Real(0);
  const bool down = band.descending.low > Real(0);
  if (up && down) {
    return Reason::kSticksBothStrokes;
  }
  if (up && band.descending.high < band.ascending.low) {
    return Reason::kSticksAscending;
  }
  if (down && band.ascending.high < band.descending.low) {
    return Reason::kSticksDescending;
  }
  return Reason::kStrokesUnresolved;
}

template Reason strokes_that_stick<float>(Reason, const PerStroke<float>&);
template Reason strokes_that_stick<double>(Reason, const PerStroke<double>&);

}  // namespace ident
