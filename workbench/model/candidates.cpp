#include "workbench/model/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "workbench/model/intervals.hpp"
#include "workbench/model/merit.hpp"
#include "workbench/model/noise.hpp"
#include "workbench/model/search.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr double kSignificance = 0.005;  // of the whole family of candidates
constexpr double kDoubt = 0.05;          // above it a candidate is rejected
constexpr double kAsGood = 1;            // of the score; a parameter costs six or more
constexpr double kDoubtfulPercent = 10;  // an undecided effect that takes away more
constexpr std::size_t kClosest = 6;      // candidates that are searched to the end
constexpr std::size_t kClosestPairs = 3;
constexpr std::size_t kPaired = 5;         // candidates that are tried in pairs
constexpr std::size_t kPairedWithAll = 2;  // and, where those leave more than noise

// One effect (or a pair) with its fit and what was found out about it.
struct Trial {
  const Effect* effect = nullptr;
  const Effect* partner = nullptr;
  std::optional<Fit> fit;
  DifferenceTest test;
  RatioInterval ratio;
  Excitation excitation;
  bool visible = true;
  bool significant = false;  // after Holm
  bool doubtful = false;     // the same at kDoubt
  std::string objection;     // why it cannot be this effect
  bool own = false;          // shown by the effect's own test, not by the error
  bool on = false;           // an interval excludes "off"
  bool edge = false;
  double score = 0;  // the smaller, the better; comparable between trials
  Candidate candidate;
};

bool fits_better(const Trial* a, const Trial* b) {
  return total_error(*a->fit) < total_error(*b->fit);
}

// A load that keeps step with a limit cycle is no objection to the valve that makes it.
std::string objection_to(const Trial& trial, const Situation& here) {
  const auto of = [&](const Effect& effect) {
    return effect.objection(here, trial.fit->searched_of(effect),
                            trial.fit->solved_of(effect));
  };
  if (trial.partner == nullptr) return of(*trial.effect);
  for (const auto& [one, other] :
       {std::pair(trial.effect, trial.partner), std::pair(trial.partner, trial.effect)}) {
    if (one->description().place == Place::kLoad && other->description().sticks) continue;
    std::string objection = of(*one);
    if (!objection.empty()) return objection;
  }
  return {};
}

void examine(const Fitter& fitter, const Fit& base, Trial& trial) {
  const Fit& fit = *trial.fit;
  trial.test = test_difference(base.residual, fit.residual, fitter.blocks());
  trial.ratio = bootstrap_ratio(base.residual, fit.residual, fitter.blocks(),
                                fitter.memory_samples());
  const Situation here = fitter.situation(fit);
  const std::vector<double> p = fit.searched_of(*trial.effect);
  trial.excitation = trial.effect->excitation(here, p);
  trial.objection = objection_to(trial, here);
  trial.edge = at_edge(fit, *trial.effect);
  if (const auto p_value = trial.effect->own_test(here, p)) {
    trial.own = true;
    trial.test.p_value = *p_value;
  }
}

std::string percent(double share) {
  return number(100 * share, 3) + " %";
}

// The one sentence, and the status, from what was found.
void conclude(const Fitter& fitter, const Fit& base, Trial& trial) {
  Candidate& c = trial.candidate;
  c.effect = trial.effect->code();
  if (trial.partner != nullptr) c.with = {std::string(trial.partner->code())};
  c.rmse_before = fitter.rmse(base);
  c.rmse_validation_before = fitter.rmse_on(base, false);
  c.rmse_after = c.rmse_before;
  c.rmse_validation_after = c.rmse_validation_before;
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
  c.phenomenological = trial.edge;
  const double least = trial.effect->description().least_share;
  const bool down = trial.own ? share > least
                              : share > 0 && trial.ratio.high < 1 &&
                                    earns_parameters(fitter, base, *trial.fit);
  const std::string events = "the recording has " +
                             std::to_string(trial.excitation.events) + " " +
                             std::string(trial.excitation.what);
  if (!trial.visible) {
    c.status = CandidateStatus::kNotExcited;
    c.evidence =
        "In this recording u hardly moves the output, so that effects between "
        "them do not show; change the setpoint a few times.";
  } else if (trial.excitation.events < kLeastEvents) {
    c.status = CandidateStatus::kNotExcited;
    c.evidence = "It would not show: " + events + ", and " +
                 std::to_string(kLeastEvents) + " are needed.";
  } else if (trial.significant && down && trial.on && !c.phenomenological &&
             trial.objection.empty()) {
    c.status = CandidateStatus::kAccepted;
    c.evidence = trial.effect->evidence(fitter.situation(*trial.fit),
                                        trial.fit->searched_of(*trial.effect),
                                        trial.fit->solved_of(*trial.effect));
  } else if (trial.significant && down) {
    c.status = CandidateStatus::kUndecided;
    c.evidence = "It takes away " + percent(share) + " of the squared error, but " +
                 (!trial.objection.empty() ? trial.objection
                  : c.phenomenological
                      ? "only at or beyond the edge of its physical range: not this "
                        "effect, but something that looks like it"
                      : "with values that cannot be told from none") +
                 ".";
  } else if (trial.doubtful && share > 0) {
    c.status = CandidateStatus::kUndecided;
    c.evidence = "It takes away " + percent(share) +
                 " of the squared error on samples that were not fitted, which chance "
                 "among so many candidates could do, too.";
  } else if (trial.effect->description().limits) {
    c.status = CandidateStatus::kNotExcited;
    c.evidence =
        "No such limit was reached: wherever one is put within what the recording "
        "covers, "
        "the error stays. It may lie beyond.";
  } else {
    c.status = CandidateStatus::kRejected;
    c.evidence = share > 0.001 ? "It takes away " + percent(share) +
                                     " of the squared error on samples that were not "
                                     "fitted, no more than chance."
                               : "It does not lower the error on samples that were not "
                                 "fitted.";
  }
}

