#include "workbench/model/search/choice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "workbench/effects/effects.hpp"
#include "workbench/model/base/noise.hpp"
#include "workbench/model/fit/lags_in_series.hpp"
#include "workbench/model/judge/merit.hpp"
#include "workbench/model/judge/rivals.hpp"
#include "workbench/model/search/known_first.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr double kAsGood = 1;  // of the score; a parameter costs six or more

bool same_as(const Fitter& fitter, const Trial& best, const Trial& other) {
  return as_good(fitter, *other.fit, *best.fit);
}

std::string name_of(const Trial& trial) {
  return listed(members_of(trial), " with ", &Effect::code);
}

void conclude_on_member(Trial& trial, const Trial& whole) {
  trial.candidate.status = CandidateStatus::kUndecided;
  trial.candidate.evidence = filled(
      whole.third == nullptr
          ? "Alone it would take away {0} % of the squared error; the pair {1} explains "
            "more."
          : "Alone it would take away {0} % of the squared error; {1} together explain "
            "more.",
      {number(trial.candidate.error_reduction_percent, 3), name_of(whole)});
}

// Of a member that does not show alone, though the recording shows what it belongs to.
void conclude_on_unseen_member(Trial& trial, const Trial& whole) {
  const CandidateStatus status = trial.candidate.status;
  const bool unseen =
      status == CandidateStatus::kNotExcited || status == CandidateStatus::kRejected;
  if (!unseen || !is_member(trial, whole)) return;
  std::vector<const Effect*> others = members_of(whole);
  std::erase(others, trial.effect);
  trial.candidate.status = CandidateStatus::kUndecided;
  trial.candidate.evidence =
      filled("It shows only together with {0}.", {listed(others, ", ", &Effect::code)});
}

// What the readings themselves show, whatever the model.
bool is_fact(const Trial& trial) {
  return accepted(trial) && trial.own && trial.partner == nullptr &&
         trial.effect->description().place == Place::kRecord;
}

// What becomes of effects that pass alone but explain less than the best: is there
// anything left for them once that one is in the model, and the next one, too?
void explain_away(const Fitter& fitter, const Trial& best,
                  const std::vector<Trial*>& others) {
  std::vector<std::pair<Trial*, Fit>> waiting;
  const auto conclude_on = [&best](Trial& trial, const std::string& by, bool more) {
    trial.candidate.status =
        more ? CandidateStatus::kUndecided : CandidateStatus::kRejected;
    trial.candidate.evidence = filled(
        more && is_fact(best)
            ? "Alone it would take away {0} % of the squared error, but {1} is seen in "
              "the readings themselves; ask again when that is in the model."
        : more ? "Alone it would take away {0} % of the squared error, but {1} explains "
                 "it better; ask again when that is in the model."
               : "Alone it would take away {0} % of the squared error, but {1} explains "
                 "it better and leaves nothing for it.",
        {number(trial.candidate.error_reduction_percent, 3), by});
  };
  const std::string one = name_of(best);
  std::vector<std::optional<Fit>> both(others.size());
  fitter.work().for_each(others.size(), [&](std::size_t i) {
    if (!is_member(*others[i], best)) {
      both[i] = fitter.extend(*best.fit, *others[i]->effect, Effort::kScreen);
    }
  });
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (is_member(*others[i], best)) {
      conclude_on_member(*others[i], best);
      continue;
    }
    const bool more = both[i] && lowers_error(fitter, *best.fit, *both[i]);
    conclude_on(*others[i], one, more);
    if (more) waiting.emplace_back(others[i], std::move(*both[i]));
  }
  if (waiting.size() < 2) return;
  std::stable_sort(waiting.begin(), waiting.end(), [](const auto& a, const auto& b) {
    return total_error(a.second) < total_error(b.second);
  });
  const std::string two = one + " with " + waiting[0].first->candidate.effect;
  fitter.work().for_each(waiting.size() - 1, [&](std::size_t i) {
    Trial& trial = *waiting[i + 1].first;
    const auto third = fitter.extend(waiting[0].second, *trial.effect, Effort::kScreen);
    if (!third || !lowers_error(fitter, waiting[0].second, *third)) {
      conclude_on(trial, two, false);
    }
  });
}

