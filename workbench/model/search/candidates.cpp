#include "workbench/model/search/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "workbench/model/base/noise.hpp"
#include "workbench/model/fit/parameter_search.hpp"
#include "workbench/model/judge/intervals.hpp"
#include "workbench/model/judge/merit.hpp"
#include "workbench/model/search/trial.hpp"
#include "workbench/recording/filled.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench {
namespace {

constexpr double kAsGood = 1;            // of the score; a parameter costs six or more
constexpr double kDoubtfulPercent = 10;  // an undecided effect that takes away more
constexpr std::size_t kClosest = 6;      // candidates that are searched to the end
constexpr std::size_t kClosestPairs = 3;
constexpr std::size_t kPaired = 5;         // candidates that are tried in pairs
constexpr std::size_t kPairedWithAll = 2;  // and, where those leave more than noise

// Tells how far a number of trials has come, one at a time.
class Steps {
 public:
  Steps(const ExplainProgress& progress, int of) : progress_(progress), of_(of) {}

  void begin(std::string_view effect) {
    const std::lock_guard lock(mutex_);
    ++begun_;
    if (progress_) progress_(effect, begun_, of_);
  }

 private:
  const ExplainProgress& progress_;
  int of_;
  int begun_ = 0;
  std::mutex mutex_;
};

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
                          const Catalogue& catalogue, const ExplainProgress& progress,
                          double hopeless_above) {
  std::vector<const Effect*> missing;
  for (const Effect* effect : catalogue.effects()) {
    if (std::find(base.effects.begin(), base.effects.end(), effect) ==
        base.effects.end()) {
      missing.push_back(effect);
    }
  }
  std::vector<Trial> trials(missing.size());
  for (std::size_t i = 0; i < trials.size(); ++i) trials[i].effect = missing[i];
  // The dearest first, so that the threads end together.
  std::vector<Trial*> order;
  for (Trial& trial : trials) order.push_back(&trial);
  std::stable_sort(order.begin(), order.end(), [](const Trial* a, const Trial* b) {
    return a->effect->description().sticks > b->effect->description().sticks;
  });
  Steps steps(progress, static_cast<int>(missing.size()));
  fitter.work().for_each(order.size(), [&](std::size_t i) {
    Trial& trial = *order[i];
    steps.begin(trial.effect->code());
    try {
      trial.fit = fitter.extend(base, *trial.effect, Effort::kScreen);
    } catch (const OutOfTime&) {
      trial.untried = true;
    }
  });
  std::vector<Trial*> promising;
  for (Trial& trial : trials) {
    if (!trial.fit || trial.fit->error > hopeless_above) continue;
    if (trial.fit->error < 0.995 * base.error) promising.push_back(&trial);
  }
  std::stable_sort(promising.begin(), promising.end(), fits_better);
  const auto search_to_the_end = [&](std::size_t i) {
    Trial& trial = *promising[i];
    if (is_jumpy(trial) || at_edge(*trial.fit, *trial.effect)) {
      // Where the error has steps or leads out of bounds, a few starts are too few.
      auto again = fitter.extend(base, *trial.effect, Effort::kThorough);
      if (again && again->error < trial.fit->error) trial.fit = std::move(*again);
    } else if (i < kClosest) {
      trial.fit = fitter.refine(*trial.fit);
    }
  };
  fitter.work().for_each(promising.size(), [&](std::size_t i) {
    try {
      search_to_the_end(i);
    } catch (const OutOfTime&) {  // what the screen found stands
    }
  });
  return trials;
}

bool is_in_process(const Trial& trial) {
  return trial.effect->description().place == Place::kProcess;
}

// Of those that fit alike, what is in the process comes before what may be elsewhere:
// alone they are the same, but the next effect acts before one and behind the other.
void process_first(std::vector<const Trial*>& order) {
  constexpr double kAlike = 1.001;
  for (auto at = order.begin(); at != order.end(); ++at) {
    if (is_in_process(**at)) continue;
    const double most = kAlike * (*at)->fit->error;
    const auto better = std::find_if(at, order.end(), [most](const Trial* trial) {
      return trial->fit->error > most || is_in_process(*trial);
    });
    if (better == order.end() || (*better)->fit->error > most) continue;
    std::rotate(at, better, better + 1);
  }
}