// Holm's step-down procedure over all trials that were fitted.
void correct_for_many(std::vector<Trial>& trials) {
  std::vector<Trial*> fitted;
  for (Trial& trial : trials) {
    trial.significant = false;
    trial.doubtful = false;
    if (trial.fit) fitted.push_back(&trial);
  }
  std::sort(fitted.begin(), fitted.end(), [](const Trial* a, const Trial* b) {
    return a->test.p_value < b->test.p_value;
  });
  bool significant = true;
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    const double p = fitted[i]->test.p_value * static_cast<double>(fitted.size() - i);
    if (p > kDoubt) break;
    significant = significant && p <= kSignificance;
    fitted[i]->significant = significant;
    fitted[i]->doubtful = true;
  }
}

bool same_as(const Fitter& fitter, const Trial& best, const Trial& other) {
  return as_good(fitter, *other.fit, *best.fit);
}

bool is_jumpy(const Trial& trial) {
  return std::any_of(trial.fit->slots.begin(), trial.fit->slots.end(),
                     [&trial](const FreeRun::Slot& slot) {
                       return slot.effect == trial.effect && slot.parameter.jumpy &&
                              !slot.parameter.constant;
                     });
}

// Fits every effect that `base` lacks; the promising ones to the end.
std::vector<Trial> screen(const Fitter& fitter, const Fit& base,
                          const Catalogue& catalogue, const ExplainProgress& progress) {
  std::vector<const Effect*> missing;
  for (const Effect* effect : catalogue.effects()) {
    if (std::find(base.effects.begin(), base.effects.end(), effect) ==
        base.effects.end()) {
      missing.push_back(effect);
    }
  }
  std::vector<Trial> trials;
  for (const Effect* effect : missing) {
    if (progress) {
      progress(effect->code(), static_cast<int>(trials.size()) + 1,
               static_cast<int>(missing.size()));
    }
    Trial trial;
    trial.effect = effect;
    trial.fit = fitter.extend(base, *effect, Effort::kScreen);
    trials.push_back(std::move(trial));
  }
  std::vector<Trial*> promising;
  for (Trial& trial : trials) {
    if (trial.fit && trial.fit->error < 0.995 * base.error) promising.push_back(&trial);
  }
  std::sort(promising.begin(), promising.end(), fits_better);
  for (std::size_t i = 0; i < promising.size(); ++i) {
    Trial& trial = *promising[i];
    if (is_jumpy(trial) || at_edge(*trial.fit, *trial.effect)) {
      // Where the error has steps or leads out of bounds, a few starts are too few.
      auto again = fitter.extend(base, *trial.effect, Effort::kThorough);
      if (again && again->error < trial.fit->error) trial.fit = std::move(*again);
    } else if (i < kClosest) {
      trial.fit = fitter.refine(*trial.fit);
    }
  }
  return trials;
}

