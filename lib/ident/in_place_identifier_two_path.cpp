// The part of an identification that the paper's two-path search brings; not in a device
// that leaves it out.
#include <algorithm>
#include <cmath>

#include "ident/base/elementary.hpp"
#include "ident/in_place_identifier.hpp"
#include "ident/two_path/path_simulation.hpp"

namespace ident {

// The two-path model in the units of the recording; beside it the linear one, which the
// search has just found.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_two_path() {
  const StructureCandidate<Real>& linear = structure().best();
  const Real samples = static_cast<Real>(size_);
  const auto fit = [&](const auto& c) {
    return c.known ? Real(100) * (Real(1) - std::sqrt(c.error / samples)) : Real(0);
  };
  result_.fit_percent = fit(two_path_);
  result_.fit_linear_percent = fit(linear);
  // Equation (8) in the units of y: the scale adds the same to both.
  const Real scale_part = samples * Real(2) * elementary::log(y_scale());
  if (linear.known) {
    result_.aic_linear = linear.aic + scale_part;
  }
  if (!two_path_.known) {
    return;
  }
  result_.aic = two_path_.aic + scale_part;

  TwoPathModel<Real>& model = result_.model;
  model = two_path_.model;
  const Real sign = static_cast<Real>(result_.gain_sign);
  Real a_sum = 1;
  for (int i = 0; i < model.process.na; ++i) {
    a_sum += model.process.a[i];
  }
  for (int j = 0; j < model.process.nb; ++j) {
    model.process.b[j] *= sign;
  }
  model.process.d = scale_of_y_.factor * model.process.d + scale_of_y_.offset * a_sum;
  for (Path<Real>* path : {&model.ascending, &model.descending}) {
    for (int k = 0; k <= path->segments; ++k) {
      path->knots[k] = scale_of_u_.back(path->knots[k]);
      path->x[k] *= y_scale();
    }
  }
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::simulate_two_path(std::span<Real> y) const {
  const WindowView<Real> view = window();
  if (!two_path_.known) {
    std::fill(y.begin(), y.end(), scale_of_y_.resting(y_));
    return;
  }
  simulate_paths<Real>(view, {}, two_path_.model, two_path_.initial, y.first(size_));
  for (Real& value : y.first(size_)) {
    value = scale_of_y_.back(value);
  }
}

#define STICKBAND_INSTANTIATE(Real, Capacity)                                         \
  template void InPlaceIdentifier<Real, Capacity>::take_two_path();                   \
  template void InPlaceIdentifier<Real, Capacity>::simulate_two_path(std::span<Real>) \
      const;
STICKBAND_INSTANTIATE(float, kSmallWindow)
STICKBAND_INSTANTIATE(float, kStandardWindow)
STICKBAND_INSTANTIATE(float, kLargeWindow)
STICKBAND_INSTANTIATE(double, kSmallWindow)
STICKBAND_INSTANTIATE(double, kStandardWindow)
STICKBAND_INSTANTIATE(double, kLargeWindow)

}  // namespace ident