// Two effects together, from the better one on; kept only where each is needed.
std::vector<Trial> pairs_of(const Fitter& fitter, const Fit& base,
                            const std::vector<Trial>& trials, double hopeless_above) {
  std::vector<const Trial*> order;
  for (const Trial& trial : trials) {
    if (trial.fit) order.push_back(&trial);
  }
  std::sort(order.begin(), order.end(), fits_better);
  process_first(order);
  std::vector<Trial> pairs;
  // What does not come near the best single one explains nothing that it does not.
  constexpr double kNear = 1.2;
  const double useful =
      order.empty() ? 0 : std::min(hopeless_above, kNear * order[0]->fit->error);
  std::vector<std::pair<std::size_t, std::size_t>> waiting;
  const auto try_pairs = [&] {
    std::vector<Trial> tried(waiting.size());
    fitter.work().for_each(waiting.size(), [&](std::size_t k) {
      const auto [i, j] = waiting[k];
      tried[k].effect = order[i]->effect;
      tried[k].partner = order[j]->effect;
      tried[k].fit = fitter.extend(*order[i]->fit, *order[j]->effect, Effort::kScreen);
    });
    for (std::size_t k = 0; k < waiting.size(); ++k) {
      const double alone = order[waiting[k].first]->fit->error;
      const bool gains = tried[k].fit && tried[k].fit->error < 0.98 * alone;
      if (gains && tried[k].fit->error < useful) {
        pairs.push_back(std::move(tried[k]));
      }
    }
    waiting.clear();
  };
  const std::size_t few = std::min(kPaired, order.size());
  for (std::size_t i = 0; i < few; ++i) {
    for (std::size_t j = i + 1; j < few; ++j) waiting.emplace_back(i, j);
  }
  try_pairs();
  // Some effects show only beside another.
  const bool enough = std::any_of(pairs.begin(), pairs.end(), [](const Trial& pair) {
    return is_noise(pair.fit->residual);
  });
  for (std::size_t i = 0; !enough && i < std::min(kPairedWithAll, few); ++i) {
    for (std::size_t j = few; j < order.size(); ++j) waiting.emplace_back(i, j);
  }
  try_pairs();
  std::stable_sort(pairs.begin(), pairs.end(), [](const Trial& a, const Trial& b) {
    return total_error(*a.fit) < total_error(*b.fit);
  });
  if (pairs.size() > kClosestPairs) pairs.resize(kClosestPairs);
  constexpr double kFarBehind = 1.5;
  std::erase_if(pairs, [most = pairs.empty() ? 0 : kFarBehind * pairs[0].fit->error](
                           const Trial& pair) { return pair.fit->error > most; });
  const auto alone = [&order](const Effect* effect) -> const Trial& {
    return **std::find_if(order.begin(), order.end(), [effect](const Trial* trial) {
      return trial->effect == effect;
    });
  };
  fitter.work().for_each(pairs.size(), [&](std::size_t i) {
    pairs[i].fit = fitter.reconsider(fitter.refine(*pairs[i].fit), nullptr);
  });
  std::erase_if(pairs, [&](Trial& pair) {
    examine(fitter, base, pair);
    pair.visible = u_is_seen(fitter, *pair.fit);
    for (const Effect* member : {pair.effect, pair.partner}) {
      const Effect* const other = member == pair.effect ? pair.partner : pair.effect;
      if (!lowers_error(fitter, *alone(member).fit, *pair.fit)) return true;
      // A load and what bends it imitate one another: each must be seen beside the other.
      if (is_bent(member->description()) &&
          test_given_past(alone(other).fit->residual, pair.fit->residual,
                          fitter.situation(*pair.fit).u, fitter.blocks())
                  .p_value > kAsLikely) {
        return true;
      }
    }
    return false;
  });
  return pairs;
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
    trial.candidate.evidence = filled(
        more ? "Alone it would take away {0} % of the squared error, but {1} explains "
               "it better; ask again when that is in the model."
             : "Alone it would take away {0} % of the squared error, but {1} explains "
               "it better and leaves nothing for it.",
        {number(trial.candidate.error_reduction_percent, 3), by});
  };
  std::vector<std::optional<Fit>> both(others.size());
  fitter.work().for_each(others.size(), [&](std::size_t i) {
    both[i] = fitter.extend(*best.fit, *others[i]->effect, Effort::kScreen);
  });
  for (std::size_t i = 0; i < others.size(); ++i) {
    const bool more = both[i] && lowers_error(fitter, *best.fit, *both[i]);
    conclude_on(*others[i], best.candidate.effect, more);
    if (more) waiting.emplace_back(others[i], std::move(*both[i]));
  }
  if (waiting.size() < 2) return;
  std::stable_sort(waiting.begin(), waiting.end(), [](const auto& a, const auto& b) {
    return total_error(a.second) < total_error(b.second);
  });
  const std::string two =
      best.candidate.effect + " with " + waiting[0].first->candidate.effect;
  fitter.work().for_each(waiting.size() - 1, [&](std::size_t i) {
    Trial& trial = *waiting[i + 1].first;
    const auto third = fitter.extend(waiting[0].second, *trial.effect, Effort::kScreen);
    if (!third || !lowers_error(fitter, waiting[0].second, *third)) {
      conclude_on(trial, two, false);
    }
  });
}