// Two effects together, from the better one on; kept only where each is needed.
std::vector<Trial> pairs_of(const Fitter& fitter, const Fit& base,
                            const std::vector<Trial>& trials) {
  std::vector<const Trial*> order;
  for (const Trial& trial : trials) {
    if (trial.fit) order.push_back(&trial);
  }
  std::sort(order.begin(), order.end(), fits_better);
  std::vector<Trial> pairs;
  const auto try_pair = [&](std::size_t i, std::size_t j) {
    Trial pair;
    pair.effect = order[i]->effect;
    pair.partner = order[j]->effect;
    pair.fit = fitter.extend(*order[i]->fit, *order[j]->effect, Effort::kScreen);
    const bool gains = pair.fit && pair.fit->error < 0.98 * order[i]->fit->error;
    if (gains) pairs.push_back(std::move(pair));
  };
  const std::size_t few = std::min(kPaired, order.size());
  for (std::size_t i = 0; i < few; ++i) {
    for (std::size_t j = i + 1; j < few; ++j) try_pair(i, j);
  }
  // Some effects show only beside another.
  const bool enough = std::any_of(pairs.begin(), pairs.end(), [](const Trial& pair) {
    return is_noise(pair.fit->residual);
  });
  for (std::size_t i = 0; !enough && i < std::min(kPairedWithAll, few); ++i) {
    for (std::size_t j = few; j < order.size(); ++j) try_pair(i, j);
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Trial& a, const Trial& b) {
    return total_error(*a.fit) < total_error(*b.fit);
  });
  if (pairs.size() > kClosestPairs) pairs.resize(kClosestPairs);
  const auto alone = [&order](const Effect* effect) -> const Trial& {
    return **std::find_if(order.begin(), order.end(), [effect](const Trial* trial) {
      return trial->effect == effect;
    });
  };
  std::erase_if(pairs, [&](Trial& pair) {
    pair.fit = fitter.reconsider(fitter.refine(*pair.fit), nullptr);
    examine(fitter, base, pair);
    pair.visible = u_is_seen(fitter, *pair.fit);
    for (const Effect* member : {pair.effect, pair.partner}) {
      if (!lowers_error(fitter, *alone(member).fit, *pair.fit)) return true;
    }
    return false;
  });
  return pairs;
}

void check_intervals(const Fitter& fitter, Trial& trial) {
  if (!trial.fit || !trial.significant) return;
  const FitIntervals intervals = intervals_of(fitter, *trial.fit);
  trial.on = excludes_off(fitter, *trial.fit, intervals, *trial.effect);
  trial.candidate.parameters = parameters_of(*trial.fit, intervals, trial.effect);
}

bool accepted(const Trial& trial) {
  return trial.candidate.status == CandidateStatus::kAccepted;
}

// What becomes of effects that pass alone but explain less than the best: is there
// anything left for them once that one is in the model, and the next one, too?
void explain_away(const Fitter& fitter, const Trial& best,
                  const std::vector<Trial*>& others) {
  std::vector<std::pair<Trial*, Fit>> waiting;
  const auto conclude_on = [](Trial& trial, const std::string& by, bool more) {
    trial.candidate.status =
        more ? CandidateStatus::kUndecided : CandidateStatus::kRejected;
    trial.candidate.evidence =
        "Alone it would take away " + number(trial.candidate.error_reduction_percent, 3) +
        " % of the squared error, but " + by +
        (more ? " explains it better; ask again when that is in the model."
              : " explains it better and leaves nothing for it.");
  };
  for (Trial* trial : others) {
    auto both = fitter.extend(*best.fit, *trial->effect, Effort::kScreen);
    const bool more = both && lowers_error(fitter, *best.fit, *both);
    conclude_on(*trial, best.candidate.effect, more);
    if (more) waiting.emplace_back(trial, std::move(*both));
  }
  if (waiting.size() < 2) return;
  std::stable_sort(waiting.begin(), waiting.end(), [](const auto& a, const auto& b) {
    return total_error(a.second) < total_error(b.second);
  });
  const auto& [next, fit] = waiting[0];
  const std::string two = best.candidate.effect + " with " + next->candidate.effect;
  for (std::size_t i = 1; i < waiting.size(); ++i) {
    Trial& trial = *waiting[i].first;
    const auto third = fitter.extend(fit, *trial.effect, Effort::kScreen);
    if (!third || !lowers_error(fitter, fit, *third)) conclude_on(trial, two, false);
  }
}

