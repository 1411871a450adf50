#include "workbench/model/search/trial.hpp"

#include <algorithm>
#include <cmath>

#include "ident/signal/signal_shape.hpp"
#include "workbench/effects/common.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/judge/fitted_model.hpp"
#include "workbench/model/judge/intervals.hpp"
#include "workbench/model/judge/merit.hpp"
#include "workbench/model/judge/off_profile.hpp"
#include "workbench/model/judge/unearned_form.hpp"
#include "workbench/model/judge/untold_instant.hpp"
#include "workbench/model/search/left_to_controller.hpp"
#include "workbench/model/search/unsupported.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr double kLeastShare = 0.01;  // of the squared validation error

// Of the first member that has one.
std::string objection_to(const Trial& trial, const Situation& here) {
  for (const Effect* member : members_of(trial)) {
    std::string objection = objection_to(*member, *trial.fit, here);
    if (!objection.empty()) return objection;
  }
  return {};
}

}  // namespace

std::string percent(double share) {
  constexpr double kHardlyAny = 0.001;
  return share > 0 && share < kHardlyAny ? "less than 0.1 %"
                                         : number(100 * share, 3) + " %";
}

std::vector<const Effect*> members_of(const Trial& trial) {
  std::vector<const Effect*> out = {trial.effect};
  if (trial.partner != nullptr) out.push_back(trial.partner);
  if (trial.third != nullptr) out.push_back(trial.third);
  return out;
}

const char* const kUntold = "with values that cannot be told from none";

void leave_in_doubt(Trial& trial, const std::string& but) {
  trial.candidate.status = CandidateStatus::kUndecided;
  if (but == kUntold) trial.candidate.spoken_against = true;
  trial.candidate.evidence =
      filled("It takes away {0} of the squared error, but {1}.",
             {percent(trial.candidate.error_reduction_percent / 100), but});
}

bool is_member(const Trial& trial, const Trial& whole) {
  return whole.partner != nullptr && trial.partner == nullptr &&
         std::ranges::count(members_of(whole), trial.effect) > 0;
}

bool fits_better(const Trial* a, const Trial* b) {
  return total_error(*a->fit) < total_error(*b->fit);
}

double share_left(const Fitter& fitter, const Trial& trial, const Trial& of) {
  const double left = fitter.rmse_on(*trial.fit, false) / fitter.rmse_on(*of.fit, false);
  return left * left;
}

bool is_bent(const Description& effect) {
  return (effect.place >= Place::kRate && effect.place <= Place::kCharacteristic) ||
         effect.place == Place::kOverflow || effect.bends;
}

void examine(const Fitter& fitter, const Fit& base, Trial& trial) {
  const Fit& fit = trial.fit.emplace(without_unearned_forms(fitter, *trial.fit));
  const Blocks blocks = fitter.judging(fit, members_of(trial));
  trial.test = test_difference(base.residual, fit.residual, blocks);
  trial.ratio =
      bootstrap_ratio(base.residual, fit.residual, blocks, fitter.memory_samples());
  const Situation here = fitter.situation(fit);
  const std::vector<double> p = fit.searched_of(*trial.effect);
  // A load comes once, and has a test against noise of its own.
  if (!has_load(members_of(trial))) trial.test.p_value = trial.test.p_steady;
  if (trial.partner == nullptr && is_bent(trial.effect->description())) {
    const DifferenceTest ahead =
        test_given_past(base.residual, fit.residual, here.u, blocks);
    trial.p_free_running = trial.test.p_value;
    // Of few moves of u one may tell all that is told one sample ahead; what looks like
    // the residual from end to end is not one move alone. Nor is it a load that the
    // controller answers, where u moves by hand (W42).
    const double alike = likeness_by_chance(base.residual, fit.residual, blocks);
    const double told =
        ident::moves_rarely<double>(here.u) ? alike : std::max(ahead.p_value, alike);
    trial.test.p_value = std::max(trial.test.p_value, std::min(ahead.p_steady, told));
  }
  for (const Effect* member : members_of(trial)) {
    trial.test.p_value = std::max(
        trial.test.p_value,
        member->noise_test(here, fit.searched_of(*member), fit.solved_of(*member)));
  }
  trial.excitation = trial.effect->excitation(here, p);
  for (const Effect* member : members_of(trial)) {
    const Excitation seen = member->excitation(here, fit.searched_of(*member));
    const bool load = member->description().is_load();
    const bool asked = load || member != trial.effect;
    const bool scarce =
        asked && !is_excited(*member, seen, load ? 1 : trial.test.p_value);
    if (scarce || !seen.acted) trial.excitation = seen;
  }
  trial.objection = objection_to(trial, here);
  trial.edge = at_edge(fit, *trial.effect);
  if (const auto p_value = trial.effect->own_test(here, p)) {
    trial.own = true;
    trial.test.p_value = *p_value;
  }
}

