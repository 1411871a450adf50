#include "workbench/model/search/ladder.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

#include "workbench/analysis/uncut_parts.hpp"
#include "workbench/model/base/shortened.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/judge/fitted_model.hpp"
#include "workbench/model/judge/rivals.hpp"
#include "workbench/model/search/candidates.hpp"
#include "workbench/model/search/identified.hpp"
#include "workbench/model/search/revision.hpp"
#include "workbench/model/search/step_groups.hpp"

namespace workbench {
namespace {

constexpr int kMostRevisions = 4;

std::vector<const Effect*> sorted(std::vector<const Effect*> effects) {
  std::sort(effects.begin(), effects.end(), std::less<>());
  return effects;
}

}  // namespace

bool takes_back(const LadderStep& next, const LadderStep& step) {
  return !step.removed && next.removed && !next.on_the_way && next.effect == step.effect;
}

namespace {

// The way up: the model as it stands, and what is noted of each step.
class Climb {
 public:
  Climb(const Fitter& fitter, std::vector<const Effect*> given,
        const Catalogue& catalogue, const LadderOptions& options, Identified& identified)
      : fitter_(fitter),
        given_(std::move(given)),
        catalogue_(catalogue),
        open_(catalogue),
        options_(options),
        identified_(identified),
        fit_(start()) {
    begin(fit_);
  }

  // Explains and adds until nothing more is accepted; `stepped` where that led elsewhere.
  void climb(const std::function<void()>& stepped) {
    int revisions = 0;
    for (int step = 0;; ++step) {
      seen_.push_back(sorted(fit_.effects));
      Exploration found = explore(fitter_, fit_, open_, identified_, options_.progress);
      if (step == 0 && found.base.error < fit_.error) begin(found.base);
      fit_ = std::move(found.base);
      last_ = std::move(found.result);
      const bool is_last = !fitter_.affordable() || is_told_ahead(last_);
      if (found.best && step < options_.most_steps) {
        add_best(std::move(*found.best));
        if (is_last) break;
      } else {
        const bool more = step < options_.most_steps && revisions < kMostRevisions;
        std::optional<Revision> second =
            more ? revised(fitter_, fit_, given_, open_, identified_) : std::nullopt;
        if (!second) break;
        ++revisions;
        take(std::move(*second));
      }
      if (sorted(fit_.effects) != seen_.back()) stepped();
    }
  }

  // A simpler effect at the same place, where the data do not miss the rest.
  void settle() {
    if (!fit_.weight.empty()) return;  // what tells it is not the free run
    const std::vector<const Effect*> effects = fit_.effects;
    for (const Effect* effect : effects) {
      if (contains(given_, *effect)) continue;
      std::optional<Fit> simple = simplified(fitter_, fit_, *effect, catalogue_);
      if (!simple) continue;
      const Work::WritingDown whole(fitter_.work());
      const Fit rest = fitter_.without(fit_, *effect);
      std::vector<std::string> group;
      const Effect& newest = *simple->effects.back();
      if (lacks_slip(newest, *effect) && leaves_slip_open(fitter_, *simple, fit_)) {
        group.emplace_back(effect->code());
      }
      const std::string instead(newest.code());
      remove(*effect, rest);
      steps_.back().on_the_way = true;
      history_.push_back(step_of(fitter_, instead, &rest, *simple));
      note(instead, *simple, false, std::move(group));
      fit_ = std::move(*simple);
    }
    group_anew(fitter_, fit_, given_, catalogue_, steps_);
  }

  [[nodiscard]] const Fit& fit() const { return fit_; }
  [[nodiscard]] const ExplainResult& last() const { return last_; }
  [[nodiscard]] const std::vector<LadderStep>& steps() const { return steps_; }
  [[nodiscard]] const std::vector<HistoryStep>& history() const { return history_; }

