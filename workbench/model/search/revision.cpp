#include "workbench/model/search/revision.hpp"

#include <algorithm>
#include <utility>

#include "workbench/model/judge/intervals.hpp"
#include "workbench/model/judge/merit.hpp"
#include "workbench/model/judge/off_profile.hpp"
#include "workbench/model/judge/rivals.hpp"
#include "workbench/model/search/candidates.hpp"

namespace workbench {
namespace {

constexpr double kMost = 4;        // times the error without an effect
constexpr double kAnew = 0.98;     // of the error, for the same effects to be taken anew
constexpr double kPreferred = 10;  // of the score; a parameter costs seven
constexpr std::size_t kPursued = 2;      // of the effects tried in place of two
constexpr std::size_t kMostSwapped = 3;  // effects, for look-alikes to be tried

const NoiseColour kWhite;

// A ladder does not end on a step that does plainly worse where nothing was fitted,
// though in a short recording that may be chance.
bool judges_worse(const Fitter& fitter, const Fit& next, const Fit& than) {
  constexpr double kPlainly = 1.1;
  return fitter.rmse_on(next, false) > kPlainly * fitter.rmse_on(than, false);
}

// Less one effect: from where it is and, where that is too little, from scratch.
Fit rest_of(const Fitter& fitter, const Fit& fit, const Effect& effect) {
  Fit rest = fitter.without(fit, effect);
  if (!lowers_error(fitter, rest, fit)) return rest;
  auto anew = fitter.start_if(rest.effects);
  return anew && anew->error < rest.error ? in_order(std::move(*anew), rest.effects)
                                          : rest;
}

std::optional<Revision> replacement(const Fitter& fitter, const Fit& fit, const Fit& rest,
                                    const Effect& effect, const Catalogue& catalogue,
                                    Identified& identified) {
  constexpr double kHopeless = 2;  // of the error to be beaten
  Exploration found = explore(fitter, rest, catalogue.without(effect), identified, {},
                              kHopeless * fit.error);
  if (!found.best) return std::nullopt;
  const Candidate& best = *found.result.best();
  Revision out{{&effect}, rest, {}, best.indistinguishable_from, std::move(*found.best)};
  out.added.push_back(catalogue.find(best.effect));
  for (const std::string& code : best.with) out.added.push_back(catalogue.find(code));
  return out;
}

// True where what was found is that effect, and not only something that looks like it.
bool is_itself(const Fitter& fitter, const Fit& fit, const FitIntervals& intervals,
               const Effect& effect) {
  return is_possible(fitter, fit, effect) && excludes_off(fitter, fit, intervals, effect);
}

// `rest` with the effect of `choice` that leaves least, searched to the end.
std::optional<Fit> best_beside(const Fitter& fitter, const Fit& rest,
                               const std::vector<const Effect*>& choice) {
  std::vector<Fit> fits;
  for (const Effect* effect : choice) {
    if (auto next = fitter.extend(rest, *effect, Effort::kScreen)) {
      fits.push_back(std::move(*next));
    }
  }
  const std::size_t count = std::min(kPursued, fits.size());
  std::partial_sort(fits.begin(), fits.begin() + static_cast<std::ptrdiff_t>(count),
                    fits.end(),
                    [](const Fit& a, const Fit& b) { return a.error < b.error; });
  std::optional<Fit> best;
  for (std::size_t i = 0; i < count; ++i) {
    Fit next = fitter.reconsider(fitter.refine(fits[i]), nullptr);
    if (!best || next.error < best->error) best = std::move(next);
  }
  return best;
}

// One effect instead of two of `fit`, with an error that `measure` hardly beats.
std::optional<Fit> with_fewer(const Fitter& fitter, const Fit& fit, const Fit& measure,
                              const std::vector<const Effect*>& given,
                              const Catalogue& catalogue) {
  std::vector<const Effect*> choice;
  for (const Effect* effect : catalogue.effects()) {
    if (!contains(fit.effects, *effect)) choice.push_back(effect);
  }
  std::optional<Fit> best;
  for (const Effect* one : fit.effects) {
    for (const Effect* two : fit.effects) {
      if (two == one) break;
      if (contains(given, *one) || contains(given, *two) || !fitter.affordable())
        continue;
      const Fit rest = fitter.without(fitter.without(fit, *one), *two);
      auto next = best_beside(fitter, rest, choice);
      if (!next || lowers_error(fitter, *next, measure) ||
          judges_worse(fitter, *next, measure)) {
        continue;
      }
      if (best && best->error < next->error) continue;
      const Effect& newest = *next->effects.back();
      if (is_itself(fitter, *next, thorough_intervals_of(fitter, *next), newest)) {
        best = std::move(next);
      }
    }
  }
  return best;
}

// Two effects often stand for one that differs from both, and what the rest are may only
// show then.
std::optional<Fit> fewer(const Fitter& fitter, const Fit& fit,
                         const std::vector<const Effect*>& given,
                         const Catalogue& catalogue) {
  if (fit.effects.size() < 3) return std::nullopt;
  if (auto next = with_fewer(fitter, fit, fit, given, catalogue)) return next;
  if (fit.effects.size() > kMostSwapped) return std::nullopt;
  for (const Effect* effect : fit.effects) {
    if (contains(given, *effect)) continue;
    const Fit rest = fitter.without(fit, *effect);
    for (const Effect* other : catalogue.effects()) {
      if (other->description().view != effect->description().view) continue;
      const auto swapped = replaced(fitter, fit, rest, *other);
      if (!swapped) continue;
      if (auto next = with_fewer(fitter, *swapped, fit, given, catalogue)) return next;
    }
  }
  return std::nullopt;
}

Revision difference(const Fitter& fitter, const Fit& fit, Fit next) {
  Revision out;
  Fit between = fit;
  for (const Effect* effect : fit.effects) {
    if (contains(next.effects, *effect)) continue;
    out.removed.push_back(effect);
    between = fitter.without(between, *effect);
  }
  for (const Effect* effect : next.effects) {
    if (!contains(fit.effects, *effect)) out.added.push_back(effect);
  }
  out.between = std::move(between);
  out.fit = std::move(next);
  return out;
}

}  // namespace

std::optional<Revision> revised(const Fitter& fitter, const Fit& fit,
                                const std::vector<const Effect*>& given,
                                const Catalogue& catalogue, Identified& identified) {
  if (fit.effects.size() < 2 || !fitter.affordable()) return std::nullopt;
  auto anew = fitter.start_if(fit.effects);
  if (anew && anew->error < kAnew * fit.error) {
    return Revision{.fit = in_order(std::move(*anew), fit.effects)};
  }
  std::optional<Revision> best;
  std::vector<const Effect*> chosen;
  std::vector<Fit> rests;
  const FitIntervals intervals = thorough_intervals_of(fitter, fit);
  double least = score_of(fit, kWhite) - kPreferred;
  for (const Effect* effect : fit.effects) {
    if (contains(given, *effect)) continue;
    chosen.push_back(effect);
    rests.push_back(rest_of(fitter, fit, *effect));
    const bool missed = lowers_error(fitter, rests.back(), fit) ||
                        stands_in(fitter, rests.back(), fit) ||
                        shows_itself(fitter, fit, rests.back(), *effect);
    // (W16) What stands for something else makes room for it, unless for nearly all.
    const bool stands_for_most = missed && rests.back().error > kMost * fit.error;
    if (!missed || (!stands_for_most && !is_itself(fitter, fit, intervals, *effect))) {
      return Revision{.removed = {effect}, .fit = std::move(rests.back())};
    }
  }
  if (auto next = fewer(fitter, fit, given, catalogue)) {
    Revision out = difference(fitter, fit, std::move(*next));
    if (out.added.size() == 1) {
      out.indistinguishable_from =
          rivals_of(fitter, out.fit, *out.added.front(), catalogue);
    }
    return out;
  }
  // What leaves white noise cannot be beaten by what kPreferred asks for.
  if (is_white(fit.residual) || !fitter.affordable()) return std::nullopt;
  std::vector<std::optional<Revision>> others(rests.size());
  fitter.work().for_each(others.size(), [&](std::size_t i) {
    others[i] = replacement(fitter, fit, rests[i], *chosen[i], catalogue, identified);
  });
  for (std::optional<Revision>& other : others) {
    if (!other) continue;
    const double score = score_of(other->fit, kWhite);
    const NoiseColour colour = colour_of(other->fit.residual);
    if (score > least || score_of(other->fit, colour) > score_of(fit, colour) ||
        judges_worse(fitter, other->fit, fit)) {
      continue;
    }
    least = score;
    best = std::move(other);
  }
  return best;
}

}  // namespace workbench