bool is_significant(const Trial& trial) {
  return trial.p_family <= kSignificance;
}

void correct_for_many(std::vector<Trial>& trials) {
  std::vector<Trial*> fitted;
  for (Trial& trial : trials) {
    trial.p_family = 1;
    if (trial.fit) fitted.push_back(&trial);
  }
  std::sort(fitted.begin(), fitted.end(), [](const Trial* a, const Trial* b) {
    return a->test.p_value < b->test.p_value;
  });
  double highest = 0;
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    const double p = fitted[i]->test.p_value * static_cast<double>(fitted.size() - i);
    highest = std::max(highest, p);
    fitted[i]->p_family = std::min(highest, 1.0);
  }
}

bool is_in_process(const Trial& trial) {
  return trial.effect->description().place == Place::kProcess;
}

bool accepted(const Trial& trial) {
  return trial.candidate.status == CandidateStatus::kAccepted;
}

namespace {

// (W19)
bool has_gain(const Fit& fit) {
  for (std::size_t i = 0; i < fit.columns.size(); ++i) {
    if (FreeRun::is_gain(fit.columns[i]) && fit.coefficients[i] == 0) return false;
  }
  return true;
}

// What the intervals leave of a member that has derived parameters.
std::string doubt_in(const Fitter& fitter, const Trial& trial,
                     const FitIntervals& intervals) {
  for (const Effect* member : members_of(trial)) {
    std::vector<double> lows;
    for (const DerivedValue& derived : intervals.derived) {
      if (derived.effect == member) lows.push_back(derived.interval.low);
    }
    if (lows.empty()) continue;
    std::string doubt = member->doubt(fitter.situation(*trial.fit),
                                      trial.fit->searched_of(*member), lows);
    if (!doubt.empty()) return doubt;
  }
  return {};
}

// Which way is the wrong one, the sign of the gain says.
std::string doubt_in_sign(const Trial& trial, const FitIntervals& intervals) {
  if (!std::ranges::count(members_of(trial), &effects::process_inverse_response())) {
    return {};
  }
  const Fit& fit = *trial.fit;
  for (std::size_t i = 0; i < fit.columns.size(); ++i) {
    const Interval& gain = intervals.solved[i];
    if (FreeRun::is_gain(fit.columns[i]) && gain.low <= 0 && gain.high >= 0) {
      return "the interval of the gain holds 0, so that which way the process goes in "
             "the end, and which is the wrong one, is not told";
    }
  }
  return {};
}

}  // namespace

void check_intervals(const Fitter& fitter, Trial& trial) {
  if (!trial.fit || !is_significant(trial)) return;
  FitIntervals intervals = intervals_of(fitter, *trial.fit);
  trial.on = (!trial.effect->description().needs_u || has_gain(*trial.fit)) &&
             end_by_profile(fitter, *trial.fit, *trial.effect, intervals);
  trial.candidate.parameters = parameters_of(
      with_absent_limits(fitter, *trial.fit, intervals), intervals, trial.effect);
  if (trial.objection.empty()) trial.objection = doubt_in(fitter, trial, intervals);
  if (trial.objection.empty()) trial.objection = doubt_in_sign(trial, intervals);
}