// Of those that pass, the one with the best score stands for its group; those that the
// data can tell from it wait until it is in the model.
Trial* choose(const Fitter& fitter, std::vector<Trial>& trials) {
  const Trial* closest = nullptr;
  for (const Trial& trial : trials) {
    if (accepted(trial) && (closest == nullptr || fits_better(&trial, closest))) {
      closest = &trial;
    }
  }
  if (closest == nullptr) return nullptr;
  const NoiseColour colour = colour_of(closest->fit->residual);
  Trial* best = nullptr;
  for (Trial& trial : trials) {
    if (accepted(trial)) trial.score = score_of(*trial.fit, colour);
    if (accepted(trial) && (best == nullptr || trial.score < best->score)) best = &trial;
  }
  // What the recording cannot tell apart is looked for in the process first.
  const auto in_process = [](const Trial& trial) {
    return trial.partner == nullptr &&
           trial.effect->description().place == Place::kProcess;
  };
  for (Trial& trial : trials) {
    const bool as_good = accepted(trial) && trial.score < best->score + kAsGood;
    if (as_good && in_process(trial) && !in_process(*best) && best->partner == nullptr &&
        same_as(fitter, *best, trial)) {
      trial.score = best->score - 1e-9;  // to be listed first
      best = &trial;
    }
  }
  std::vector<Trial*> group = {best};
  std::vector<Trial*> others;
  for (Trial& trial : trials) {
    if (&trial == best || !accepted(trial)) continue;
    if (trial.partner == nullptr && best->partner == nullptr &&
        trial.score < best->score + kTooRich && same_as(fitter, *best, trial)) {
      group.push_back(&trial);
      continue;
    }
    others.push_back(&trial);
  }
  explain_away(fitter, *best, others);
  for (Trial* member : group) {
    if (group.size() < 2) break;
    for (const Trial* other : group) {
      if (other != member) {
        member->candidate.indistinguishable_from.emplace_back(other->effect->code());
      }
    }
    const Trial* other = group[0] == member ? group[1] : group[0];
    member->candidate.would_split = std::string(other->effect->description().split);
  }
  return best;
}

int rank(const Candidate& c) {
  switch (c.status) {
    case CandidateStatus::kAccepted:
      return 0;
    case CandidateStatus::kUndecided:
      return 1;
    case CandidateStatus::kRejected:
      return 2;
    case CandidateStatus::kNotExcited:
      return 3;
  }
  return 4;
}

}  // namespace

Exploration explore(const Fitter& fitter, const Fit& start, const Catalogue& catalogue,
                    const ExplainProgress& progress) {
  Exploration out;
  out.base = start;
  std::vector<Trial> trials = screen(fitter, out.base, catalogue, progress);
  // What a trial found on the way may serve the smaller model as well.
  for (const Trial& trial : trials) {
    if (!trial.fit || !(trial.fit->error < 0.98 * out.base.error)) continue;
    Fit other = fitter.without(*trial.fit, *trial.effect);
    if (other.error < out.base.error) out.base = std::move(other);
  }
  const bool seen = u_is_seen(fitter, out.base);
  for (Trial& trial : trials) {
    if (!trial.fit) continue;
    examine(fitter, out.base, trial);
    trial.visible =
        !trial.effect->description().needs_u || seen || u_is_seen(fitter, *trial.fit);
  }
  const auto judge = [&] {
    correct_for_many(trials);
    for (Trial& trial : trials) {
      check_intervals(fitter, trial);
      conclude(fitter, out.base, trial);
    }
  };
  judge();
  // A white residual has no room for two effects that need each other; and where the best
  // one leaves little but noise, a second one waits for its turn.
  const auto leaves_noise = [](const Trial& trial) {
    return accepted(trial) && is_noise(trial.fit->residual);
  };
  if (std::none_of(trials.begin(), trials.end(), leaves_noise) &&
      !is_white(out.base.residual)) {
    for (Trial& pair : pairs_of(fitter, out.base, trials)) {
      trials.push_back(std::move(pair));
    }
    judge();
  }
  Trial* best = choose(fitter, trials);
  if (best != nullptr) out.best = *best->fit;
  std::stable_sort(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) {
    const int ra = rank(a.candidate);
    const int rb = rank(b.candidate);
    return ra != rb  ? ra < rb
           : ra == 0 ? a.score < b.score
                     : a.candidate.error_reduction_percent >
                           b.candidate.error_reduction_percent;
  });
  for (const Trial& trial : trials) {
    // A pair that failed says nothing that its members do not say.
    if (trial.partner != nullptr && !accepted(trial)) continue;
    out.result.candidates.push_back(trial.candidate);
  }
  out.result.rmse = fitter.rmse(out.base);
  out.result.rmse_validation = fitter.rmse_on(out.base, false);
  out.result.noise_rmse = std::sqrt(colour_of(out.base.residual).variance);
  const bool in_doubt = std::any_of(trials.begin(), trials.end(), [](const Trial& trial) {
    return trial.candidate.status == CandidateStatus::kUndecided &&
           trial.candidate.error_reduction_percent > kDoubtfulPercent;
  });
  out.result.explained = best == nullptr && !in_doubt && is_noise(out.base.residual) &&
                         !(seen && follows_u(out.base.residual, fitter.recording().u));
  return out;
}

bool still_needed(const Fitter& fitter, const Fit& fit, const Effect& effect,
                  std::optional<Fit>& without) {
  without = fitter.without(fit, effect);
  const DifferenceTest test =
      test_difference(without->residual, fit.residual, fitter.blocks());
  return test.p_value < kAsLikely &&
         fitter.rmse_on(fit, false) < fitter.rmse_on(*without, false);
}

}  // namespace workbench
