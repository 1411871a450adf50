// The part of the search for a gap that looks at the residual.
#include <algorithm>
#include <cmath>

#include "ident/gap/model_gap.hpp"

namespace ident {
namespace {

// A smaller residual is not worth a word; the standard deviation of y is 1.
constexpr double kLeastResidual = 0.01;

}  // namespace

// The residual in physical coordinates (G1).
template <class Real>
void ModelGap<Real>::look() {
  using Views = GapViews<Real>;
  const std::size_t n = window_.y.size();
  const std::size_t end = end_of_piece();
  Look& at = *std::get_if<Look>(&work_);
  Views& views = report_.views;
  Sums sums = sums_;
  for (std::size_t t = next_; t < end; ++t) {
    const Real x = window_.stem[t];
    if (t > 0 && window_.ascending[t] != window_.ascending[t - 1]) {
      at.turned_at = x;
      at.upper_turn = window_.ascending[t] ? at.upper_turn : t;
    }
    const Real e = window_.y[t] - window_.simulated[t];
    const Real square = e * e;
    sums.energy += square;
    sums.beside += e * sums.before;
    sums.before = e;
    views.ascending += window_.ascending[t] ? square : Real(0);
    const Real travel = std::abs(x - at.turned_at) / window_.swing;
    views.travel[travel > Real(1)      ? 3
                 : travel > Real(0.5)  ? 2
                 : travel > Real(0.25) ? 1
                                       : 0] += square;
    const Real level = at.range > Real(0) ? (x - at.stem_low) / at.range : Real(0);
    views.level[std::min(static_cast<int>(level * Real(4)), 3)] += square;
    const Real phase = static_cast<Real>(t - at.upper_turn) / window_.period;
    views.phase[static_cast<int>(phase * Real(Views::kPhases)) % Views::kPhases] +=
        square;
    views.time[t * Views::kQuarters / n] += square;
  }
  sums_ = sums;
  next_ = end;
}

template <class Real>
void ModelGap<Real>::take_look() {
  GapViews<Real>& views = report_.views;
  const Real energy = sums_.energy;
  report_.residual = std::sqrt(energy / static_cast<Real>(window_.y.size()));
  if (!(energy > Real(0))) {
    views = {};
    stage_ = Stage::kDone;
    return;
  }
  views.ascending /= energy;
  views.lag = sums_.beside / energy;
  for (auto* group : {&views.travel, &views.level, &views.time}) {
    for (Real& share : *group) {
      share /= energy;
    }
  }
  for (Real& share : views.phase) {
    share /= energy;
  }
  stage_ = Stage::kDone;
  if (report_.residual > Real(kLeastResidual)) {
    stage_ = Stage::kLines;
    begin_lines();
  }
}

template void ModelGap<float>::look();
template void ModelGap<double>::look();
template void ModelGap<float>::take_look();
template void ModelGap<double>::take_look();

}  // namespace ident
