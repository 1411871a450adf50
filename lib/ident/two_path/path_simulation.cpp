#include "ident/two_path/path_simulation.hpp"

namespace ident {

template <class Real>
Real PathFollower<Real>::along(const Path<Real>& path, Real u, int& segment) {
  const auto& knots = path.knots;
  while (segment > 0 && u < knots[segment]) {
    --segment;
  }
  while (segment < path.segments && !(u < knots[segment + 1])) {
    ++segment;
  }
  if (u <= knots[0]) {
    return path.x[0];
  }
  if (segment == path.segments) {
    return path.x[segment];
  }
  const Real low = path.x[segment];
  return low + (path.x[segment + 1] - low) * (u - knots[segment]) /
                   (knots[segment + 1] - knots[segment]);
}

template <class Real>
Real PathFollower<Real>::at(const WindowView<Real>& window, std::span<const Real> x,
                            const TwoPathModel<Real>& model, std::ptrdiff_t t) {
  if (!x.empty()) {
    return x[t];
  }
  return window.ascending[t] ? along(model.ascending, window.u[t], ascending_)
                             : along(model.descending, window.u[t], descending_);
}

template <class Real>
void PathSimulation<Real>::start(const WindowView<Real>& window, std::span<const Real> x,
                                 const TwoPathModel<Real>& model,
                                 const InitialState<Real>& initial,
                                 std::span<Real> simulated) {
  window_ = window;
  x_ = x;
  model_ = &model;
  initial_ = &initial;
  simulated_ = simulated;
  follower_ = {};
  past_.fill(follower_.at(window_, x_, *model_, 0));
  next_ = 0;
  error_ = 0;
}

template <class Real>
bool PathSimulation<Real>::step(int samples) {
  const Process<Real>& process = model_->process;
  const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(window_.y.size());
  std::ptrdiff_t t = next_;
  for (; samples > 0 && t < n; --samples, ++t) {
    Real sum = process.d;
    for (int j = 0; j < process.nb; ++j) {
      sum += process.b[j] * past_[process.nk + j];
    }
    for (int i = 0; i < process.na && i < t; ++i) {
      sum -= process.a[i] * simulated_[t - 1 - i];
    }
    if (t < process.na) {
      sum += (*initial_)[t];
    }
    simulated_[t] = sum;
    const Real e = window_.y[t] - sum;
    error_ += e * e;
    past_.push(follower_.at(window_, x_, *model_, t));
  }
  next_ = t;
  return next_ == n;
}

template <class Real>
Real simulate_paths(const WindowView<Real>& window, std::span<const Real> x,
                    const TwoPathModel<Real>& model, const InitialState<Real>& initial,
                    std::span<Real> simulated) {
  PathSimulation<Real> simulation;
  simulation.start(window, x, model, initial, simulated);
  simulation.step(static_cast<int>(window.y.size()));
  return simulation.error();
}

#define STICKBAND_INSTANTIATE(Real)                                                  \
  template class PathFollower<Real>;                                                 \
  template class PathSimulation<Real>;                                               \
  template Real simulate_paths<Real>(const WindowView<Real>&, std::span<const Real>, \
                                     const TwoPathModel<Real>&,                      \
                                     const InitialState<Real>&, std::span<Real>);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