// Two names for the same thing: both do the same to the readings.
bool is_same_fact(const Trial& one, const Trial& other) {
  constexpr double kEqual = 1e-6;
  return is_fact(one) && is_fact(other) &&
         std::abs(one.fit->error - other.fit->error) < kEqual * other.fit->error;
}

// Parameters less those of the initial state.
std::size_t of_the_plant(const Fit& fit) {
  std::size_t initial = 0;
  for (const FreeRun::Column& column : fit.columns) {
    initial += column.initial && !column.judges;
  }
  for (std::size_t i = 0; i < fit.slots.size(); ++i) {
    initial +=
        fit.slots[i].parameter.initial && FreeRun::is_searched(fit.slots, fit.p, i);
  }
  return fit.parameters() - initial;
}

// Leaves less with fewer parameters, and hardly more on the samples that judge, or the
// other way round: whitened, a few samples after each move of u may weigh more than all
// that is seen.
bool beats(const Fitter& fitter, const Trial& trial, const Trial& other) {
  const double judged = share_left(fitter, trial, other);
  const double all = total_error(*trial.fit) / total_error(*other.fit);
  return of_the_plant(*trial.fit) < of_the_plant(*other.fit) &&
         std::max(judged, all) < 1 + kLeastMissed && (all < 1 || judged < 1);
}

// That which beats `best`, where one does, listed first.
Trial* unbeaten(const Fitter& fitter, std::vector<Trial>& trials, Trial* best) {
  const double score = best->score;
  for (Trial& trial : trials) {
    if (accepted(trial) && !is_fact(trial) && beats(fitter, trial, *best)) best = &trial;
  }
  best->score = std::min(best->score, score - 1e-9);
  return best;
}

// The accepted trial with the best score; `colour` is the noise's. A fact comes before
// what may be doubted, unless that explains nearly all.
Trial* best_of(const Fitter& fitter, std::vector<Trial>& trials,
               const NoiseColour& colour) {
  constexpr double kHardlyAny = 0.1;
  Trial* fact = nullptr;
  Trial* other = nullptr;
  for (Trial& trial : trials) {
    if (!accepted(trial)) continue;
    trial.score = score_of(*trial.fit, colour);
    Trial*& best = is_fact(trial) ? fact : other;
    if (best == nullptr || trial.score < best->score) best = &trial;
  }
  if (other == nullptr) return fact;
  other = unbeaten(fitter, trials, other);
  if (fact == nullptr) return other;
  if (!(share_left(fitter, *other, *fact) < kHardlyAny)) return fact;
  other->score = std::min(other->score, fact->score - 1e-9);
  return other;
}

bool needs_a_cause(const Trial& trial) {
  return trial.partner == nullptr && trial.effect->description().is_unmeasured_load();
}

// What the recording cannot tell apart is looked for in the process first, the more so
// where the other is a load that somebody would have to find. By the scores of the fits:
// that of `best` may have been lowered to be listed first.
Trial* in_process_first(const Fitter& fitter, const NoiseColour& colour,
                        std::vector<Trial>& trials, Trial* best) {
  const auto in_process = [](const Trial& trial) {
    return trial.partner == nullptr && is_in_process(trial);
  };
  for (Trial& trial : trials) {
    if (!accepted(trial)) continue;
    const double margin = needs_a_cause(*best) ? kTooRich : kAsGood;
    const bool as_good =
        score_of(*trial.fit, colour) < score_of(*best->fit, colour) + margin;
    if (as_good && !is_fact(*best) && in_process(trial) && !in_process(*best) &&
        best->partner == nullptr && same_as(fitter, *best, trial)) {
      trial.score = std::min(trial.score, best->score - 1e-9);  // to be listed first
      best = &trial;
    }
  }
  return best;
}

