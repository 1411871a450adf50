#include "ident/evidence/cycle_memory.hpp"

#include <algorithm>

#include "ident/base/elementary.hpp"

namespace ident {
namespace {

constexpr std::size_t kRows = 16;
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
  window_ = window;
  stage_ = window.period > Real(0) ? Stage::kThin : Stage::kDone;
}

template <class Real>
void CycleMemory<Real>::thin() {
  const std::size_t thinning = evidence_thinning(window_);
  const std::size_t count = window_.u.size() / thinning;
  u_ = thin_out(window_.u, thinning, window_.scratch.first(count));
  y_ = thin_out(window_.y, thinning, window_.scratch.last(count));
  const Real cycle = window_.period / static_cast<Real>(thinning);
  const auto at = [&](double share) {
    return static_cast<std::size_t>(cycle * static_cast<Real>(share));
  };
  lag_ = std::max(at(1 - kReach), kShortest);
  last_lag_ = std::min(at(1 + kReach) + 1, count / kFewestCycles);
  stage_ = lag_ > last_lag_ || cycle < Real(kShortest) ? Stage::kDone : Stage::kLag;
}

// How alike y is to itself one lag later; its mean is 0.
template <class Real>
void CycleMemory<Real>::weigh_lag() {
  Real product = 0;
  for (std::size_t t = lag_; t < y_.size(); ++t) {
    product += y_[t] * y_[t - lag_];
  }
  product /= static_cast<Real>(y_.size() - lag_);
  if (cycle_ == 0 || product > most_alike_) {
    cycle_ = lag_;
    most_alike_ = product;
  }
  if (++lag_ <= last_lag_) {
    return;
  }
  const std::span<const LagBin> near = lag_bins_for(y_.size(), kCoarseLagBins);
  bases_ = near.size();
  std::copy(near.begin(), near.end(), bins_.begin());
  first_ = std::max<std::size_t>(static_cast<std::size_t>(near.back().last),
                                 cycle_ + 1 + 3 * width_of(cycle_));
  begin_sums();
  if (y_.size() < first_ + kFewestRows) {
    stage_ = Stage::kDone;
  }
}

template <class Real>
void CycleMemory<Real>::begin_sums() {
  sums().start(std::span<const LagBin>(bins_).first(remembers_ ? bases_ + 2 * kAround + 1
                                                               : bases_));
  next_ = first_;
  stage_ = Stage::kOutput;
}

template <class Real>
void CycleMemory<Real>::take_error() {
  const Real log_error = elementary::log(sums().error());
  if (remembers_) {
    nats_ = static_cast<Real>(y_.size() - first_) / Real(2) * (log_without_ - log_error);
    stage_ = Stage::kDone;
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
  begin_sums();
}

template <class Real>
int CycleMemory<Real>::piece() {
  switch (stage_) {
    case Stage::kThin:
      thin();
      break;
    case Stage::kLag:
      weigh_lag();
      break;
    case Stage::kOutput:
    case Stage::kInput: {
      const bool output = stage_ == Stage::kOutput;
      const std::size_t end = std::min(next_ + kRows, y_.size());
      sums().add(y_, output ? std::span<const Real>() : u_, next_, end);
      next_ = end;
      if (next_ == y_.size() && !output) {
        take_error();
      } else if (next_ == y_.size()) {
        sums().begin_input();
        next_ = first_;
        stage_ = Stage::kInput;
      }
      break;
    }
    case Stage::kDone:
      break;
  }
  return kUnit;
}

template <class Real>
bool CycleMemory<Real>::step(int budget) {
  for (int left = budget * kUnit; left > 0 && stage_ != Stage::kDone;) {
    left -= piece();
  }
  return stage_ == Stage::kDone;
}

template class CycleMemory<float>;
template class CycleMemory<double>;

}  // namespace ident
