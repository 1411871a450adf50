#include "ident/evidence/stem_passes.hpp"

#include <numeric>
#include <utility>

#include "ident/base/elementary.hpp"
#include "ident/signal/leap.hpp"

namespace ident {
namespace {

// A piece.
constexpr std::size_t kRowsOfInput = 16;
constexpr std::size_t kRowsOfPlant = 32;

// Samples of the window that make one of those that are predicted: fewer where u leaps
// within them, which predictions by means cannot follow. The small sizes hardly thin.
template <class Real>
std::size_t thinning_of(const EvidenceWindow<Real>& window) {
  constexpr std::size_t kFewestPredicted = 500;
  const Real most = std::min(window.period / Real(kEvidencePerCycle),
                             static_cast<Real>(window.u.size()) / Real(kFewestPredicted));
  const std::size_t thinning = most > Real(1) ? static_cast<std::size_t>(most) : 1;
  return kSmallSizes ? thinning : thinning_for(window.u, thinning);
}

}  // namespace

template <class Real, std::size_t kRowsOfOutput>
void StemPasses<Real, kRowsOfOutput>::start(const EvidenceWindow<Real>& window) {
  window_ = window;
  thinning_ = thinning_of(window);
  count_ = first_ = window.u.size() / thinning_;
  y_ = {};
  stage_ = Stage::kOver;
}

template <class Real, std::size_t kRowsOfOutput>
void StemPasses<Real, kRowsOfOutput>::thin() {
  y_ = thin_out(window_.y, thinning_, window_.scratch.last(count_));
}

template <class Real, std::size_t kRowsOfOutput>
bool StemPasses<Real, kRowsOfOutput>::begin_at(std::size_t first,
                                               std::span<const LagBin> bins,
                                               PassOf of_u) {
  first = std::max(first, static_cast<std::size_t>(bins.back().last));
  if (count_ < first + kFewestRows) {
    return false;
  }
  sums().start(bins);
  first_ = next_ = first;
  of_ = of_u;
  follows_ = true;
  stage_ = y_.empty() ? Stage::kThin : Stage::kOutput;
  return true;
}

template <class Real, std::size_t kRowsOfOutput>
void StemPasses<Real, kRowsOfOutput>::begin_rows() {
  next_ = first_;
  stage_ = plants() ? Stage::kPlant : Stage::kInput;
  if (plants()) {
    sums().begin_planted();
  } else if (kStemSearch && of_ == PassOf::kStemAndSquare) {
    const Real sum = std::accumulate(stem().begin(), stem().end(), Real(0));
    sums().begin_bent_input(sum / static_cast<Real>(count_));
  } else {
    const bool newest = kStemSearch && of_ == PassOf::kStemAndNewest;
    const bool beside = newest || (kStemSearch && of_ == PassOf::kStemAndU);
    sums().begin_input({beside ? window_.u : std::span<const Real>(), thinning_},
                       newest ? kNewestBeside : kLagBins.size());
  }
}

template <class Real, std::size_t kRowsOfOutput>
int StemPasses<Real, kRowsOfOutput>::sum_some() {
  if (stage_ == Stage::kThin) {
    thin();
    stage_ = Stage::kOutput;
    return kUnit / 2;
  }
  if (!kSmallSizes && stage_ == Stage::kParts) {
    return sum_part();
  }
  const Stage stage = stage_;
  const std::size_t rows = stage == Stage::kOutput  ? kRowsOfOutput
                           : stage == Stage::kInput ? kRowsOfInput
                                                    : kRowsOfPlant;
  const std::size_t first = std::exchange(next_, std::min(next_ + rows, count_));
  const bool over = next_ == count_;
  if (over) {
    stage_ = Stage::kOver;
  }
  if (stage == Stage::kPlant) {
    sums().add_planted(y_, {window_.u, thinning_}, stem(), first, next_);
    return kUnit;
  }
  sums().add(y_, stage == Stage::kOutput ? std::span<const Real>() : stem(), first,
             next_);
  if (stage == Stage::kInput) {
    return kUnit / 2;
  }
  if (over) {
    begin_stem();
  }
  return kUnit;
}

template <class Real, std::size_t kRowsOfOutput>
Real StemPasses<Real, kRowsOfOutput>::nats() {
  const Real error = sums().error();
  const Real log_error = elementary::log(error);
  if (follows_) {
    error_of_u_ = error;
    log_of_u_ = log_error;
  }
  return static_cast<Real>(rows()) / Real(2) * (log_of_u_ - log_error);
}

template <class Real, std::size_t kRowsOfOutput>
void StemPasses<Real, kRowsOfOutput>::divide() {
  sums().solve_weights();
  next_ = 0;
  divided_ = true;
  stage_ = Stage::kParts;
}

template <class Real, std::size_t kRowsOfOutput>
int StemPasses<Real, kRowsOfOutput>::sum_part() {
  constexpr std::size_t kCount = SpokenParts<Real>::kCount;
  const Real error = sums().error_of(y_, stem(), first_ + next_ * rows() / kCount,
                                     first_ + (next_ + 1) * rows() / kCount);
  follows_ ? parts_.set(next_, error) : parts_.less(next_, error);
  stage_ = ++next_ == kCount ? Stage::kOver : Stage::kParts;
  return kUnit;
}

template class StemPasses<float>;
template class StemPasses<double>;
template class StemPasses<float, 64>;
template class StemPasses<double, 64>;

}  // namespace ident
