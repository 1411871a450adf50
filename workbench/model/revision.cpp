#include "workbench/model/revision.hpp"

#include <algorithm>
#include <utility>

#include "workbench/model/candidates.hpp"
#include "workbench/model/merit.hpp"

namespace workbench {
namespace {

constexpr double kAnew = 0.98;     // of the error, for the same effects to be taken anew
constexpr double kPreferred = 10;  // of the score; a parameter costs seven

const NoiseColour kWhite;

bool has(const std::vector<const Effect*>& effects, const Effect* one) {
  return std::find(effects.begin(), effects.end(), one) != effects.end();
}

Fit in_order(Fit fit, const std::vector<const Effect*>& effects) {
  fit.effects = effects;
  return fit;
}

// From scratch, or from where it is: the better one.
Fit rest_of(const Fitter& fitter, const Fit& fit, const Effect& effect) {
  Fit rest = fitter.without(fit, effect);
  auto anew = fitter.start_if(rest.effects);
  return anew && anew->error < rest.error ? in_order(std::move(*anew), rest.effects)
                                          : rest;
}

std::optional<Revision> replacement(const Fitter& fitter, const Fit& rest,
                                    const Effect& effect, const Catalogue& catalogue) {
  Exploration found = explore(fitter, rest, catalogue.without(effect));
  if (!found.best) return std::nullopt;
  const Candidate& best = *found.result.best();
  Revision out{&effect, rest, {}, best.indistinguishable_from, std::move(*found.best)};
  out.added.push_back(catalogue.find(best.effect));
  for (const std::string& code : best.with) out.added.push_back(catalogue.find(code));
  return out;
}

}  // namespace

std::optional<Revision> revised(const Fitter& fitter, const Fit& fit,
                                const std::vector<const Effect*>& given,
                                const Catalogue& catalogue) {
  if (fit.effects.size() < 2) return std::nullopt;
  auto anew = fitter.start_if(fit.effects);
  if (anew && anew->error < kAnew * fit.error) {
    return Revision{.fit = in_order(std::move(*anew), fit.effects)};
  }
  std::optional<Revision> best;
  double least = score_of(fit, kWhite) - kPreferred;
  for (const Effect* effect : fit.effects) {
    if (has(given, effect)) continue;
    const Fit rest = rest_of(fitter, fit, *effect);
    if (!lowers_error(fitter, rest, fit)) return Revision{.removed = effect, .fit = rest};
    auto other = replacement(fitter, rest, *effect, catalogue);
    if (!other) continue;
    const double score = score_of(other->fit, kWhite);
    const NoiseColour colour = colour_of(other->fit.residual);
    if (score > least || score_of(other->fit, colour) > score_of(fit, colour)) continue;
    least = score;
    best = std::move(other);
  }
  return best;
}

}  // namespace workbench
