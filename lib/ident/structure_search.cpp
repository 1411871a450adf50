#include "ident/structure_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ident {
namespace {

// Numbers of equal segments that all come from the sums over twelve.
constexpr std::array<int, 6> kSegments{1, 2, 3, 4, 6, 12};
constexpr int kSweeps = 3;

template <class Real>
KnotGrid<Real> uniform_grid() {
  KnotGrid<Real> grid;
  for (Path<Real>* path : {&grid.ascending, &grid.descending}) {
    path->segments = kMaxSegments;
    for (int i = 0; i <= kMaxSegments; ++i) {
      path->knots[i] = static_cast<Real>(i) / Real(kMaxSegments);
    }
  }
  return grid;
}

// Remark 4: drops knots inside flat stretches, then splits the segment that rises most
// into three, if there is room and it is worth it. True when a segment was split.
template <class Real>
bool refine_knots(Path<Real>& path) {
  constexpr Real kFlat = Real(1e-3);  // of the whole rise
  constexpr Real kWorthSplitting = Real(0.15);
  constexpr Real kNarrowest = Real(0.02);  // of the range of u
  const Real rise = path.x[path.segments] - path.x[0];
  if (!(rise > Real(0))) {
    return false;
  }
  Path<Real> merged = path;
  int last = 0;
  for (int k = 1; k < path.segments; ++k) {
    const bool flat_before = path.x[k] - path.x[k - 1] < kFlat * rise;
    const bool flat_after = path.x[k + 1] - path.x[k] < kFlat * rise;
    if (!(flat_before && flat_after)) {
      ++last;
      merged.knots[last] = path.knots[k];
      merged.x[last] = path.x[k];
    }
  }
  ++last;
  merged.knots[last] = path.knots[path.segments];
  merged.x[last] = path.x[path.segments];
  merged.segments = last;
  path = merged;

  int steepest = -1;
  Real most = kWorthSplitting * rise;
  for (int k = 0; k < path.segments; ++k) {
    const Real step = path.x[k + 1] - path.x[k];
    if (step > most && path.knots[k + 1] - path.knots[k] > kNarrowest) {
      most = step;
      steepest = k;
    }
  }
  if (steepest < 0 || path.segments + 2 > kMaxSegments) {
    return false;
  }
  for (int k = path.segments; k > steepest; --k) {
    path.knots[k + 2] = path.knots[k];
    path.x[k + 2] = path.x[k];
  }
  path.segments += 2;
  const Real knot = path.knots[steepest];
  const Real x = path.x[steepest];
  const Real width = (path.knots[steepest + 3] - knot) / Real(3);
  const Real step = (path.x[steepest + 3] - x) / Real(3);
  for (int i = 1; i <= 2; ++i) {
    path.knots[steepest + i] = knot + static_cast<Real>(i) * width;
    path.x[steepest + i] = x + static_cast<Real>(i) * step;
  }
  return true;
}

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
  sweep().gram.accumulate(uniform_grid<Real>(), window);
  centre_ = {2, 2, 2, linear() ? kMaxSegments : 6, linear() ? kMaxSegments : 6};
  centre_aic_ = 0;
  round_ = axis_ = index_ = 0;
  stage_ = Stage::kSweep;
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
  return samples * std::log(error) + Real(2) * static_cast<Real>(dimension);
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
      structure.segments_ascending = kSegments[std::min<std::size_t>(index_, 5)];
      return index_ < static_cast<int>(kSegments.size());
    default:
      structure.segments_descending = kSegments[std::min<std::size_t>(index_, 5)];
      return index_ < static_cast<int>(kSegments.size());
  }
}