 private:
  [[nodiscard]] Fit start() const {
    const Work::WritingDown whatever_it_takes(fitter_.work());
    return fitter_.start(given_);
  }
  void begin(const Fit& fit) {
    history_.assign(1, step_of(fitter_, "process", nullptr, fit));
    steps_.clear();
    note("process", fit, false, {});
  }
  void note(std::string effect, const Fit& now, bool removed,
            std::vector<std::string> group) {
    steps_.push_back({std::move(effect), removed, false, fitter_.rmse(now),
                      fitter_.rmse_on(now, false), std::move(group)});
  }
  // On to `rest`, which lacks `effect`.
  void remove(const Effect& effect, Fit rest) {
    const std::string gone(effect.code());
    history_.push_back(step_of(fitter_, "-" + gone, &fit_, rest));
    note(gone, rest, true, {});
    fit_ = std::move(rest);
  }
  // On to `next`, which has `added`, too; `group` is that of a single one. Of several
  // that one comes first which would be missed most, and loads that nobody measured last.
  void add(std::vector<const Effect*> added, const std::vector<std::string>& group,
           const Fit& next) {
    if (added.size() > 1) {
      std::map<const Effect*, double> left;
      for (const Effect* one : added) left[one] = left_without(next, *one);
      const auto key = [&left](const Effect* one) {
        return std::pair(one->description().is_unmeasured_load(), -left[one]);
      };
      std::ranges::stable_sort(added, {}, key);
    }
    for (std::size_t i = 0; i < added.size(); ++i) {
      Fit now = next;
      for (std::size_t j = added.size(); j-- > i + 1;) {
        now = fitter_.without(now, *added[j]);
      }
      const std::string code(added[i]->code());
      history_.push_back(step_of(fitter_, code, &fit_, now));
      note(code, now, false,
           added.size() == 1 ? group : rivals_of(fitter_, next, *added[i], catalogue_));
      // What only helps together is told as one step.
      steps_.back().on_the_way = i + 1 < added.size() && fitter_.rmse_on(now, false) >
                                                             fitter_.rmse_on(fit_, false);
      fit_ = std::move(now);
    }
  }

  [[nodiscard]] static bool is_told_ahead(const ExplainResult& found) {
    return found.best() != nullptr && found.best()->ahead;
  }
  // Beside what only one sample ahead tells, nothing more is told by the free run: it is
  // the last step, and as it was found.
  void add_told_ahead(Fit found) {
    const Candidate best = *last_.best();
    history_.push_back(step_of(fitter_, best.effect, &fit_, found));
    note(best.effect, found, false, best.indistinguishable_from);
    steps_.back().ahead = history_.back().ahead = best.ahead;
    fit_ = std::move(found);
    std::erase_if(last_.candidates, [&best](const Candidate& c) {
      return c.effect == best.effect && c.with.empty();
    });
    last_.rmse = fitter_.rmse(fit_);
    last_.rmse_validation = fitter_.rmse_on(fit_, false);
  }

  void add_best(Fit found) {
    if (is_told_ahead(last_)) return add_told_ahead(std::move(found));
    const auto steps = static_cast<std::ptrdiff_t>(steps_.size());
    const auto history = static_cast<std::ptrdiff_t>(history_.size());
    const Candidate& best = *last_.best();
    const Effect& newest = effect_named(best.effect, catalogue_);
    const Fit next = fitter_.reconsider(std::move(found), &newest);
    std::vector<const Effect*> added = {&newest};
    for (const std::string& code : best.with) {
      added.push_back(&effect_named(code, catalogue_));
    }
    add(added, best.indistinguishable_from, next);
    drop_superfluous(added);
    // That an effect came and went is told once.
    if (came_and_went(steps) && was_removed(steps, steps_.back().effect)) {
      steps_.erase(steps_.begin() + steps, steps_.end());
      history_.erase(history_.begin() + history, history_.end());
    }
  }
  [[nodiscard]] double left_without(const Fit& fit, const Effect& effect) const {
    return fitter_.rmse_on(fitter_.without(fit, effect), false);
  }
  [[nodiscard]] bool came_and_went(std::ptrdiff_t from) const {
    const auto first = steps_.begin() + from;
    return steps_.end() - first == 2 && takes_back(first[1], first[0]);
  }
  [[nodiscard]] bool was_removed(std::ptrdiff_t before, const std::string& effect) const {
    return std::any_of(
        steps_.begin(), steps_.begin() + before,
        [&](const LadderStep& step) { return step.removed && step.effect == effect; });
  }

