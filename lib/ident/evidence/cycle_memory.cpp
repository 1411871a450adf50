#include "ident/evidence/cycle_memory.hpp"

#include <algorithm>

#include "ident/base/elementary.hpp"

namespace ident {
namespace {

constexpr std::size_t kFewestCycles = 3;
// Shorter cycles are known from the near lags.
constexpr std::size_t kShortest = 8;
constexpr double kReach = 0.1;  // of the period, to either side

// Lags that are taken together beside those next to the cycle: the slopes of a load are
// known from means.
std::size_t width_of(std::size_t cycle) {
  constexpr std::size_t kShare = 15;
  return std::max<std::size_t>(cycle / kShare, 1);
}

}  // namespace

template <class Real>
void CycleMemory<Real>::start(const EvidenceWindow<Real>& window) {
  *this = {};
  if (!(window.period > Real(0))) {
    return;
  }
  passes_.start(window);
  passes_.thin();
  const Real cycle = window.period / static_cast<Real>(passes_.thinning());
  const auto at = [&](double share) {
    return static_cast<std::size_t>(cycle * static_cast<Real>(share));
  };
  lag_ = std::max(at(1 - kReach), kShortest);
  last_lag_ = std::min(at(1 + kReach) + 1, passes_.count() / kFewestCycles);
  done_ = lag_ > last_lag_ || cycle < Real(kShortest);
}

// How alike y is to itself one lag later; its mean is 0.
template <class Real>
int CycleMemory<Real>::weigh_lag() {
  const std::span<const Real> y = passes_.y();
  Real product = 0;
  for (std::size_t t = lag_; t < y.size(); ++t) {
    product += y[t] * y[t - lag_];
  }
  product /= static_cast<Real>(y.size() - lag_);
  if (cycle_ == 0 || product > most_alike_) {
    cycle_ = lag_;
    most_alike_ = product;
  }
  if (++lag_ > last_lag_) {
    begin_without();
  }
  return kUnit;
}

template <class Real>
void CycleMemory<Real>::begin_without() {
  const std::span<const LagBin> near = lag_bins_for(passes_.count(), kCoarseLagBins);
  bases_ = near.size();
  std::copy(near.begin(), near.end(), bins_.begin());
  first_ = std::max<std::size_t>(static_cast<std::size_t>(near.back().last),
                                 cycle_ + 1 + 3 * width_of(cycle_));
  done_ = !passes_.begin_at(first_, near);
}

template <class Real>
void CycleMemory<Real>::take_error() {
  const Real log_error = elementary::log(passes_.sums().error());
  if (remembers_) {
    nats_ = static_cast<Real>(passes_.rows()) / Real(2) * (log_without_ - log_error);
    done_ = true;
    return;
  }
  log_without_ = log_error;
  remembers_ = true;
  const int cycle = static_cast<int>(cycle_);
  const int wide = static_cast<int>(width_of(cycle_));
  bins_[bases_] = {cycle - 1 - 3 * wide, cycle - 2 - wide};
  bins_[bases_ + 1] = {cycle - 1 - wide, cycle - 2};
  bins_[bases_ + 5] = {cycle + 2, cycle + 1 + wide};
  bins_[bases_ + 6] = {cycle + 2 + wide, cycle + 1 + 3 * wide};
  for (int k = -1; k <= 1; ++k) {
    bins_[bases_ + static_cast<std::size_t>(3 + k)] = {cycle + k, cycle + k};
  }
  passes_.begin_at(first_,
                   std::span<const LagBin>(bins_).first(bases_ + 2 * kAround + 1));
}

template <class Real>
bool CycleMemory<Real>::step(int budget) {
  for (int left = budget * kUnit; left > 0 && !done_;) {
    left -= lag_ <= last_lag_
                ? weigh_lag()
                : passes_.piece([](Real u) { return u; }, [this] { take_error(); });
  }
  return done_;
}

template class CycleMemory<float>;
template class CycleMemory<double>;

}  // namespace ident
