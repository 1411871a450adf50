#include "ident/two_path/structure_search.hpp"

#include <algorithm>
#include <cmath>

#include "ident/base/configurations.hpp"
#include "ident/base/elementary.hpp"
#include "ident/two_path/knots.hpp"

namespace ident {
namespace {

constexpr int kDivisors = kSmallSizes ? 4 : 6;

// Numbers of equal segments that all come from the sums over kMaxSegments.
constexpr std::array<int, kDivisors> kSegments = [] {
  std::array<int, kDivisors> divisors{};
  int count = 0;
  for (int segments = 1; segments <= kMaxSegments; ++segments) {
    if (kMaxSegments % segments == 0) {
      divisors[count++] = segments;
    }
  }
  return divisors;
}();
constexpr int kSweeps = 3;

// Pieces, and what they take on a Cortex-M4F (docs/memory.md), thousands of instructions.
constexpr int kSumsAtOnce = 80;  // samples
constexpr int kCostOfSums = 76;
constexpr int kCostOfChoice = 5;
constexpr int kCostOfStanding = 75;  // whether it is like a process, and how good

}  // namespace

template <class Real>
bool is_process_like(const Process<Real>& process) {
  constexpr int kHorizon = 256;
  constexpr Real kWrongWay = Real(0.05);
  constexpr Real kKept = Real(0.4);
  std::array<Real, kMaxNa> past{};
  Real highest = 0;
  Real lowest = 0;
  Real now = 0;
  for (int t = 0; t < kHorizon; ++t) {
    now = 0;
    for (int j = 0; j < process.nb && j <= t; ++j) {
      now += process.b[j];
    }
    for (int i = 0; i < process.na; ++i) {
      now -= process.a[i] * past[i];
    }
    for (int i = kMaxNa - 1; i > 0; --i) {
      past[i] = past[i - 1];
    }
    past[0] = now;
    highest = std::max(highest, now);
    lowest = std::min(lowest, now);
  }
  return highest > Real(0) && -lowest < kWrongWay * highest && now > kKept * highest;
}

template <class Real>
void StructureSearch<Real>::start(const WindowView<Real>& window, ValveKind kind,
                                  std::span<Real> scratch) {
  window_ = window;
  kind_ = kind;
  scratch_ = scratch;
  kept_ = {};
  best_ = {};
  scratchpad_.template emplace<Sweep>();
  sweep().gram.start(uniform_grid<Real>(), window);
  centre_ = {2, 2, 2, linear() ? kMaxSegments : 6, linear() ? kMaxSegments : 6};
  centre_aic_ = 0;
  round_ = axis_ = index_ = swept_ = 0;
  refining_ = false;
  sweeping_ = Sweeping::kChoose;
  stage_ = Stage::kSums;
}

template <class Real>
Real StructureSearch<Real>::aic(const StructureCandidate<Real>& candidate) const {
  const Process<Real>& process = candidate.model.process;
  int dimension = process.na + process.nb + 1;
  if (!linear()) {
    dimension +=
        candidate.model.ascending.segments + candidate.model.descending.segments + 2;
  }
  // A perfect fit must not send the logarithm to −∞.
  const Real samples = static_cast<Real>(window_.y.size());
  const Real error = std::max(candidate.error, samples * Real(1e-12));
  return samples * elementary::log(error) + Real(2) * static_cast<Real>(dimension);
}

// The structure that the sweep tries next; false at the end of an axis.
template <class Real>
bool StructureSearch<Real>::sweep_structure(Structure& structure) const {
  structure = centre_;
  switch (axis_) {
    case 0:
      structure.nk = index_;
      return index_ <= kMaxNk;
    case 1:
      structure.na = index_ / kMaxNb + 1;
      structure.nb = index_ % kMaxNb + 1;
      return structure.na <= kMaxNa;
    case 2:
      structure.segments_ascending = kSegments[std::min(index_, kDivisors - 1)];
      return index_ < kDivisors;
    default:
      structure.segments_descending = kSegments[std::min(index_, kDivisors - 1)];
      return index_ < kDivisors;
  }
}

template <class Real>
void StructureSearch<Real>::choose_structure() {
  if (!sweep_structure(structure_)) {
    end_axis();
    return;
  }
  if (structure_ == centre_ && centre_aic_ != Real(0)) {
    ++index_;  // known
    return;
  }
  trial_ = {};
  Sweep& at = sweep();
  if (linear()) {
    at.iteration.start_linear(at.gram, structure_, trial_.model);
  } else {
    at.iteration.start(at.gram, structure_, trial_.model);
  }
  sweeping_ = Sweeping::kSolve;
}

// From the first measured outputs.
template <class Real>
void StructureSearch<Real>::begin_simulation() {
  for (int k = 0; k < structure_.na; ++k) {
    const WindowView<Real> head{window_.u.first(k + 1), window_.y.first(k + 1),
                                window_.ascending.first(k + 1)};
    simulate_paths<Real>(head, {}, trial_.model, trial_.initial, scratch_);
    trial_.initial[k] += window_.y[k] - scratch_[k];
  }
  sweep().simulation.start(window_, {}, trial_.model, trial_.initial, scratch_);
  sweeping_ = Sweeping::kSimulate;
}

// The sweep's opinion of the trial.
template <class Real>
void StructureSearch<Real>::take_structure() {
  trial_.known = trial_.known && std::isfinite(trial_.error);
  trial_.aic = aic(trial_);
  if (trial_.known && is_process_like(trial_.model.process)) {
    StructureCandidate<Real>& slot = kept_[structure_.na - 1];
    if (!slot.known || trial_.aic < slot.aic) {
      slot = trial_;
    }
    if (centre_aic_ == Real(0) || trial_.aic < centre_aic_) {
      centre_ = structure_;
      centre_aic_ = trial_.aic;
      swept_ = 0;
    }
  }
  ++index_;
  sweeping_ = Sweeping::kChoose;
}

template <class Real>
int StructureSearch<Real>::sweep_piece() {
  switch (sweeping_) {
    case Sweeping::kChoose:
      choose_structure();
      return kCostOfChoice;
    case Sweeping::kSolve: {
      TwoPathIteration<Real>& iteration = sweep().iteration;
      const int cost = iteration.cost_of_step();
      if (iteration.step()) {
        trial_.known = iteration.solved();
        if (trial_.known && is_stable(trial_.model.process)) {
          begin_simulation();
        } else {
          trial_.known = false;
          take_structure();
        }
      }
      return cost;
    }
    case Sweeping::kSimulate:
      if (sweep().simulation.step(kSimulatedAtOnce)) {
        trial_.error = sweep().simulation.error();
        sweeping_ = Sweeping::kTake;
      }
      break;
    case Sweeping::kTake:
      take_structure();
      return kCostOfStanding;
  }
  return kCostOfSimulated;
}

template <class Real>
void StructureSearch<Real>::end_axis() {
  index_ = 0;
  const int axes = linear() ? 2 : 4;
  if (++axis_ == axes) {
    axis_ = 0;
    ++round_;
  }
  if (++swept_ < axes && round_ < kSweeps) {
    return;
  }
  stage_ = Stage::kRefine;
  const bool none = std::none_of(kept_.begin(), kept_.end(),
                                 [](const auto& candidate) { return candidate.known; });
  if (none) {
    start_plain();
  }
  scratchpad_.template emplace<OutputErrorFit<Real>>();
}

// Where least squares found nothing process-like: a slow first-order process and a
// straight valve, left to the refinement.
template <class Real>
void StructureSearch<Real>::start_plain() {
  StructureCandidate<Real>& plain = kept_[0];
  plain.known = true;
  plain.model.process.a[0] = Real(-0.95);
  plain.model.process.b[0] = linear() ? Real(0.05) : Real(1);
  const KnotGrid<Real>& grid = sweep().gram.grid();
  plain.model.ascending = grid.ascending;
  plain.model.descending = grid.descending;
  const Real gain = linear() ? Real(1) : Real(0.05);
  for (int k = 0; k <= kMaxSegments; ++k) {
    plain.model.ascending.x[k] = gain * grid.ascending.knots[k];
    plain.model.descending.x[k] = gain * grid.descending.knots[k];
  }
}

template <class Real>
void StructureSearch<Real>::begin_refine(const StructureCandidate<Real>& from) {
  trial_ = from;
  refining_ = true;
}

template <class Real>
void StructureSearch<Real>::finish_refine() {
  trial_.error = output_error().error();
  trial_.aic = aic(trial_);
  const bool better =
      is_process_like(trial_.model.process) && (!best_.known || trial_.aic < best_.aic);
  if (better) {
    best_ = trial_;
  }
  refining_ = false;
  switch (stage_) {
    case Stage::kRefine:
      ++index_;
      break;
    case Stage::kDelay:
      // On in the same sense while it helps, else the other sense, else on to the knots.
      if (!better || ++index_ >= 3) {
        if (delay_step_ < 0) {
          begin_knots();
          break;
        }
        delay_step_ = -1;
        index_ = 0;
      }
      break;
    case Stage::kKnots:
      if (!better || ++index_ >= kKnotRounds) {
        stage_ = Stage::kDone;
      }
      break;
    default:
      break;
  }
}

template <class Real>
void StructureSearch<Real>::begin_knots() {
  stage_ = linear() ? Stage::kDone : Stage::kKnots;
  index_ = 0;
}

// What is refined next, or on to the next stage.
template <class Real>
void StructureSearch<Real>::next_refinement() {
  if (stage_ == Stage::kRefine) {
    while (index_ < kMaxNa && !kept_[index_].known) {
      ++index_;
    }
    if (index_ < kMaxNa) {
      begin_refine(kept_[index_]);
    } else if (best_.known) {
      stage_ = Stage::kDelay;
      index_ = 0;
      delay_step_ = 1;
    } else {
      stage_ = Stage::kDone;
    }
  } else if (stage_ == Stage::kDelay) {
    const int nk = best_.model.process.nk + delay_step_;
    if (nk < 0 || nk > kMaxNk) {
      if (delay_step_ < 0) {
        begin_knots();
      } else {
        delay_step_ = -1;
        index_ = 0;
      }
    } else {
      begin_refine(best_);
      trial_.model.process.nk = nk;
    }
  } else {
    begin_refine(best_);
    const bool ascending = refine_knots(trial_.model.ascending);
    const bool descending = refine_knots(trial_.model.descending);
    if (!ascending && !descending) {
      stage_ = Stage::kDone;
      refining_ = false;
    }
  }
  if (refining_) {
    output_error().start(window_, linear() ? window_.u : std::span<const Real>(),
                         kRefineSteps, trial_.model, trial_.initial, scratch_);
  }
}

// The smallest piece of work; returns its cost.
template <class Real>
int StructureSearch<Real>::piece() {
  if (stage_ == Stage::kSums) {
    if (sweep().gram.step(kSumsAtOnce)) {
      stage_ = Stage::kSweep;
    }
    return kCostOfSums;
  }
  if (stage_ == Stage::kSweep) {
    return sweep_piece();
  }
  if (!refining_) {
    next_refinement();
    return kCostOfChoice;
  }
  if (output_error().done()) {
    finish_refine();
    return kCostOfStanding;
  }
  return output_error().step();
}

template <class Real>
bool StructureSearch<Real>::step(int budget) {
  for (int left = budget * kUnit; left > 0 && !done();) {
    left -= piece();
  }
  return done();
}

template class StructureSearch<float>;
template class StructureSearch<double>;
template bool is_process_like<float>(const Process<float>&);
template bool is_process_like<double>(const Process<double>&);

}  // namespace ident
