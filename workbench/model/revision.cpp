#include "workbench/model/revision.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "workbench/model/candidates.hpp"
#include "workbench/model/least_squares.hpp"
#include "workbench/model/noise.hpp"

namespace workbench {
namespace {

constexpr double kSame = 0.01;     // p-value above which nothing is missed
constexpr double kAnew = 0.98;     // of the error, for the same effects to be taken anew
constexpr double kPreferred = 10;  // of the score; a parameter costs seven

const NoiseColour kWhite;

std::vector<const Effect*> less(const std::vector<const Effect*>& effects,
                                const Effect* one) {
  std::vector<const Effect*> out;
  for (const Effect* effect : effects) {
    if (effect != one) out.push_back(effect);
  }
  return out;
}

bool has(const std::vector<const Effect*>& effects, const Effect* one) {
  return std::find(effects.begin(), effects.end(), one) != effects.end();
}

// Schwarz's criterion over all samples.
double score_of(const Fit& fit, const NoiseColour& colour) {
  const std::vector<double> e = whitened(colour, fit.residual);
  const auto n = static_cast<double>(e.size());
  return n * std::log(std::max(dot(e, e) / n, 1e-300)) +
         static_cast<double>(fit.parameters()) * std::log(n);
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

bool missed(const Fitter& fitter, const Fit& rest, const Fit& fit) {
  const double before = fitter.rmse_on(rest, false);
  const double after = fitter.rmse_on(fit, false);
  return after * after < (1 - kLeastMissed) * before * before &&
         test_difference(rest.residual, fit.residual, fitter.blocks()).p_value < kSame;
}

std::optional<Revision> replacement(const Fitter& fitter, const Fit& rest,
                                    const Effect& effect, const Catalogue& catalogue) {
  Exploration found =
      explore(fitter, rest, Catalogue(less(catalogue.effects(), &effect)));
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
    if (!missed(fitter, rest, fit)) return Revision{.removed = effect, .fit = rest};
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
