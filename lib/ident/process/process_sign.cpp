#include "ident/process/process_sign.hpp"

#include <algorithm>

#include "ident/base/elementary.hpp"

namespace ident {

template <class Real>
void LikelierSign<Real>::start(std::span<const Real> u, std::span<const Real> y,
                               Real period, std::span<Real> scratch) {
  u_ = u;
  y_ = y;
  turned_ = scratch.first(y.size());
  period_ = period;
  next_ = 0;
  screening_ = false;
}

template <class Real>
bool LikelierSign<Real>::step() {
  // No pole, then time constants as shares of the period.
  constexpr std::array<Real, kProcesses - 1> kShares{Real(0.03), Real(0.1), Real(0.3),
                                                     Real(1), Real(3)};
  const int which = next_ / kProcesses;
  const int process = next_ % kProcesses;
  if (screening_) {
    if (!regression_.step()) {
      return false;
    }
    screening_ = false;
    const Real error = regression_.result().error;
    least_[which] = process == 0 ? error : std::min(least_[which], error);
    return ++next_ == 2 * kProcesses;
  }
  if (process == 0) {
    const Real sign = which == 0 ? Real(-1) : Real(1);
    std::transform(y_.begin(), y_.end(), turned_.begin(),
                   [sign](Real value) { return sign * value; });
  }
  ProcessPoles<Real> poles;
  if (process > 0) {
    poles.slow = elementary::exp(Real(-1) / (kShares[process - 1] * period_));
  }
  regression_.start_screen(u_, turned_, poles);
  screening_ = true;
  return false;
}

template class LikelierSign<float>;
template class LikelierSign<double>;

}  // namespace ident
