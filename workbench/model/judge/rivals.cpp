#include "workbench/model/judge/rivals.hpp"

#include <algorithm>

#include "workbench/model/judge/merit.hpp"

namespace workbench {

std::optional<Fit> replaced(const Fitter& fitter, const Fit& fit, const Fit& rest,
                            const Effect& other) {
  constexpr double kNearby = 1.2;  // of the error, to be searched to the end
  const bool has =
      std::find(fit.effects.begin(), fit.effects.end(), &other) != fit.effects.end();
  if (has) return std::nullopt;
  std::optional<Fit> next = fitter.extend(rest, other, Effort::kScreen);
  if (!next || next->error > kNearby * fit.error) return std::nullopt;
  if (!as_good(fitter, *next, fit)) {
    next = fitter.extend(rest, other, Effort::kThorough);
    if (!next || !as_good(fitter, *next, fit)) return std::nullopt;
  }
  const NoiseColour colour = colour_of(fit.residual);
  if (score_of(*next, colour) > score_of(fit, colour) + kTooRich) return std::nullopt;
  if (!is_possible(fitter, *next, other)) return std::nullopt;
  return next;
}

std::vector<std::string> rivals_of(const Fitter& fitter, const Fit& fit,
                                   const Effect& effect, const Catalogue& catalogue) {
  std::vector<std::string> out;
  const Fit rest = fitter.without(fit, effect);
  const auto others = catalogue.effects();
  std::vector<unsigned char> is_rival(others.size(), 0);
  fitter.work().for_each(others.size(), [&](std::size_t i) {
    is_rival[i] = replaced(fitter, fit, rest, *others[i]).has_value();
  });
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (is_rival[i]) out.emplace_back(others[i]->code());
  }
  return out;
}

std::optional<Fit> simplified(const Fitter& fitter, const Fit& fit, const Effect& effect,
                              const Catalogue& catalogue) {
  if (effect.description().place != Place::kFriction) return std::nullopt;
  const Situation here = fitter.situation(fit);
  const Fit rest = fitter.without(fit, effect);
  for (const Effect* other : catalogue.effects()) {
    const bool simpler = other->description().place == Place::kFriction &&
                         other->searched(here).size() < effect.searched(here).size();
    if (!simpler) continue;
    if (auto next = replaced(fitter, fit, rest, *other)) return next;
  }
  return std::nullopt;
}

}  // namespace workbench