// What the readings themselves show, whatever the model.
bool is_fact(const Trial& trial) {
  return accepted(trial) && trial.own && trial.partner == nullptr &&
         trial.effect->description().place == Place::kRecord;
}

// Two names for the same thing: both do the same to the readings.
bool is_same_fact(const Trial& one, const Trial& other) {
  constexpr double kEqual = 1e-6;
  return is_fact(one) && is_fact(other) &&
         std::abs(one.fit->error - other.fit->error) < kEqual * other.fit->error;
}

// Of those that pass, the one with the best score stands for its group; those that the
// data can tell from it wait until it is in the model. What the readings themselves show
// comes first, and no model explains it away.
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
    if (!accepted(trial)) continue;
    const bool first = best == nullptr || (is_fact(trial) && !is_fact(*best));
    const bool later = best != nullptr && is_fact(*best) && !is_fact(trial);
    if (first || (!later && trial.score < best->score)) best = &trial;
  }
  // What the recording cannot tell apart is looked for in the process first.
  const auto in_process = [](const Trial& trial) {
    return trial.partner == nullptr && is_in_process(trial);
  };
  for (Trial& trial : trials) {
    const bool as_good = accepted(trial) && trial.score < best->score + kAsGood;
    if (as_good && !is_fact(*best) && in_process(trial) && !in_process(*best) &&
        best->partner == nullptr && same_as(fitter, *best, trial)) {
      trial.score = best->score - 1e-9;  // to be listed first
      best = &trial;
    }
  }
  std::vector<Trial*> group = {best};
  std::vector<Trial*> others;
  for (Trial& trial : trials) {
    if (&trial == best || !accepted(trial)) continue;
    if (is_fact(trial)) {
      if (is_same_fact(*best, trial)) group.push_back(&trial);
      continue;
    }
    if (trial.partner == nullptr && best->partner == nullptr && !is_fact(*best) &&
        trial.score < best->score + kTooRich && same_as(fitter, *best, trial)) {
      group.push_back(&trial);
      continue;
    }
    others.push_back(&trial);
  }
  try {
    explain_away(fitter, *best, others);
  } catch (const OutOfTime&) {
    for (Trial* other : others) other->candidate.status = CandidateStatus::kUndecided;
  }
  // Seen running free, not one sample ahead: not accepted, but not told from it either.
  for (const Trial& trial : trials) {
    const bool free_only =
        trial.fit && !trial.significant && !is_fact(*best) && trial.partner == nullptr &&
        !trial.edge && best->partner == nullptr && trial.objection.empty() &&
        trial.p_free_running * static_cast<double>(trials.size()) < kSignificance &&
        trial.excitation.events >= trial.excitation.least;
    if (!free_only || score_of(*trial.fit, colour) > best->score + kTooRich) continue;
    if (!same_as(fitter, *best, trial)) continue;
    best->candidate.indistinguishable_from.emplace_back(trial.effect->code());
    best->candidate.would_split = std::string(trial.effect->description().split);
  }
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