bool is_in_group(const Fitter& fitter, const Trial& best, const Trial& trial) {
  if (is_fact(trial)) return is_same_fact(best, trial);
  return trial.partner == nullptr && best.partner == nullptr && !is_fact(best) &&
         trial.score < best.score + kTooRich && same_as(fitter, best, trial);
}

// Seen running free, not one sample ahead: not accepted, but not told from it either.
void name_unseen_ahead(const Fitter& fitter, std::vector<Trial>& trials,
                       const NoiseColour& colour, Trial& best) {
  constexpr double kHalf = 0.5;
  for (Trial& trial : trials) {
    const bool free_only =
        trial.fit && !is_significant(trial) && !is_fact(best) &&
        trial.partner == nullptr && !trial.edge && best.partner == nullptr &&
        trial.objection.empty() &&
        trial.p_free_running * static_cast<double>(trials.size()) < kSignificance &&
        is_excited(*trial.effect, trial.excitation, trial.p_free_running);
    if (!free_only) continue;
    const bool as_likely = score_of(*trial.fit, colour) <= best.score + kTooRich &&
                           same_as(fitter, best, trial);
    if (as_likely || share_left(fitter, trial, best) < kHalf) name_beside(trial, best);
  }
}

// Accepted but for the identification, which does not know: it is not told from it
// either.
void name_unconfirmed(const Fitter& fitter, std::vector<Trial>& trials,
                      const NoiseColour& colour, Trial& best) {
  for (Trial& trial : trials) {
    if (!trial.unconfirmed) continue;
    trial.score = score_of(*trial.fit, colour);
    if (is_in_group(fitter, best, trial)) name_beside(trial, best);
  }
}

// What leaves less, but moves too seldom to be told from chance, may be it as well.
void name_too_seldom(std::vector<Trial>& trials, const NoiseColour& colour, Trial& best) {
  if (best.partner != nullptr || is_fact(best)) return;
  for (Trial& trial : trials) {
    const bool possible = trial.too_few && trial.partner == nullptr && !trial.edge &&
                          trial.objection.empty();
    if (possible && fits_better(&trial, &best) &&
        score_of(*trial.fit, colour) <= best.score + kTooRich) {
      name_beside(trial, best);
    }
  }
}

// What makes y follow u later, by a lag or by a dead time.
bool is_delay(const Effect* effect) {
  return effect == &effects::process_dead_time() || is_lag(effect);
}

// (W33) That y comes later is told by the best one; not that it comes so by a lag where a
// dead time leaves less, though its gain, under a load, may be chance. And the other way
// round.
void name_other_delay(const Fitter& fitter, std::vector<Trial>& trials, Trial& best) {
  if (best.partner != nullptr || !is_delay(best.effect)) return;
  for (Trial& trial : trials) {
    const bool possible = trial.fit && trial.partner == nullptr && !accepted(trial) &&
                          is_delay(trial.effect) && trial.visible && !trial.edge &&
                          trial.objection.empty();
    if (possible && fits_better(&trial, &best) && share_left(fitter, trial, best) < 1 &&
        is_excited(*trial.effect, trial.excitation, trial.p_free_running)) {
      name_beside(trial, best);
    }
  }
}

// Play that has shown no slip is not told from a stem that slips where u made no move
// that would have shown it.
bool may_slip(const Fitter& fitter, const Trial& best, const Trial& trial) {
  return trial.fit && lacks_slip(*best.effect, *trial.effect) &&
         trial.partner == nullptr && best.partner == nullptr &&
         leaves_slip_open(fitter, *best.fit, *trial.fit);
}

}  // namespace