namespace {

std::string doubt_in_instant(const Fitter& fitter, const Trial& trial) {
  for (const Effect* member : members_of(trial)) {
    const double width_s = untold_instant_s(fitter, *trial.fit, *member);
    if (width_s > 0) {
      return filled(
          "its instant may lie anywhere within {0} s, longer than the process remembers: "
          "a drift, or what moves with u, would do as much",
          {number(width_s, 3)});
    }
  }
  return {};
}

// Of a trial whose gain is there beyond chance: what the effect itself allows.
void conclude_significant(const Fitter& fitter, double share, Trial& trial) {
  Candidate& c = trial.candidate;
  if (trial.on && !c.phenomenological && trial.objection.empty()) {
    trial.objection = doubt_in_instant(fitter, trial);
  }
  if (!trial.own && share < kLeastShare) {
    c.status = CandidateStatus::kUndecided;
    c.evidence = filled(
        "It takes away {0} of the squared error, too little to matter beside what any "
        "model "
        "simplifies.",
        {percent(share)});
  } else if (trial.on && !c.phenomenological && trial.objection.empty()) {
    c.status = CandidateStatus::kAccepted;
    c.evidence = evidence_of(fitter, *trial.fit, members_of(trial));
  } else {
    leave_in_doubt(trial,
                   !trial.objection.empty() ? trial.objection
                   : c.phenomenological
                       ? "only at or beyond the edge of its physical range: not this "
                         "effect, but something that looks like it"
                       : kUntold);
  }
}

// An effect of `base` that does to the record what the trial would do: the two are names
// for one thing. Null where the trial does anything new.
const Effect* other_name(const Fit& base, const Trial& trial) {
  constexpr double kEqual = 1e-6;  // of the error
  const auto is_record = [](const Effect* effect) {
    return effect->description().place == Place::kRecord;
  };
  const bool new_thing = std::abs(trial.fit->error - base.error) > kEqual * base.error;
  if (!trial.own || trial.partner != nullptr || !is_record(trial.effect) || new_thing) {
    return nullptr;
  }
  const auto found = std::find_if(base.effects.begin(), base.effects.end(), is_record);
  return found != base.effects.end() ? *found : nullptr;
}

}  // namespace

void conclude(const Fitter& fitter, const Fit& base, Trial& trial) {
  Candidate& c = trial.candidate;
  c.effect = trial.effect->code();
  c.with.clear();
  for (const Effect* member : members_of(trial)) {
    if (member != trial.effect) c.with.emplace_back(member->code());
  }
  c.rmse_before = fitter.rmse(base);
  c.rmse_validation_before = fitter.rmse_on(base, false);
  c.rmse_after = c.rmse_before;
  c.rmse_validation_after = c.rmse_validation_before;
  if (trial.untried) {
    c.status = CandidateStatus::kUndecided;
    c.evidence = "The time was up before it was tried.";
    return;
  }
  if (trial.left_to_controller) return leave_to_controller(c);
  if (!trial.fit) {
    c.status = CandidateStatus::kRejected;
    c.evidence = "Nothing in the recording looks like it.";
    return;
  }
  c.rmse_after = fitter.rmse(*trial.fit);
  c.rmse_validation_after = fitter.rmse_on(*trial.fit, false);
  const double share =
      1 - std::pow(c.rmse_validation_after / c.rmse_validation_before, 2);
  c.error_reduction_percent = 100 * share;
  c.p_value = trial.test.p_value;
  trial.too_few = false;
  c.phenomenological = trial.edge;
  c.spoken_against = trial.edge || !trial.objection.empty();
  if (const Effect* other = other_name(base, trial)) {
    c.status = CandidateStatus::kRejected;
    c.evidence = filled(
        "It would do to the record what {0} in the model does; this recording cannot "
        "tell which of them it was.",
        {std::string(other->code())});
    return;
  }
  const double least = trial.effect->description().least_share;
  // A form of fewer parameters cannot owe its gain to a lucky stretch.
  const bool simpler = trial.fit->parameters() < base.parameters();
  const bool down =
      trial.own ? share > least
                : share > 0 && (trial.ratio.high < 1 || beyond_doubt(trial) || simpler) &&
                      earns_parameters(fitter, base, *trial.fit);
  if (trial.visible && is_excited(trial) && is_significant(trial) && down) {
    conclude_significant(fitter, share, trial);
  } else {
    conclude_unsupported(fitter, share, trial);
  }
}

void leave_untold_values_open(const Fitter& fitter, std::vector<Trial>& trials) {
  const auto is_told = [&](const Trial& trial) {
    const FitIntervals intervals = told_intervals_of(fitter, *trial.fit);
    return std::ranges::none_of(members_of(trial), [&](const Effect* member) {
      return holds_off(*trial.fit, intervals, *member);
    });
  };
  const Work::WritingDown writing(fitter.work());
  fitter.work().for_each(trials.size(), [&](std::size_t i) {
    Trial& trial = trials[i];
    const bool by_verdict =
        trial.partner == nullptr && trial.effect->description().is_stem();
    if (!accepted(trial) || trial.own || by_verdict || is_told(trial)) return;
    leave_in_doubt(trial, kUntold);
  });
}

}  // namespace workbench