namespace {

// What a trial found on the way may serve the smaller model as well.
void better_base(const Fitter& fitter, const std::vector<Trial>& trials, Fit& base) {
  std::vector<std::optional<Fit>> others(trials.size());
  fitter.work().for_each(trials.size(), [&](std::size_t i) {
    const Trial& trial = trials[i];
    if (!trial.fit || !(trial.fit->error < 0.98 * base.error)) return;
    others[i] = fitter.without(*trial.fit, *trial.effect);
  });
  for (std::optional<Fit>& other : others) {
    if (other && other->error < base.error) base = std::move(*other);
  }
}

}  // namespace

Exploration explore(const Fitter& fitter, const Fit& start, const Catalogue& catalogue,
                    const ExplainProgress& progress, double hopeless_above) {
  Exploration out;
  out.base = start;
  std::vector<Trial> trials =
      screen(fitter, out.base, catalogue, progress, hopeless_above);
  try {
    better_base(fitter, trials, out.base);
  } catch (const OutOfTime&) {  // the base stands as it is
  }
  std::optional<Work::WritingDown> last;
  const auto end_in_time = [&] {
    if (fitter.work().out_of_time()) last.emplace(fitter.work());
  };
  end_in_time();
  const bool seen = u_is_seen(fitter, out.base);
  fitter.work().for_each(trials.size(), [&](std::size_t i) {
    Trial& trial = trials[i];
    if (!trial.fit) return;
    examine(fitter, out.base, trial);
    trial.visible =
        !trial.effect->description().needs_u || seen || u_is_seen(fitter, *trial.fit);
  });
  const auto judge = [&] {
    correct_for_many(trials);
    const Work::WritingDown writing(fitter.work());
    fitter.work().for_each(trials.size(), [&](std::size_t i) {
      check_intervals(fitter, trials[i]);
      conclude(fitter, out.base, trials[i]);
    });
  };
  judge();
  // A white residual has no room for two effects that need each other; and where the best
  // one leaves little but noise, a second one waits for its turn.
  const auto leaves_noise = [](const Trial& trial) {
    return accepted(trial) && is_noise(trial.fit->residual);
  };
  if (!last && fitter.affordable() &&
      std::none_of(trials.begin(), trials.end(), leaves_noise) &&
      !is_white(out.base.residual)) {
    try {
      for (Trial& pair : pairs_of(fitter, out.base, trials, hopeless_above)) {
        trials.push_back(std::move(pair));
      }
    } catch (const OutOfTime&) {  // the single ones stand
    }
    judge();
  }
  end_in_time();
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
  out.result.recordings = quality(fitter, out.base).recordings;
  out.result.noise_rmse = std::sqrt(colour_of(out.base.residual).variance);
  const bool in_doubt = std::any_of(trials.begin(), trials.end(), [](const Trial& trial) {
    return trial.candidate.status == CandidateStatus::kUndecided &&
           trial.candidate.error_reduction_percent > kDoubtfulPercent;
  });
  out.result.complete = !last;
  out.result.explained = best == nullptr && !last && !in_doubt &&
                         is_noise(out.base.residual) &&
                         !(seen && follows_u(out.base.residual, fitter.recording().u));
  return out;
}

Catalogue judged_by(const Recording& recording, const Catalogue& known,
                    const std::vector<std::string>& kept) {
  Catalogue out = known;
  if (recording.pieces.empty() || !recording.pieces.back().judges) return out;
  for (const Effect* effect : known.effects()) {
    const bool given = std::find(kept.begin(), kept.end(), effect->code()) != kept.end();
    if (stays_behind(*effect) && !given) out = out.without(*effect);
  }
  return out;
}

void leave_open(const Recording& recording, const Catalogue& known,
                const Catalogue& judged, const std::vector<std::string>& held,
                ExplainResult& result) {
  for (const Effect* effect : known.effects()) {
    const bool in_model =
        std::find(held.begin(), held.end(), effect->code()) != held.end();
    if (judged.find(effect->code()) != nullptr || in_model) continue;
    Candidate c;
    c.effect = effect->code();
    c.status = CandidateStatus::kUndecided;
    c.rmse_before = c.rmse_after = result.rmse;
    c.rmse_validation_before = c.rmse_validation_after = result.rmse_validation;
    c.evidence = "It belongs to the recording that it was in, so that " +
                 recording.pieces.back().recording +
                 " cannot judge it; ask without a recording that judges.";
    result.candidates.push_back(std::move(c));
  }
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
