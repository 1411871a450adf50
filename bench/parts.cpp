#include "bench/parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "ident/signal/reversals.hpp"

namespace bench {

// The window that the identifier hands to the valve search for this recording.
template <class Real>
ValvePart<Real>::ValvePart(const ScaledWindow<Real>& window) {
  std::array<ident::Reversal<Real>, 256> found;
  std::vector<unsigned char> ascending(window.u.size());
  const std::size_t count =
      ident::mark_directions<Real>(window.u, Real(0.3), ascending, found);
  if (count < 4 || count > found.size()) {
    throw std::runtime_error("expected a recording with 4 to 256 turning points of u");
  }
  const std::size_t period = (found[count - 1].index - found[0].index) * 2 / (count - 1);
  const std::size_t samples = window.y.size() / kDecimation;
  Real square = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    Real sum = 0;
    for (int k = 0; k < kDecimation; ++k) {
      sum += window.y[i * kDecimation + k];
    }
    means_.push_back(sum / Real(kDecimation));
    square += means_.back() * means_.back();
  }
  const Real scale = std::sqrt(square / static_cast<Real>(samples));
  for (Real& value : means_) {
    value /= scale;
  }
  std::vector<Real> swings;
  for (std::size_t k = 1; k < count; ++k) {
    swings.push_back(std::abs(found[k].value - found[k - 1].value));
  }
  std::nth_element(swings.begin(), swings.begin() + swings.size() / 2, swings.end());
  stem_.resize(samples);
  scratch_.resize(samples);
  window_.u = std::span<const Real>(window.u).first(samples * kDecimation);
  window_.y = means_;
  window_.decimation = kDecimation;
  window_.period = static_cast<Real>(period) / Real(kDecimation);
  window_.warm_up = period;
  window_.swing = swings[swings.size() / 2];
}

template <class Real>
void ValvePart<Real>::run() {
  constexpr int kLargeBudget = 1000;
  search_->start(window_, stem_, scratch_, *stems_);
  while (!search_->step(kLargeBudget)) {
  }
}

template <class Real>
RefinementPart<Real>::RefinementPart(const ScaledWindow<Real>& window,
                                     const ident::Structure& structure)
    : window_(window), scratch_(window.u.size()) {
  const auto evaluator = std::make_unique<StructureEvaluator<Real>>();
  evaluator->start(window);
  model_ = evaluator->evaluate(structure).model;
  // The paths at the structure's own knots.
  const ident::TwoPathModel<Real> fine = model_;
  const auto coarsen = [](const ident::Path<Real>& from, int segments) {
    ident::Path<Real> path;
    path.segments = segments;
    const int width = from.segments / segments;
    for (int k = 0; k <= segments; ++k) {
      path.knots[k] = from.knots[k * width];
      path.x[k] = from.x[k * width];
    }
    return path;
  };
  model_.ascending = coarsen(fine.ascending, structure.segments_ascending);
  model_.descending = coarsen(fine.descending, structure.segments_descending);
}

template <class Real>
Real RefinementPart<Real>::run() {
  ident::TwoPathModel<Real> model = model_;
  ident::InitialState<Real> initial{};
  fit_->start(window_.view(), {}, 1, model, initial, scratch_);
  while (!fit_->done()) {
    fit_->step();
  }
  return fit_->error();
}

template class ValvePart<float>;
template class ValvePart<double>;
template class RefinementPart<float>;
template class RefinementPart<double>;

}  // namespace bench
