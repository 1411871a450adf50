#include "workbench/model/search/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <mutex>
#include <utility>

#include "workbench/model/base/noise.hpp"
#include "workbench/model/judge/fitted_model.hpp"
#include "workbench/model/judge/intervals.hpp"
#include "workbench/model/judge/merit.hpp"
#include "workbench/model/judge/off_profile.hpp"
#include "workbench/model/judge/untold_instant.hpp"
#include "workbench/model/search/choice.hpp"
#include "workbench/model/search/fitted_only.hpp"
#include "workbench/model/search/left_to_controller.hpp"
#include "workbench/model/search/outdone.hpp"
#include "workbench/model/search/pairs.hpp"
#include "workbench/model/search/play_instead.hpp"
#include "workbench/model/search/told_ahead.hpp"
#include "workbench/model/search/trial.hpp"
#include "workbench/model/search/triples.hpp"
#include "workbench/model/search/verdict_on_stems.hpp"

namespace workbench {
namespace {

constexpr double kDoubtfulPercent = 10;  // an undecided effect that takes away more
constexpr double kHardlyAny = 0.03;      // of the squared residual, to follow u
constexpr std::size_t kClosest = 6;      // candidates that are searched to the end

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

bool is_jumpy(const Trial& trial) {
  return std::any_of(trial.fit->slots.begin(), trial.fit->slots.end(),
                     [&trial](const FreeRun::Slot& slot) {
                       return slot.effect == trial.effect && slot.parameter.jumpy &&
                              !slot.parameter.constant;
                     });
}

// One of every effect that `base` lacks.
std::vector<Trial> trials_of(const Fit& base, const Catalogue& catalogue, bool blind) {
  std::vector<Trial> trials;
  for (const Effect* effect : catalogue.effects()) {
    if (contains(base.effects, *effect)) continue;
    Trial& trial = trials.emplace_back();
    trial.effect = effect;
    trial.left_to_controller = blind && effect->description().needs_u;
  }
  return trials;
}

// Fits every effect that `base` lacks, `blind` none that is told from u; the promising
// ones to the end.
std::vector<Trial> screen(const Fitter& fitter, const Fit& base,
                          const Catalogue& catalogue, const ExplainProgress& progress,
                          double hopeless_above, bool blind) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  std::vector<Trial> trials = trials_of(base, catalogue, blind);
  std::vector<ScreenedStarts> seen(trials.size());
  const auto seen_of = [&](const Trial& trial) -> ScreenedStarts& {
    return seen[static_cast<std::size_t>(&trial - trials.data())];
  };
  // The dearest first, so that the threads end together.
  std::vector<Trial*> order;
  for (Trial& trial : trials) {
    if (!trial.left_to_controller) order.push_back(&trial);
  }
  std::stable_sort(order.begin(), order.end(), [](const Trial* a, const Trial* b) {
    return a->effect->description().sticks > b->effect->description().sticks;
  });
  Steps steps(progress, static_cast<int>(order.size()));
  fitter.work().for_each(order.size(), [&](std::size_t i) {
    Trial& trial = *order[i];
    steps.begin(trial.effect->code());
    try {
      trial.fit =
          fitter.extend(base, *trial.effect, Effort::kScreen, kAny, &seen_of(trial));
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
    const bool recorded = trial.effect->description().recorded;
    if (recorded || is_jumpy(trial) || at_edge(*trial.fit, *trial.effect)) {
      // Where the error has steps or leads out of bounds, a few starts are too few.
      auto again =
          fitter.extend(base, *trial.effect, Effort::kThorough, kAny, &seen_of(trial));
      // A recorded load moves with u often enough to have bent all that was found
      // without it.
      if (again && recorded) again = fitter.reconsider(std::move(*again), trial.effect);
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

void judge(const Fitter& fitter, const Fit& base, std::vector<Trial>& trials) {
  correct_for_many(trials);
  const Work::WritingDown writing(fitter.work());
  fitter.work().for_each(trials.size(), [&](std::size_t i) {
    check_intervals(fitter, trials[i]);
    conclude(fitter, base, trials[i]);
  });
}

// Pairs and, where none passes, three together. What is asked for in place of one effect
// need not be three.
void add_together(const Fitter& fitter, const Fit& base, double hopeless_above,
                  std::vector<Trial>& trials) {
  std::vector<Trial> closest;
  for (Trial& pair : pairs_of(fitter, base, trials, hopeless_above, closest)) {
    trials.push_back(std::move(pair));
  }
  if (std::isfinite(hopeless_above) || !fitter.affordable()) return;
  judge(fitter, base, trials);
  const auto is_found = [](const Trial& trial) {
    return trial.partner != nullptr && accepted(trial);
  };
  if (std::ranges::any_of(trials, is_found)) return;
  fitter.settle_stems();
  for (Trial& triple : triples_of(fitter, base, trials, std::move(closest))) {
    trials.push_back(std::move(triple));
  }
}

void add_play(const Fitter& fitter, const Fit& base, std::vector<Trial>& trials) {
  try {
    std::vector<Trial> found = play_instead(fitter, base, trials);
    if (found.empty()) return;
    std::ranges::move(found, std::back_inserter(trials));
  } catch (const OutOfTime&) {  // the stem stands as it is
    return;
  }
  judge(fitter, base, trials);
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

// Where there is time to ask.
void name_slip(const Fitter& fitter, Identified& identified, std::vector<Trial>& trials,
               Trial& best) {
  try {
    VerdictOnStems(fitter, identified).name_slip(trials, best);
  } catch (const OutOfTime&) {  // it is listed alone
    return;
  }
}

// What a trial found on the way may serve the smaller model as well; not what fits a
// little better and, for a stem that slips elsewhere, loses step where nothing was
// fitted.
void better_base(const Fitter& fitter, const std::vector<Trial>& trials, Fit& base) {
  constexpr double kLosesStep = 1.1;
  std::vector<std::optional<Fit>> others(trials.size());
  fitter.work().for_each(trials.size(), [&](std::size_t i) {
    const Trial& trial = trials[i];
    if (!trial.fit || !(trial.fit->error < 0.98 * base.error)) return;
    others[i] = fitter.without(*trial.fit, *trial.effect);
  });
  for (std::optional<Fit>& other : others) {
    if (!other || !(other->error < base.error)) continue;
    if (fitter.rmse_on(*other, false) > kLosesStep * fitter.rmse_on(base, false))
      continue;
    base = std::move(*other);
  }
}

// False where the time was up before it was done: what was there stands as it is.
bool in_time(const std::function<void()>& part) {
  try {
    part();
  } catch (const OutOfTime&) {
    return false;
  }
  return true;
}

void heed_verdict(const Fitter& fitter, Identified& identified,
                  std::vector<Trial>& trials) {
  const VerdictOnStems verdict(fitter, identified);
  for (Trial& trial : trials) verdict.refute(trial);
  verdict.confirm(trials);
  verdict.mark(trials);
}

// What was accepted and is not told, for what lies beside it.
void leave_doubtful_open(const Fitter& fitter, const Fit& base, Told told,
                         std::vector<Trial>& trials) {
  leave_untold(told, trials);
  leave_under_loads(fitter, trials);
  leave_fitted_only_open(fitter, base, trials);
  leave_outdone_open(trials);
  leave_untold_values_open(fitter, trials);
  static_cast<void>(in_time([&] { leave_columns_open(fitter, trials); }));
}

// A pair that failed says nothing that its members do not say, but where it leaves far
// less than each of them: then it is what to try. `alone`: percent of the squared error
// that the best single effect takes away.
bool tells_more(const Trial& trial, double alone) {
  constexpr double kFarLess = 0.5;
  if (accepted(trial)) return true;
  return trial.candidate.status == CandidateStatus::kUndecided &&
         100 - trial.candidate.error_reduction_percent < kFarLess * (100 - alone);
}

// What an exploration found, best first, and how the model stands.
void report(const Fitter& fitter, std::vector<Trial>& trials, const Trial* best,
            bool in_time, bool seen, bool blind, Exploration& out) {
  if (best != nullptr) out.best = *best->fit;
  std::stable_sort(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) {
    const int ra = rank(a.candidate);
    const int rb = rank(b.candidate);
    return ra != rb  ? ra < rb
           : ra == 0 ? a.score < b.score
                     : a.candidate.error_reduction_percent >
                           b.candidate.error_reduction_percent;
  });
  double alone = 0;  // the most that one takes away
  for (const Trial& trial : trials) {
    if (trial.partner != nullptr) continue;
    alone = std::max(alone, trial.candidate.error_reduction_percent);
  }
  for (const Trial& trial : trials) {
    if (trial.partner != nullptr && !tells_more(trial, alone)) continue;
    out.result.candidates.push_back(trial.candidate);
  }
  out.result.rmse = fitter.rmse(out.base);
  out.result.rmse_validation = fitter.rmse_on(out.base, false);
  out.result.quality = quality(fitter, out.base);
  const double following =
      seen ? share_following_u(out.base.residual, fitter.recording().u) : 0;
  out.result.noise_rmse = std::sqrt(
      colour_of(without_glitches(out.base.residual)).variance * (1 - following));
  const bool in_doubt = std::any_of(trials.begin(), trials.end(), [](const Trial& trial) {
    return trial.candidate.status == CandidateStatus::kUndecided &&
           trial.candidate.error_reduction_percent > kDoubtfulPercent;
  });
  out.result.complete = in_time;
  out.result.left_to_controller = blind;
  out.result.explained = best == nullptr && in_time && !in_doubt && !blind &&
                         is_noise(out.base.residual) && following < kHardlyAny;
}

}  // namespace

Exploration explore(const Fitter& fitter, const Fit& start, const Catalogue& catalogue,
                    Identified& identified, const ExplainProgress& progress,
                    double hopeless_above) {
  Exploration out;
  out.base = start;
  fitter.settle_stems();
  const Told told = told_between(fitter, start, identified);
  const bool blind = told == Told::kNothing || told == Told::kLoads;
  std::vector<Trial> trials =
      screen(fitter, out.base, catalogue, progress, hopeless_above, blind);
  static_cast<void>(in_time([&] { better_base(fitter, trials, out.base); }));
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
  judge(fitter, out.base, trials);
  // A white residual has no room for two effects that need each other; and where the best
  // one leaves little but noise, a second one waits for its turn.
  const auto leaves_noise = [](const Trial& trial) {
    return accepted(trial) && is_noise(trial.fit->residual);
  };
  if (!last && fitter.affordable() &&
      std::none_of(trials.begin(), trials.end(), leaves_noise) &&
      !is_white(out.base.residual)) {
    static_cast<void>(
        in_time([&] { add_together(fitter, out.base, hopeless_above, trials); }));
    judge(fitter, out.base, trials);
  }
  if (!last) add_play(fitter, out.base, trials);
  end_in_time();
  if (!last && !in_time([&] { heed_verdict(fitter, identified, trials); })) end_in_time();
  leave_doubtful_open(fitter, out.base, told, trials);
  Trial* best = choose(fitter, trials);
  const bool all = !std::isfinite(hopeless_above) && fitter.affordable();
  if (!last && best == nullptr && all &&
      !in_time([&] { best = tell_ahead(fitter, out.base, trials); })) {
    end_in_time();
  }
  if (!last && best != nullptr) name_slip(fitter, identified, trials, *best);
  report(fitter, trials, best, !last, seen, blind, out);
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
  if (stands_in(fitter, *without, fit) || shows_itself(fitter, fit, *without, effect)) {
    return true;
  }
  if (untold_instant_s(fitter, fit, effect) > 0) return false;
  const DifferenceTest test =
      test_difference(without->residual, fit.residual, fitter.blocks());
  return test.p_value < kAsLikely &&
         fitter.rmse_on(fit, false) < fitter.rmse_on(*without, false);
}

}  // namespace workbench
