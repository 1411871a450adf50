#include "ident/process/process_simulation.hpp"

#include <algorithm>

namespace ident {

template <class Real>
void ProcessSimulation<Real>::start(std::span<const Real> x,
                                    const ProcessPoles<Real>& poles,
                                    const ProcessFit<Real>& fit, std::span<Real> y) {
  const std::size_t n = y.size();
  x_ = x;
  y_ = y;
  fit_ = fit;
  filter_ = PoleFilter<Real>(poles, x);
  slow_start_ = StartColumn<Real>(poles.slow, n, fit.drifts);
  fast_start_ = StartColumn<Real>(start_pole(poles.fast), n, fit.drifts);
  lags_ = filter_.before();
  next_ = 0;
}

template <class Real>
bool ProcessSimulation<Real>::step(std::size_t samples) {
  const std::size_t n = y_.size();
  const std::size_t end = std::min(next_ + samples, n);
  const Real step = Real(2) / static_cast<Real>(n);
  PoleFilter<Real> filter = filter_;
  StartColumn<Real> slow_start = slow_start_;
  StartColumn<Real> fast_start = fast_start_;
  for (std::size_t t = next_; t < end; ++t) {
    for (int k = fit_.delay + 1; k > 0; --k) {
      lags_[k] = lags_[k - 1];
    }
    lags_[0] = filter.step(x_[t]);
    y_[t] = fit_.gain_a * lags_[fit_.delay] + fit_.gain_b * lags_[fit_.delay + 1] +
            fit_.offset + fit_.drift * (static_cast<Real>(t) * step - Real(1)) +
            fit_.start_slow * slow_start.next() + fit_.start_fast * fast_start.next();
  }
  filter_ = filter;
  slow_start_ = slow_start;
  fast_start_ = fast_start;
  next_ = end;
  return next_ == n;
}

template class ProcessSimulation<float>;
template class ProcessSimulation<double>;

}  // namespace ident
