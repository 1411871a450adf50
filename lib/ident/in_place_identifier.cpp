#include "ident/in_place_identifier.hpp"

#include <algorithm>

#include "ident/base/configurations.hpp"
#include "ident/in_place_identifier_full_rate.hpp"
#include "ident/in_place_identifier_stems.hpp"
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
  // Nor is it known what would have shown in a few turns of u: a stem that rests most of
  // the time leaves little; or where y is held between samples of its own, of which u
  // knows more than the record.
  const bool unseen = reason == Reason::kTooFewCycles ||
                      result_.health.held_apart > Real(kHeld);
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
bool InPlaceIdentifier<Real, Capacity>::survey_some() {
  const bool over = survey().step(result_);
  scale_of_u_ = survey().of_u();
  scale_of_y_ = survey().of_y();
  return over;
}

template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::after_survey() {
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
  const Real span =
      options_.span > 0 ? static_cast<Real>(options_.span) / u_range() : movement_.swing;
  return {u(), y(), {scratch_.data(), size_}, &sums, movement_.period, movement_.swing,
          span};
}

template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::step(int budget) {
  if (work(budget)) {
    if (stage_ < Stage::kLinearProcess) {
      find_valve();
    } else if (stage_ <= Stage::kJudge) {
      judge_loop();
    } else {
      explain_next();
    }
  }
  return done();
}

// About `budget` units of what the stage waits for; true when that is over.
template <class Real, std::size_t Capacity>
bool InPlaceIdentifier<Real, Capacity>::work(int budget) {
  int left = budget * kUnit;
  switch (stage_) {
    case Stage::kSurvey:
      return survey_some();
    case Stage::kCycle:
    case Stage::kBounds:
      if constexpr (kStemSearch) {
        auto& rivals = ladder_stage().rivals;
        return stage_ == Stage::kCycle ? rivals.memory.step(budget)
                                       : rivals.bounded.step(budget);
      }
      break;
    case Stage::kTwoPath:
    case Stage::kLinear:
      if constexpr (kTwoPathSearch) {
        return structure().step(budget);
      }
      break;
    case Stage::kValve:
      return valve().step(budget);
    case Stage::kWeigh:
    case Stage::kReference:
    case Stage::kCompare:
      return valve().pass().run(left);
    case Stage::kUneven:
      if constexpr (kStemSearch) {
        return std::get_if<Uneven>(&last_)->step(valve(), budget);
      }
      break;
    case Stage::kIntervals:
      return intervals().step(valve(), budget);
    case Stage::kLinearProcess:
    case Stage::kProcess:
      return solve_process(budget);
    case Stage::kLinearOutput:
    case Stage::kGapOutput:
      return (kNamesCause || kModelGap) && simulate_process(budget);
    case Stage::kLadder:
    case Stage::kStemEvidence:
    case Stage::kStemSearched:
    case Stage::kStemConfirmed:
    case Stage::kBesideSetpoint:
      return closed_loop().step(budget);
    case Stage::kBesideCurve:
      if constexpr (kStemSearch) {
        return std::get_if<BesideCurve>(&last_)->step(budget);
      }
      return true;
    case Stage::kGap:
      return look_for_gap(budget);
    default:
      break;
  }
  return true;
}

// From the window to the valve that explains it best, with its rivals and its intervals.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::find_valve() {
  switch (stage_) {
    case Stage::kSurvey:
      return after_survey();
    case Stage::kLadder:
      return after_ladder();
    case Stage::kCycle:
      return after_cycle();
    case Stage::kBounds:
      return after_bounds();
    case Stage::kTwoPath:
    case Stage::kLinear:
      return after_paths();
    case Stage::kValve:
      return begin_weighing();
    case Stage::kWeigh:
      return weigh();
    case Stage::kReference:
      return begin_comparison();
    case Stage::kCompare:
      return compare_cycles();
    case Stage::kUneven:
      return after_uneven();
    default:
      return look_at_loop();
  }
}

// The paper's structure, and a linear valve beside it.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::after_paths() {
  if constexpr (kTwoPathSearch) {
    if (stage_ == Stage::kTwoPath) {
      two_path_ = structure().best();
      structure().start(window(), StructureSearch<Real>::ValveKind::kLinear,
                        {scratch_.data(), size_});
      stage_ = Stage::kLinear;
    } else {
      take_two_path();
      start_valve();
    }
  }
}

// From the valve to the verdict: the loop around it, and what its stem foretells.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::judge_loop() {
  switch (stage_) {
    case Stage::kLinearProcess:
      stage_ = kNamesCause ? Stage::kCrossover : Stage::kSetpoint;
      return;
    case Stage::kCrossover:
      if constexpr (kNamesCause) {
        look_at_crossover();
      }
      return;
    case Stage::kLinearOutput:
      stage_ = Stage::kMargin;
      return;
    case Stage::kMargin:
      if constexpr (kNamesCause) {
        look_at_margin();
      }
      return;
    case Stage::kSetpoint:
      return look_at_setpoint();
    case Stage::kStem:
      return take_stem();
    case Stage::kProcess:
      return placed() ? take_bands() : take_stem();
    case Stage::kStemEvidence:
      return weigh_stem();
    case Stage::kStemSearched:
      return confirm_stem();
    case Stage::kStemConfirmed:
      return take_searched_stem();
    case Stage::kBesideSetpoint:
      return take_beside_setpoint();
    case Stage::kBesideCurve:
      return take_beside_curve();
    default:
      return take_verdict();
  }
}

// What the model lacks.
template <class Real, std::size_t Capacity>
void InPlaceIdentifier<Real, Capacity>::explain_next() {
  if constexpr (kModelGap) {
    switch (stage_) {
      case Stage::kGapStem:
        return lay_gap();
      case Stage::kGapOutput:
        return start_gap();
      case Stage::kGap:
        return take_gap();
      default:
        return;
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
  const SearchWindow<Real> search{
      .u = {u_.data() + first, end - first},
      .y = means,
      .decimation = decimation,
      .period = movement_.period / static_cast<Real>(decimation),
      .warm_up = first_return<Real>(u().subspan(first),
                                    {ascending_.data() + first, size_ - first},
                                    movement_.period),
      .first_part = (fifth - first) / decimation,
      .swing = movement_.swing};
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

template class InPlaceIdentifier<float, kSmallWindow>;
template class InPlaceIdentifier<float, kStandardWindow>;
template class InPlaceIdentifier<float, kLargeWindow>;
template class InPlaceIdentifier<double, kSmallWindow>;
template class InPlaceIdentifier<double, kStandardWindow>;
template class InPlaceIdentifier<double, kLargeWindow>;

}  // namespace ident
