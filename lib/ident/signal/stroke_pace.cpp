#include "ident/signal/stroke_pace.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace ident {
namespace {

constexpr int kFewestStrokes = 8;
constexpr double kEven = 0.08;
constexpr double kTogether = 0.2;
// Over the root of the number of strokes: a correlation that chance seldom brings.
constexpr double kBeyondChance = 1.3;

}  // namespace

template <class Real>
StrokePace<Real, true> measure_pace(std::span<const Reversal<Real>> strokes) {
  struct Mean {
    Real time = 0;
    Real way = 0;
    Real count = 0;
  };
  std::array<Mean, 2> means;
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    Mean& mean = means[k % 2];
    mean.time += static_cast<Real>(strokes[k].index);
    mean.way += strokes[k].value;
    mean.count += Real(1);
  }
  Real times = 0;
  Real ways = 0;
  Real both = 0;
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    const Mean& mean = means[k % 2];
    const Real time =
        static_cast<Real>(strokes[k].index) * mean.count / mean.time - Real(1);
    const Real way = strokes[k].value * mean.count / mean.way - Real(1);
    times += time * time;
    ways += way * way;
    both += time * way;
  }
  StrokePace<Real, true> out;
  out.strokes = static_cast<int>(strokes.size());
  if (times > Real(0) && ways > Real(0)) {
    out.spread = std::sqrt(times / static_cast<Real>(strokes.size()));
    out.together = both / std::sqrt(times * ways);
  }
  return out;
}

template <class Real>
bool keeps_foreign_time(const StrokePace<Real>& pace) {
  if constexpr (kStrokePace) {
    if (pace.strokes < kFewestStrokes) {
      return false;
    }
    const Real chance = Real(kBeyondChance) / std::sqrt(static_cast<Real>(pace.strokes));
    return pace.spread < Real(kEven) && pace.together > Real(kTogether) &&
           pace.together > chance;
  }
  return false;
}

#define STICKBAND_INSTANTIATE(Real)                                                    \
  template StrokePace<Real, true> measure_pace<Real>(std::span<const Reversal<Real>>); \
  template bool keeps_foreign_time<Real>(const StrokePace<Real>&);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