  // A later effect may show that an earlier one only looked like it, or an earlier one,
  // reconsidered, that the later one is not there.
  void drop_superfluous(const std::vector<const Effect*>& added) {
    bool new_ground = !has_been_here();
    for (std::size_t i = 0; i < fit_.effects.size();) {
      const Effect& earlier = *fit_.effects[i];
      std::optional<Fit> without;
      if (contains(given_, earlier) || still_needed(fitter_, fit_, earlier, without)) {
        ++i;
        continue;
      }
      remove(earlier, std::move(*without));
      // What leads back to where the ladder has been would lead there again.
      const bool back = has_been_here();
      for (const Effect* one : added) {
        if (back) open_ = open_.without(*one);
      }
      new_ground = new_ground && !back;
    }
    // What was superfluous without the newest effect need not be so beside it.
    if (new_ground) open_ = catalogue_;
  }

  [[nodiscard]] bool has_been_here() const {
    return std::find(seen_.begin(), seen_.end(), sorted(fit_.effects)) != seen_.end();
  }

  // Whole or not at all: what it takes away would be missed without what it adds.
  void take(Revision second) {
    const Work::WritingDown whole(fitter_.work());
    const std::size_t from = steps_.size();
    for (const Effect* effect : second.removed) {
      if (second.added.empty()) open_ = open_.without(*effect);
      remove(*effect, effect != second.removed.back() ? fitter_.without(fit_, *effect)
                      : second.between                ? *second.between
                                                      : second.fit);
    }
    if (second.added.empty()) {
      fit_ = std::move(second.fit);
    } else {
      add(second.added, second.indistinguishable_from, second.fit);
      for (std::size_t i = from; i + 1 < steps_.size(); ++i) steps_[i].on_the_way = true;
    }
  }

  const Fitter& fitter_;
  const std::vector<const Effect*> given_;
  const Catalogue& catalogue_;
  Catalogue open_;  // less what was found to be superfluous
  const LadderOptions& options_;
  Identified& identified_;
  Fit fit_;
  ExplainResult last_;
  std::vector<LadderStep> steps_;
  std::vector<HistoryStep> history_;
  std::vector<std::vector<const Effect*>> seen_;
};

}  // namespace

LadderResult run_ladder(const Recording& recording, const LadderOptions& options) {
  const Catalogue known = options.catalogue->with(recording.loads);
  const Catalogue catalogue = judged_by(recording, known, options.with);
  const std::vector<const Effect*> given = effects_named(options.with, known);
  const Fitter whole(recording, options.output, *options.work);
  std::optional<Shortened> fewer;
  std::optional<Fitter> quick;
  if (is_long(recording)) {
    fewer = shortened(recording, options.output);
    quick.emplace(fewer->recording, options.output, *options.work);
  }
  const Fitter& fitter = quick ? *quick : whole;
  std::optional<Identified> own;
  Identified& identified = options.identified != nullptr
                               ? *options.identified
                               : own.emplace(uncut_parts(recording));
  Climb way(fitter, given, catalogue, options, identified);
  LadderResult out;
  const auto fit_so_far = [&] {
    return quick ? whole.on_the_whole(way.fit(), *fewer) : way.fit();
  };
  const auto model_so_far = [&](const Fit& fit) {
    Model model = model_of(whole, fit);
    model.history = way.history();
    if (!quick) return model;
    // The errors of a part are no measure for those of the whole.
    if (model.history.size() == 1) model.history.clear();
    for (HistoryStep& step : model.history) step.recording += " in part";
    model.history.push_back(step_of(whole, "process", nullptr, fit));
    return model;
  };
  try {
    way.climb([&] {
      if (options.stepped) options.stepped(model_so_far(fit_so_far()), way.last());
    });
    way.settle();
  } catch (const OutOfTime&) {
    out.complete = false;
  }
  out.steps = way.steps();
  out.last = way.last();
  // Where only noise is left, what was too dear would have found nothing.
  out.complete =
      out.complete && out.last.complete && (fitter.affordable() || out.last.explained);
  const Work::WritingDown writing(fitter.work());
  const Fit fit = fit_so_far();
  if (quick) out.searched = searched_in(*fewer, *quick);
  out.model = model_so_far(fit);
  out.quality = quality(whole, fit);
  out.explained = out.complete && out.last.explained;
  leave_rivals_open(out.steps, out.model, catalogue, out.last.candidates);
  leave_open(recording, known, catalogue, out.model.effect_codes(), out.last);
  return out;
}

}  // namespace workbench
