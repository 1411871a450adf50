#include "ident/evidence/evidence_pool.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ident/base/elementary.hpp"
#include "ident/base/limits.hpp"

namespace ident {
namespace {

constexpr float kPerNat = 4;
// More than any size of four bytes would hold in float; counts beyond it are it.
constexpr float kMostPredicted = 0x1p31F;
constexpr int kMost = std::numeric_limits<std::int16_t>::max();
constexpr float kMostSum = kMost;

std::int16_t rounded(float quarter_nats) {
  const int nearest = static_cast<int>(std::floor(quarter_nats + 0.5f));
  return static_cast<std::int16_t>(std::clamp(nearest, -kMost, kMost));
}

}  // namespace

void EvidencePool::fade(float keep) {
  for (std::int16_t& sum : held_.quarter_nats) {
    sum = rounded(keep * static_cast<float>(sum));
  }
  held_.predicted *= keep;
  held_.windows *= keep;
}

template <class Real>
void EvidencePool::add(const Ladder<Real>& ladder, std::size_t predicted, float weight) {
  if (predicted == 0) {
    return;
  }
  float scale = weight * kPerNat;
  const auto sum = [&](std::size_t k) {
    return static_cast<float>(held_.quarter_nats[k]) +
           scale * static_cast<float>(ladder[k]);
  };
  // Sums cut off at the end of the range would make its rungs alike.
  if constexpr (kStemSearch) {
    float highest = kMostSum;
    for (std::size_t k = 0; k < ladder.size(); ++k) {
      highest = std::max(highest, sum(k));
    }
    if (highest > kMostSum) {
      weight *= kMostSum / highest;
      scale = weight * kPerNat;
      fade(kMostSum / highest);
    }
  }
  for (std::size_t k = 0; k < ladder.size(); ++k) {
    held_.quarter_nats[k] = rounded(sum(k));
  }
  held_.predicted += weight * static_cast<float>(predicted);
  held_.windows += weight;
}

template <class Real>
LadderFinding<Real> EvidencePool::finding(Real span) const {
  LadderFinding<Real> found;
  if (!(held_.windows > 0)) {
    return found;
  }
  const auto best =
      std::max_element(held_.quarter_nats.begin(), held_.quarter_nats.end());
  found.predicted = static_cast<std::size_t>(std::min(held_.predicted, kMostPredicted));
  found.nats = static_cast<Real>(*best) / Real(kPerNat) -
               elementary::log(std::max(static_cast<Real>(held_.predicted), Real(1)));
  const int index = static_cast<int>(best - held_.quarter_nats.begin());
  int lowest = index % kRungs;
  int highest = lowest;
  for (int k = 0; k < kLadderValves; ++k) {
    const auto sum = static_cast<float>(held_.quarter_nats[static_cast<std::size_t>(k)]);
    if (sum > static_cast<float>(*best) - static_cast<float>(kWithinNats) * kPerNat) {
      lowest = std::min(lowest, k % kRungs);
      highest = std::max(highest, k % kRungs);
    }
  }
  lay_interval(found, index % kRungs, lowest, highest, span);
  return found;
}

template void EvidencePool::add<float>(const Ladder<float>&, std::size_t, float);
template void EvidencePool::add<double>(const Ladder<double>&, std::size_t, float);
template LadderFinding<float> EvidencePool::finding<float>(float) const;
template LadderFinding<double> EvidencePool::finding<double>(double) const;

}  // namespace ident
