#include "ident/in_place_identifier.hpp"

#include <algorithm>

#include "ident/base/configurations.hpp"
#include "ident/in_place_identifier_full_rate.hpp"
#include "ident/in_place_identifier_weigh.hpp"

namespace ident {
namespace {
// Decimation leaves at least this many samples in each cycle.
constexpr double kFewestPerCycle = 40;
// A valve with a memory is fitted to a first part with so many turning points, then to
// more.
constexpr std::size_t kFirstReversals = 4;
// Samples between two stored ones of y, from which on it is held.
constexpr double kHeld = 1.5;

}  // namespace

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::finish(Reason reason) {
  result_.verdict = verdict_of(reason);
  result_.reason = reason;
  stage_ = Stage::kDone;
  // Nor is it known what would have shown where most of y comes from elsewhere, or in a
  // few turns of u: a stem that rests most of the time leaves little; or where y is held
  // between samples of its own, of which u knows more than the record.
  const bool unseen = reason == Reason::kModelTooPoor || reason == Reason::kNotTheValve ||
                      reason == Reason::kTooFewCycles ||
                      result_.health.held_apart > Real(kHeld) || bends(result_.evidence);
  if (kStemSearch && !is_fault(result_.verdict) && unseen) {
    result_.detectable_band = result_.evidence.ladder.detectable_band = 0;
  }
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::start(std::span<Real> u, std::span<Real> y,
                                              std::span<const Real> sp, int gain_sign,
                                              const WindowOptions& options) {
  options_ = options;
  result_ = {};
  if constexpr (kTwoPathSearch) {
    two_path_ = {};
    linear_ = {};
  }
  chosen_ = {};
  placing_ = {};
  setpoint_ = {};
  scale_of_u_ = scale_of_y_ = {};
  size_ = std::min({u.size(), y.size(), Capacity});
  u_ = u.first(size_);
  y_ = y.first(size_);
  if (!all_finite<Real>(u_) || !all_finite<Real>(y_)) {
    size_ = 0;
    u_ = y_ = {};
    finish(Reason::kNotFinite);
    return;
  }
  if (size_ < kFewestSamples) {
    finish(Reason::kTooShort);
    return;
  }
  if (sp.size() >= size_ && all_finite<Real>(sp.first(size_))) {
    setpoint_ = sp.first(size_);
  }
  search_.template emplace<WindowSurvey<Real>>();
  survey().start({u_, y_, setpoint_, {ascending_.data(), size_}, scratch_, gain_sign});
  stage_ = Stage::kSurvey;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::survey_next() {
  const bool over = survey().step(result_);
  scale_of_u_ = survey().of_u();
  scale_of_y_ = survey().of_y();
  if (!over) {
    return;
  }
  movement_ = survey().movement();
  result_.evidence.pace = movement_.pace;
  if (survey().refusal() != Reason::kNone) {
    finish(survey().refusal());
    return;
  }
  search_.template emplace<LadderStage>();
  last_.template emplace<EvidenceStage>();
  closed_loop().start(evidence_window(ladder_stage().sums), ladder_stage().ladder);
  stage_ = Stage::kLadder;
}

template <class Real, std::size_t Capacity>
EvidenceWindow<Real> InPlaceIdentifier<Real, Capacity>::evidence_window(
    OneStepSums<Real>& sums) {
  EvidenceWindow<Real> window;
  window.u = u();
  window.y = y();
  window.scratch = {scratch_.data(), size_};
  window.sums = &sums;
  window.period = movement_.period;
  window.swing = movement_.swing;
  window.span =
      options_.span > 0 ? static_cast<Real>(options_.span) / u_range() : movement_.swing;
  return window;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::start_paths(
    typename StructureSearch<Real>::ValveKind kind) {
  if constexpr (kTwoPathSearch) {
    structure().start(window(), kind, {scratch_.data(), size_});
  }
}

template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::step(int budget) {
  if (stage_ < Stage::kLinearProcess) {
    find_valve(budget);
  } else if (stage_ <= Stage::kJudge) {
    judge_loop(budget);
  } else {
    explain_next(budget);
  }
  return done();
}

// From the window to the valve that explains it best, with its rivals and its intervals.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::find_valve(int budget) {
  switch (stage_) {
    case Stage::kSurvey:
      survey_next();
      break;
    case Stage::kLadder:
      if (closed_loop().step(budget)) {
        kStemSearch ? after_ladder() : take_ladder();
      }
      break;
    case Stage::kRivals:
      look_at_rivals(budget);
      break;
    case Stage::kTwoPath:
    case Stage::kLinear:
      find_paths(budget);
      break;
    case Stage::kValve:
      if (valve().step(budget)) {
        begin_weighing();
      }
      break;
    case Stage::kWeigh:
      if (run_pass(budget)) {
        weigh();
      }
      break;
    case Stage::kReference:
      if (run_pass(budget)) {
        begin_comparison();
      }
      break;
    case Stage::kCompare:
      if (run_pass(budget)) {
        compare_cycles();
      }
      break;
    case Stage::kIntervals:
      if (intervals().step(valve(), budget)) {
        look_at_loop();
      }
      break;
    default:
      break;
  }
}

// What else than a stem that sticks foretells y.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::look_at_rivals(int budget) {
  if constexpr (kStemSearch) {
    auto& rivals = ladder_stage().rivals;
    if (rivals.remembers) {
      if (rivals.memory.step(budget)) {
        result_.evidence.cycle.nats = rivals.memory.nats();
        look_at_bounds();
      }
    } else if (rivals.bounded.step(budget)) {
      result_.evidence.bounded = {rivals.bounded.nats(), rivals.bounded.bound()};
      look_beside_rung();
    }
  }
}

// The paper's structure, and a linear valve beside it.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::find_paths(int budget) {
  if constexpr (kTwoPathSearch) {
    if (!structure().step(budget)) {
      return;
    }
    const StructureCandidate<Real>& best = structure().best();
    if (stage_ == Stage::kTwoPath) {
      two_path_ = best;
      start_paths(StructureSearch<Real>::ValveKind::kLinear);
      stage_ = Stage::kLinear;
    } else {
      linear_ = {best.known, best.error, best.aic};
      take_two_path();
      start_valve();
    }
  }
}

// From the valve to the verdict: the loop around it, and what its stem foretells.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::judge_loop(int budget) {
  switch (stage_) {
    case Stage::kLinearProcess:
      if (solve_process(budget)) {
        stage_ = kNamesCause ? Stage::kCrossover : Stage::kSetpoint;
      }
      break;
    case Stage::kCrossover:
      if constexpr (kNamesCause) {
        look_at_crossover();
      }
      break;
    case Stage::kLinearOutput:
      if constexpr (kNamesCause) {
        if (simulate_process(budget)) {
          stage_ = Stage::kMargin;
        }
      }
      break;
    case Stage::kMargin:
      if constexpr (kNamesCause) {
        look_at_margin();
      }
      break;
    case Stage::kSetpoint:
      look_at_setpoint();
      break;
    case Stage::kStem:
      take_stem();
      break;
    case Stage::kProcess:
      if (solve_process(budget)) {
        placed() ? take_bands() : take_stem();
      }
      break;
    case Stage::kStemEvidence:
    case Stage::kStemSearched:
    case Stage::kStemConfirmed:
    case Stage::kBesideSetpoint:
      if (closed_loop().step(budget)) {
        take_stem_evidence();
      }
      break;
    case Stage::kJudge:
      take_verdict();
      break;
    default:
      break;
  }
}