template <class Real>
void StructureSearch<Real>::evaluate(const Structure& structure) {
  using Valve = typename OutputErrorFit<Real>::Valve;
  trial_ = {};
  auto& [gram, iteration] = sweep();
  const bool solved = linear() ? iteration.fit_linear(gram, structure, trial_.model)
                               : iteration.fit(gram, structure, trial_.model);
  if (!solved || !is_stable(trial_.model.process)) {
    return;
  }
  // The simulation starts from the first measured outputs.
  for (int k = 0; k < structure.na; ++k) {
    const WindowView<Real> head{window_.u.first(k + 1), window_.y.first(k + 1),
                                window_.ascending.first(k + 1)};
    OutputErrorFit<Real>::simulate(head, Valve::kPaths, {}, trial_.model, trial_.initial,
                                   scratch_);
    trial_.initial[k] += window_.y[k] - scratch_[k];
  }
  trial_.error = OutputErrorFit<Real>::simulate(window_, Valve::kPaths, {}, trial_.model,
                                                trial_.initial, scratch_);
  trial_.aic = aic(trial_);
  if (!std::isfinite(trial_.error)) {
    return;
  }
  trial_.known = true;
  StructureCandidate<Real>& slot = kept_[structure.na - 1];
  if (is_process_like(trial_.model.process) && (!slot.known || trial_.aic < slot.aic)) {
    slot = trial_;
  }
}

template <class Real>
void StructureSearch<Real>::sweep_next() {
  Structure structure;
  if (sweep_structure(structure)) {
    evaluate(structure);
    const bool first = round_ == 0 && axis_ == 0 && index_ == 0;
    if (trial_.known && is_process_like(trial_.model.process) &&
        (centre_aic_ == Real(0) || trial_.aic < centre_aic_)) {
      centre_ = structure;
      centre_aic_ = trial_.aic;
    }
    if (first) {
      sweep_start_aic_ = centre_aic_;
    }
    ++index_;
    return;
  }
  index_ = 0;
  const int axes = linear() ? 2 : 4;
  if (++axis_ < axes) {
    return;
  }
  axis_ = 0;
  const bool improved = centre_aic_ < sweep_start_aic_;
  sweep_start_aic_ = centre_aic_;
  if (++round_ < kSweeps && (improved || round_ == 1)) {
    return;
  }
  stage_ = Stage::kRefine;
  index_ = 0;
  refine_left_ = 0;
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
  damping_ = OutputErrorFit<Real>::kFirstDamping;
  refine_left_ = kRefineSteps;
}

// One step on the simulation error; true when the trial is as good as it gets.
template <class Real>
bool StructureSearch<Real>::refine_once() {
  using Valve = typename OutputErrorFit<Real>::Valve;
  trial_.error =
      output_error().refine(window_, linear() ? Valve::kFixed : Valve::kPaths, window_.u,
                            1, trial_.model, trial_.initial, damping_, scratch_);
  --refine_left_;
  return refine_left_ == 0 || damping_ > OutputErrorFit<Real>::kWorstDamping;
}

template <class Real>
void StructureSearch<Real>::finish_refine() {
  trial_.aic = aic(trial_);
  const bool better =
      is_process_like(trial_.model.process) && (!best_.known || trial_.aic < best_.aic);
  if (better) {
    best_ = trial_;
  }
  refine_left_ = 0;
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

template <class Real>
bool StructureSearch<Real>::step(int budget) {
  // Against one regression of the valve's search over the window, as counted on a
  // Cortex-M4F (docs/memory.md).
  const int sweep_cost = linear() ? 2 : 45;
  const int refine_cost = linear() ? 10 : 80;
  for (int used = 0; used < budget && stage_ != Stage::kDone;) {
    if (stage_ == Stage::kSweep) {
      sweep_next();
      used += sweep_cost;
      continue;
    }
    if (refine_left_ > 0) {
      used += refine_cost;
      if (refine_once()) {
        finish_refine();
      }
      continue;
    }
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
        refine_left_ = 0;
      }
    }
  }
  return done();
}

template class StructureSearch<float>;
template class StructureSearch<double>;
template bool is_process_like<float>(const Process<float>&);
template bool is_process_like<double>(const Process<double>&);

}  // namespace ident
