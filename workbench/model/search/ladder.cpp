#include "workbench/model/search/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>

#include "workbench/model/base/thinned.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/judge/intervals.hpp"
#include "workbench/model/judge/rivals.hpp"
#include "workbench/model/search/candidates.hpp"
#include "workbench/model/search/revision.hpp"

namespace workbench {
namespace {

constexpr int kMostRevisions = 4;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

const Effect& effect_named(std::string_view code, const Catalogue& catalogue) {
  const Effect* effect = catalogue.find(code);
  if (effect == nullptr) {
    throw std::invalid_argument("no effect '" + std::string(code) +
                                "'; known effects: " + catalogue.codes());
  }
  return *effect;
}

std::vector<const Effect*> effects_named(const std::vector<std::string>& codes,
                                         const Catalogue& catalogue) {
  std::vector<const Effect*> effects;
  for (const std::string& code : codes) {
    const Effect& effect = effect_named(code, catalogue);
    if (std::find(effects.begin(), effects.end(), &effect) != effects.end()) {
      throw std::invalid_argument(code + " is named twice");
    }
    effects.push_back(&effect);
  }
  return effects;
}

std::vector<const Effect*> sorted(std::vector<const Effect*> effects) {
  std::sort(effects.begin(), effects.end(), std::less<>());
  return effects;
}

HistoryStep step_of(const Fitter& fitter, std::string effect, const Fit* before,
                    const Fit& after) {
  return {std::move(effect),
          fitter.recording().name,
          before != nullptr ? fitter.rmse(*before) : kNone,
          fitter.rmse(after),
          before != nullptr ? fitter.rmse_on(*before, false) : kNone,
          fitter.rmse_on(after, false)};
}

// Beside a second effect the first can often be told better, or no longer.
void group_anew(const Fitter& fitter, const Fit& fit,
                const std::vector<const Effect*>& given, const Catalogue& catalogue,
                std::vector<LadderStep>& steps) {
  if (fit.effects.size() < given.size() + 2) return;
  for (const Effect* effect : fit.effects) {
    const auto step = std::find_if(
        steps.rbegin(), steps.rend(),
        [&](const LadderStep& s) { return !s.removed && s.effect == effect->code(); });
    if (step == steps.rend()) continue;
    step->indistinguishable_from = rivals_of(fitter, fit, *effect, catalogue);
  }
}

}  // namespace

FittedModel start_model(const Recording& recording, Column output,
                        const std::vector<std::string>& with, const Catalogue& catalogue,
                        const Work& work) {
  const std::vector<const Effect*> effects = effects_named(with, catalogue);
  const Fitter fitter(recording, output, work);
  const Fit fit = fitter.start(effects);
  FittedModel out{model_of(fitter, fit), quality(fitter, fit)};
  out.model.history.push_back(step_of(fitter, "process", nullptr, fit));
  return out;
}

FittedModel add_effect(const Recording& recording, const Model& model,
                       std::string_view effect, const Catalogue& catalogue,
                       const Work& work) {
  const Effect& added = effect_named(effect, catalogue);
  if (model.has(effect)) {
    throw std::invalid_argument("the model already has " + std::string(effect));
  }
  const Fitter fitter(recording, model.output, work);
  const Fit before = fitter.refine(fitter.apply(model, catalogue));
  const std::optional<Fit> after = fitter.extend(before, added, Effort::kThorough);
  if (!after) {
    throw std::invalid_argument("nothing in " + recording.name + " looks like " +
                                std::string(effect));
  }
  const Fit now = fitter.reconsider(*after, &added);
  FittedModel out{model_of(fitter, now), quality(fitter, now)};
  out.model.history = model.history;
  out.model.history.push_back(step_of(fitter, std::string(effect), &before, now));
  return out;
}

FitQuality quality_of(const Recording& recording, const Model& model,
                      const Catalogue& catalogue) {
  const Fitter fitter(recording, model.output);
  return quality(fitter, fitter.apply(model, catalogue));
}

std::vector<double> simulate_model(const Recording& recording, const Model& model,
                                   const Catalogue& catalogue) {
  const Fitter fitter(recording, model.output);
  return fitter.simulated(fitter.apply(model, catalogue));
}

LadderResult run_ladder(const Recording& recording, const LadderOptions& options) {
  const Catalogue known = options.catalogue->with(recording.loads);
  const Catalogue catalogue = judged_by(recording, known, options.with);
  const std::vector<const Effect*> given = effects_named(options.with, known);
  const Fitter whole(recording, options.output, *options.work);
  const std::size_t thinning = thinning_of(recording.size(), whole.memory_samples());
  const Recording fewer = thinning > 1 ? thinned(recording, thinning) : Recording();
  std::optional<Fitter> quick;
  if (thinning > 1) quick.emplace(fewer, options.output, *options.work);
  const Fitter& fitter = quick ? *quick : whole;
  Fit fit = [&] {
    const Work::WritingDown whatever_it_takes(fitter.work());
    return fitter.start(given);
  }();
  LadderResult out;
  std::vector<HistoryStep> history = {step_of(fitter, "process", nullptr, fit)};
  const auto note = [&](std::string effect, const Fit& now, bool removed,
                        std::vector<std::string> group) {
    out.steps.push_back({std::move(effect), removed, fitter.rmse(now),
                         fitter.rmse_on(now, false), std::move(group)});
  };
  note("process", fit, false, {});
  // From `fit` to `next`, which has `added`, too; `group` is that of a single one.
  const auto add = [&](const std::vector<const Effect*>& added,
                       const std::vector<std::string>& group, Fit next) {
    for (std::size_t i = 0; i < added.size(); ++i) {
      Fit now = next;
      for (std::size_t j = added.size(); j-- > i + 1;) {
        now = fitter.without(now, *added[j]);
      }
      const std::string code(added[i]->code());
      history.push_back(step_of(fitter, code, &fit, now));
      note(code, now, false,
           added.size() == 1 ? group : rivals_of(fitter, next, *added[i], catalogue));
      fit = std::move(now);
    }
  };
  const auto climb = [&] {
    int revisions = 0;
    Catalogue open = catalogue;  // less what was found to be superfluous
    std::vector<std::vector<const Effect*>> seen;
    for (int step = 0;; ++step) {
      seen.push_back(sorted(fit.effects));
      Exploration found = explore(fitter, fit, open, options.progress);
      if (step == 0 && found.base.error < fit.error) {
        history.back() = step_of(fitter, "process", nullptr, found.base);
        out.steps.clear();
        note("process", found.base, false, {});
      }
      fit = std::move(found.base);
      out.last = std::move(found.result);
      if (!found.best || step == options.most_steps || !fitter.affordable()) {
        const bool more = step < options.most_steps && revisions < kMostRevisions;
        std::optional<Revision> second =
            more ? revised(fitter, fit, given, open) : std::nullopt;
        if (!second) break;
        ++revisions;
        for (const Effect* effect : second->removed) {
          if (second->added.empty()) open = open.without(*effect);
          const Fit rest = effect != second->removed.back() ? fitter.without(fit, *effect)
                           : second->between                ? *second->between
                                                            : second->fit;
          const std::string gone(effect->code());
          history.push_back(step_of(fitter, "-" + gone, &fit, rest));
          note(gone, rest, true, {});
          fit = rest;
        }
        if (!second->added.empty()) {
          add(second->added, second->indistinguishable_from, std::move(second->fit));
        } else {
          fit = std::move(second->fit);
        }
        continue;
      }
      const Candidate& best = *out.last.best();
      const Effect& newest = effect_named(best.effect, catalogue);
      Fit next = fitter.reconsider(std::move(*found.best), &newest);
      std::vector<const Effect*> added = {&newest};
      for (const std::string& code : best.with) {
        added.push_back(&effect_named(code, catalogue));
      }
      add(added, best.indistinguishable_from, std::move(next));
      // A later effect may show that an earlier one only looked like it, or an earlier
      // one, reconsidered, that the later one is not there.
      for (std::size_t i = 0; i < fit.effects.size();) {
        const Effect& earlier = *fit.effects[i];
        std::optional<Fit> without;
        const bool chosen =
            std::find(given.begin(), given.end(), &earlier) == given.end();
        if (!chosen || still_needed(fitter, fit, earlier, without)) {
          ++i;
          continue;
        }
        history.push_back(
            step_of(fitter, "-" + std::string(earlier.code()), &fit, *without));
        fit = std::move(*without);
        note(std::string(earlier.code()), fit, true, {});
        // What leads back to where the ladder has been would lead there again.
        const bool back =
            std::find(seen.begin(), seen.end(), sorted(fit.effects)) != seen.end();
        for (const Effect* one : added) {
          if (back) open = open.without(*one);
        }
      }
    }
  };
  const auto settle = [&] {
    const std::vector<const Effect*> effects = fit.effects;
    for (const Effect* effect : effects) {
      if (std::find(given.begin(), given.end(), effect) != given.end()) continue;
      std::optional<Fit> simple = simplified(fitter, fit, *effect, catalogue);
      if (!simple) continue;
      const Fit rest = fitter.without(fit, *effect);
      const std::string instead(simple->effects.back()->code());
      history.push_back(step_of(fitter, "-" + std::string(effect->code()), &fit, rest));
      note(std::string(effect->code()), rest, true, {});
      history.push_back(step_of(fitter, instead, &rest, *simple));
      note(instead, *simple, false, {});
      fit = std::move(*simple);
    }
    group_anew(fitter, fit, given, catalogue, out.steps);
  };
  try {
    climb();
    settle();
  } catch (const OutOfTime&) {
    out.complete = false;
  }
  out.complete = out.complete && out.last.complete && fitter.affordable();
  const Work::WritingDown writing(fitter.work());
  if (quick) {
    Fit all = whole.taken_over(fit);
    history.push_back(step_of(whole, "process", nullptr, all));
    fit = std::move(all);
  }
  out.model = model_of(whole, fit);
  out.model.history = std::move(history);
  out.quality = quality(whole, fit);
  out.explained = out.complete && out.last.explained;
  leave_open(recording, known, catalogue, out.model.effect_codes(), out.last);
  return out;
}

}  // namespace workbench