namespace {

// A curve over u.
bool is_static(const Effect* effect) {
  return effect != nullptr && (effect->description().place == Place::kLimit ||
                               effect->description().place == Place::kCharacteristic);
}

// What the readings show by themselves needs no partner to be seen.
bool is_of_record(const Effect* effect) {
  return effect != nullptr && effect->description().place == Place::kRecord;
}

// Of two curves over u, which are one, or of an effect and one of the record, that which
// passes alone and takes away nearly all that both do; else the pair. The other has its
// turn when the first is in the model.
Trial* does_nearly_all(std::vector<Trial>& trials, Trial* pair) {
  constexpr double kNearlyAll = 0.95;
  const bool curves = is_static(pair->effect) && is_static(pair->partner);
  const bool recorded = is_of_record(pair->effect) || is_of_record(pair->partner);
  if (pair->partner == nullptr || !(curves || recorded)) return pair;
  const auto reduction = [](const Trial& trial) {
    return trial.candidate.error_reduction_percent;
  };
  Trial* most = pair;
  for (Trial& trial : trials) {
    if (!is_member(trial, *pair) || !accepted(trial)) continue;
    if (reduction(trial) < kNearlyAll * reduction(*pair)) continue;
    if (most == pair || reduction(trial) > reduction(*most)) most = &trial;
  }
  return most;
}

}  // namespace

void name_beside(Trial& other, Trial& best) {
  const std::string_view code = other.effect->code();
  std::vector<std::string>& group = best.candidate.indistinguishable_from;
  if (std::find(group.begin(), group.end(), code) != group.end()) return;
  group.emplace_back(code);
  best.candidate.would_split = std::string(other.effect->description().split);
  name_back(other.candidate, *best.effect);
}

void name_back(Candidate& other, const Effect& named) {
  if (other.status == CandidateStatus::kRejected) {
    other.status = CandidateStatus::kUndecided;
  }
  other.indistinguishable_from.emplace_back(named.code());
  other.would_split = std::string(named.description().split);
}

void name_each_other(const std::vector<Trial*>& group) {
  if (group.size() < 2) return;
  for (Trial* member : group) {
    for (const Trial* other : group) {
      if (other != member) {
        member->candidate.indistinguishable_from.emplace_back(other->effect->code());
      }
    }
    const Trial* other = group[0] == member ? group[1] : group[0];
    member->candidate.would_split = std::string(other->effect->description().split);
  }
}

Trial* choose(const Fitter& fitter, std::vector<Trial>& trials) {
  const Trial* closest = nullptr;
  for (const Trial& trial : trials) {
    if (accepted(trial) && (closest == nullptr || fits_better(&trial, closest))) {
      closest = &trial;
    }
  }
  if (closest == nullptr) return nullptr;
  const NoiseColour colour = colour_of(closest->fit->residual);
  Trial* best = in_process_first(fitter, colour, trials, best_of(fitter, trials, colour));
  best = known_first(fitter, trials, does_nearly_all(trials, best));
  std::vector<Trial*> group = {best};
  std::vector<Trial*> others;
  Trial* slipping = nullptr;
  for (Trial& trial : trials) {
    if (&trial == best) continue;
    if (may_slip(fitter, *best, trial)) slipping = &trial;
    if (!accepted(trial)) {
      conclude_on_unseen_member(trial, *best);
      continue;
    }
    if (is_in_group(fitter, *best, trial) || &trial == slipping) {
      group.push_back(&trial);
    } else if (!is_fact(trial)) {
      others.push_back(&trial);
    }
  }
  try {
    explain_away(fitter, *best, others);
  } catch (const OutOfTime&) {
    for (Trial* other : others) other->candidate.status = CandidateStatus::kUndecided;
  }
  name_unseen_ahead(fitter, trials, colour, *best);
  name_unconfirmed(fitter, trials, colour, *best);
  name_too_seldom(trials, colour, *best);
  name_other_delay(fitter, trials, *best);
  if (slipping != nullptr && !accepted(*slipping)) name_beside(*slipping, *best);
  name_each_other(group);
  return best;
}

}  // namespace workbench
