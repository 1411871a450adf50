#include "workbench/model/rivals.hpp"

#include <algorithm>

#include "workbench/model/merit.hpp"

namespace workbench {
namespace {

// `fit` with `other` for `effect`, where that is as good.
std::optional<Fit> replaced(const Fitter& fitter, const Fit& fit, const Effect& effect,
                            const Effect& other, Effort effort) {
  const bool has =
      std::find(fit.effects.begin(), fit.effects.end(), &other) != fit.effects.end();
  if (has) return std::nullopt;
  std::optional<Fit> next = fitter.extend(fitter.without(fit, effect), other, effort);
  if (!next) return std::nullopt;
  return as_good(fitter, *next, fit) ? std::move(next) : std::nullopt;
}

}  // namespace

std::vector<std::string> rivals_of(const Fitter& fitter, const Fit& fit,
                                   const Effect& effect, const Catalogue& catalogue,
                                   const std::vector<std::string>& also) {
  std::vector<std::string> out;
  for (const Effect* other : catalogue.effects()) {
    const bool asked = other->description().view == effect.description().view ||
                       std::find(also.begin(), also.end(), other->code()) != also.end();
    if (!asked) continue;
    if (replaced(fitter, fit, effect, *other, Effort::kThorough)) {
      out.emplace_back(other->code());
    }
  }
  return out;
}

std::optional<Fit> simplified(const Fitter& fitter, const Fit& fit, const Effect& effect,
                              const Catalogue& catalogue) {
  const Situation here = fitter.situation(fit);
  for (const Effect* other : catalogue.effects()) {
    const bool simpler = other->description().place == Place::kFriction &&
                         effect.description().place == Place::kFriction &&
                         other->searched(here).size() < effect.searched(here).size();
    if (!simpler) continue;
    if (auto next = replaced(fitter, fit, effect, *other, Effort::kThorough)) return next;
  }
  return std::nullopt;
}

}  // namespace workbench
