#include "ident/gap/model_gap.hpp"

#include <algorithm>
#include <cmath>

#include "ident/base/elementary.hpp"
#include "ident/base/two_pi.hpp"

namespace ident {
namespace {

// (G4) A suspect explains at least this share of the error, on samples that it was not
// fitted to, and gains so many nats of likelihood over all the columns that were tried.
// Set on simulated loops (host-tests/score/score_gap.cpp).
constexpr double kLeastShare = 0.15;
constexpr double kLeastShareOfStep = 0.45;  // which has a place to choose
constexpr double kLeastNats = 12;
// Factor of a column that is a whole effect: it would be 1.
constexpr double kLeastFactor = 0.3;
constexpr double kMostFactor = 2;

constexpr double kLineSpacing = 0.75;  // of 1/N
constexpr int kFirstLine = 7;          // 5¼ cycles in the window
constexpr double kShortestLine = 8;    // samples
constexpr int kRefinements = 6;
constexpr std::size_t kMostBlocks = 64;
constexpr double kHarmonic = 0.06;  // distance to a harmonic of the loop, in orders

// Samples of one piece, and what it takes on a Cortex-M4F, thousands of instructions;
// to begin a column takes two passes.
constexpr std::size_t kLookedAtOnce = 512;
constexpr int kCostOfLook = 80;
constexpr std::size_t kScannedAtOnce = 768;
constexpr int kCostOfLines = 80;
constexpr std::size_t kFollowedAtOnce = 224;
constexpr int kPerFollowed = 260;  // instructions
constexpr int kPerBegun = 16;

template <class Real>
Real least_share(EffectCode effect) {
  return effect == EffectCode::kDisturbanceStep ? Real(kLeastShareOfStep)
                                                : Real(kLeastShare);
}

}  // namespace

template <class Real>
void ModelGap<Real>::start(const GapWindow<Real>& window) {
  window_ = window;
  report_ = {};
  suspect_ = {};
  share_ = line_power_ = 0;
  best_line_ = index_ = 0;
  line_ = kFirstLine;
  begin_pass();
  const auto [low, high] = std::minmax_element(window_.stem.begin(), window_.stem.end());
  work_ = Look{*low, *high - *low, window_.stem[0], 0};
  stage_ = Stage::kLook;
}

template <class Real>
void ModelGap<Real>::begin_pass() {
  next_ = 0;
  sums_ = {};
}

template <class Real>
std::size_t ModelGap<Real>::end_of_piece() const {
  const std::size_t samples = stage_ == Stage::kLook    ? kLookedAtOnce
                              : stage_ == Stage::kLines ? kScannedAtOnce
                                                        : kFollowedAtOnce;
  return std::min(next_ + samples, window_.y.size());
}

template <class Real>
int ModelGap<Real>::cost_of_step() const {
  if (stage_ == Stage::kLook || stage_ == Stage::kLines) {
    return stage_ == Stage::kLook ? kCostOfLook : kCostOfLines;
  }
  const std::size_t begins = next_ == 0 ? window_.y.size() : 0;
  return static_cast<int>((end_of_piece() - next_) * kPerFollowed + begins * kPerBegun) /
             1000 +
         1;
}

// Equation (G2): the next few lines of the spectrum of e.
template <class Real>
void ModelGap<Real>::begin_lines() {
  begin_pass();
  const Real n = static_cast<Real>(window_.y.size());
  Lines& lines = work_.template emplace<Lines>();
  for (int k = 0; k < kLinesAtOnce; ++k) {
    const Real omega = Real(kTwoPi * kLineSpacing) * static_cast<Real>(line_ + k) / n;
    lines[k].turn_c = elementary::cos(omega);
    lines[k].turn_s = elementary::sin(omega);
  }
}

template <class Real>
void ModelGap<Real>::scan_lines() {
  Lines lines = *std::get_if<Lines>(&work_);
  const std::size_t end = end_of_piece();
  Real energy = sums_.energy;
  for (std::size_t t = next_; t < end; ++t) {
    const Real e = window_.y[t] - window_.simulated[t];
    energy += e * e;
    for (Phasor& p : lines) {
      p.sum_c += e * p.c;
      p.sum_s += e * p.s;
      const Real c = p.c * p.turn_c - p.s * p.turn_s;
      p.s = p.s * p.turn_c + p.c * p.turn_s;
      p.c = c;
    }
  }
  *std::get_if<Lines>(&work_) = lines;
  sums_.energy = energy;
  next_ = end;
}

template <class Real>
void ModelGap<Real>::take_lines() {
  const Real n = static_cast<Real>(window_.y.size());
  const Lines& lines = *std::get_if<Lines>(&work_);
  for (int k = 0; k < kLinesAtOnce; ++k) {
    const Phasor& p = lines[k];
    const Real power =
        Real(2) * (p.sum_c * p.sum_c + p.sum_s * p.sum_s) / (n * sums_.energy);
    if (power > line_power_) {
      line_power_ = power;
      best_line_ = line_ + k;
    }
  }
  line_ += kLinesAtOnce;
  if (Real(kLineSpacing) * static_cast<Real>(line_) * Real(kShortestLine) > n) {
    report_.views.line = std::min(line_power_, Real(1));
    report_.views.line_period =
        n / (Real(kLineSpacing) * static_cast<Real>(std::max(best_line_, 1)));
    stage_ = Stage::kList;
    begin_column(gap_candidate(0));
  } else {
    begin_lines();
  }
}

template <class Real>
Real ModelGap<Real>::strongest_line() const {
  return Real(kLineSpacing) * static_cast<Real>(best_line_) /
         static_cast<Real>(window_.y.size());
}

template <class Real>
typename GapFit<Real>::Row ModelGap<Real>::row_at(std::size_t t,
                                                  GapColumn<Real>& column) const {
  const std::array<Real, 2> values = column.at(t);
  return {Real(1), window_.simulated[t], values[0], values[1]};
}

// One candidate: its column, sample by sample.
template <class Real>
void ModelGap<Real>::begin_column(const GapCandidate& candidate) {
  begin_pass();
  candidate_ = candidate;
  fit_.clear();
  if (candidate.kind == GapKind::kLine) {
    const Real order = window_.period / report_.views.line_period;
    const Real nearest = std::max(std::round(order), Real(1));
    const Real apart = std::max(Real(kHarmonic), Real(1.5) * window_.period /
                                                     static_cast<Real>(window_.y.size()));
    if (std::abs(order - nearest) < apart) {
      candidate_.effect = EffectCode::kNone;  // a harmonic of the loop itself
      next_ = window_.y.size();
    }
  }
}

template <class Real>
void ModelGap<Real>::follow_column() {
  const std::size_t n = window_.y.size();
  const std::size_t end = end_of_piece();
  if (next_ == 0) {
    work_.template emplace<GapColumn<Real>>(candidate_, window_, strongest_line());
  }
  const std::size_t block =
      std::max(static_cast<std::size_t>(window_.period), n / kMostBlocks + 1);
  for (; next_ < end; ++next_) {
    fit_.add(static_cast<int>(next_ / block % 2), row_at(next_, column()),
             window_.y[next_] - window_.simulated[next_]);
  }
}

// What it explains: it is the suspect if it is the best so far.
template <class Real>
void ModelGap<Real>::take_column() {
  using Fit = GapFit<Real>;
  if (candidate_.effect == EffectCode::kNone) {
    return;
  }
  const Real share = fit_.share(candidate_.kind == GapKind::kLine ? 2 : 1);
  if (!(share > share_) || !(share > least_share<Real>(candidate_.effect))) {
    return;
  }
  const typename Fit::Row weights = fit_.weights();
  const Real factor = weights[Fit::kNuisances];
  if (candidate_.whole && !(factor > Real(kLeastFactor) && factor < Real(kMostFactor))) {
    return;
  }
  share_ = share;
  weights_ = weights;
  suspect_ = candidate_;
}

template <class Real>
void ModelGap<Real>::next_candidate() {
  if (++index_ < kGapCandidates) {
    begin_column(gap_candidate(index_));
    return;
  }
  index_ = 0;
  refinement_ = 0.5F;
  if (suspect_.effect != EffectCode::kNone && gap_spacing(suspect_) > 0) {
    stage_ = Stage::kRefine;
    refine();
  } else {
    begin_verification();
  }
}

// The suspect at settings nearer and nearer to the best one.
template <class Real>
void ModelGap<Real>::refine() {
  GapCandidate nearer = suspect_;
  const float sense = index_ % 2 == 0 ? 1.0F : -1.0F;
  nearer.value += sense * gap_spacing(suspect_) * refinement_;
  begin_column(nearer);
}

template <class Real>
void ModelGap<Real>::next_refinement() {
  if (++index_ % 2 == 0) {
    refinement_ /= 2;
  }
  if (index_ == kRefinements) {
    begin_verification();
  } else {
    refine();
  }
}

template <class Real>
void ModelGap<Real>::begin_verification() {
  begin_pass();
  candidate_ = suspect_;
  stage_ = Stage::kVerify;
  if (suspect_.effect == EffectCode::kNone) {
    next_ = window_.y.size();  // nothing to follow
  }
}

// What the suspect leaves.
template <class Real>
void ModelGap<Real>::verify() {
  const std::size_t end = end_of_piece();
  if (next_ == 0) {
    work_.template emplace<GapColumn<Real>>(candidate_, window_, strongest_line());
  }
  for (; next_ < end; ++next_) {
    const typename GapFit<Real>::Row row = row_at(next_, column());
    Real left = window_.y[next_] - window_.simulated[next_];
    for (std::size_t k = 0; k < row.size(); ++k) {
      left -= weights_[k] * row[k];
    }
    sums_.energy += left * left;
    sums_.beside += left * sums_.before;
    sums_.before = left;
  }
}

// Independent samples in what the suspect leaves: a column that only follows the trend of
// a residual leaves one that is as coloured as before.
template <class Real>
void ModelGap<Real>::take_verdict() {
  stage_ = Stage::kDone;
  // A recorded lattice adds the variance of half a step either way.
  const Real variance = report_.residual * report_.residual;
  const Real lattice = window_.y_step * window_.y_step / (Real(12) * variance);
  Real observations = window_.observations;
  if (lattice > share_) {
    share_ = std::min(lattice, Real(1));
    suspect_.effect = EffectCode::kSensorQuantisation;
  } else if (suspect_.effect != EffectCode::kNone) {
    const Real correlation =
        std::clamp(sums_.beside / sums_.energy, Real(0), Real(0.999));
    observations = static_cast<Real>(window_.y.size()) * (Real(1) - correlation) /
                   (Real(1) + correlation);
  }
  const Real nats =
      Real(-0.5) * observations * elementary::log(std::max(Real(1) - share_, Real(1e-6)));
  if (share_ > least_share<Real>(suspect_.effect) && nats > Real(kLeastNats)) {
    report_.suspect = suspect_.effect;
    report_.share_of_error = share_;
  }
}

template <class Real>
bool ModelGap<Real>::step() {
  switch (stage_) {
    case Stage::kLook:
      look();
      if (over()) {
        take_look();
      }
      break;
    case Stage::kLines:
      scan_lines();
      if (over()) {
        take_lines();
      }
      break;
    case Stage::kList:
    case Stage::kRefine:
      follow_column();
      if (over()) {
        take_column();
        if (stage_ == Stage::kList) {
          next_candidate();
        } else {
          next_refinement();
        }
      }
      break;
    case Stage::kVerify:
      verify();
      if (over()) {
        take_verdict();
      }
      break;
    case Stage::kDone:
      break;
  }
  return done();
}

template class ModelGap<float>;
template class ModelGap<double>;

}  // namespace ident