// What stems foretell one sample ahead: the fitted one, then others.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::take_stem_evidence() {
  switch (stage_) {
    case Stage::kStemEvidence:
      return weigh_stem();
    case Stage::kStemSearched:
      return confirm_stem();
    case Stage::kStemConfirmed:
      return take_searched_stem();
    default:
      return take_beside_setpoint();
  }
}

// What the model lacks.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::explain_next(int budget) {
  if constexpr (kModelGap) {
    switch (stage_) {
      case Stage::kGapStem:
        lay_gap();
        break;
      case Stage::kGapOutput:
        if (simulate_process(budget)) {
          start_gap();
        }
        break;
      case Stage::kGap:
        for (int left = budget * kUnit; left > 0 && !gap().done();
             left -= gap().cost_of_step()) {
          gap().step();
        }
        if (gap().done()) {
          take_gap();
        }
        break;
      default:
        break;
    }
  }
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::start_valve() {
  int decimation = 1;
  if constexpr (kDecimates) {
    const Real room = std::min(movement_.period / Real(kFewestPerCycle),
                               static_cast<Real>(size_) / Real(kFewestSearched));
    decimation = std::max(static_cast<int>(room), 1);
  }
  std::size_t count = size_ / decimation;
  std::size_t first = 0;
  if (count > kMostSearched) {
    first = size_ - kMostSearched * decimation;
    count = kMostSearched;
  }
  search_.template emplace<ValveStage>();
  std::span<const Real> means = y();
  if (kDecimates && (decimation > 1 || count < size_)) {
    const std::span<Real> scaled{scratch_.data() + count, count};
    if (!scaled_means<Real>(y().subspan(first), decimation, scaled)) {
      finish(Reason::kConstant);
      return;
    }
    means = scaled;
  }
  std::size_t fifth = first;
  const std::size_t end = first + count * decimation;
  for (std::size_t reversals = 0; reversals < kFirstReversals && ++fifth < end;) {
    reversals += ascending_[fifth] != ascending_[fifth - 1] ? 1 : 0;
  }
  SearchWindow<Real> search;
  search.first_part = (fifth - first) / decimation;
  search.u = {u_.data() + first, end - first};
  search.y = means;
  search.decimation = decimation;
  search.period = movement_.period / static_cast<Real>(decimation);
  search.warm_up = first_return<Real>(
      u().subspan(first), {ascending_.data() + first, size_ - first}, movement_.period);
  search.swing = movement_.swing;
  search.drift = true;
  result_.decimation = decimation;
  const LadderFinding<Real>& ladder = result_.evidence.ladder;
  const bool doubted = ladder.predicted > 0 && ladder.nats < Real(kNoNats);
  ValveStage& stage = valve_stage();
  typename ValveSearch<Real>::Elsewhere* elsewhere = nullptr;
  if constexpr (kStemSearch) {
    elsewhere = options_.later_cycles ? &last_.template emplace<Elsewhere>() : nullptr;
  }
  stage.search.start(search, {stage.stem.data(), count}, {scratch_.data(), count},
                     stage.stems, options_.earlier, u_range(), doubted, elsewhere);
  stage_ = Stage::kValve;
}

template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::run_pass(int budget) {
  int left = budget * kUnit;
  return valve().pass().run(left);
}

template class InPlaceIdentifier<float, kSmallWindow>;
template class InPlaceIdentifier<float, kStandardWindow>;
template class InPlaceIdentifier<float, kLargeWindow>;
template class InPlaceIdentifier<double, kSmallWindow>;
template class InPlaceIdentifier<double, kStandardWindow>;
template class InPlaceIdentifier<double, kLargeWindow>;

}  // namespace ident
