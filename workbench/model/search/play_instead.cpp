#include "workbench/model/search/play_instead.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "workbench/effects/effects.hpp"
#include "workbench/model/judge/merit.hpp"
#include "workbench/model/search/triples.hpp"

namespace workbench {
namespace {

// The accepted one with stiction that leaves least; null without one.
const Trial* closest_stuck(const std::vector<Trial>& trials) {
  const Trial* closest = nullptr;
  for (const Trial& trial : trials) {
    const auto members = members_of(trial);
    if (!accepted(trial) || trial.third != nullptr ||
        std::ranges::count(members, &effects::valve_stiction()) == 0 ||
        std::ranges::count(members, &effects::valve_backlash()) > 0) {
      continue;
    }
    if (closest == nullptr || fits_better(&trial, closest)) closest = &trial;
  }
  return closest;
}

// `base` with play, with what else `stuck` has, and with `behind`.
std::optional<Fit> with_play(const Fitter& fitter, const Fit& base, const Trial& stuck,
                             const Effect& behind) {
  std::optional<Fit> fit =
      fitter.extend(base, effects::valve_backlash(), Effort::kScreen);
  std::vector<const Effect*> others = members_of(stuck);
  std::erase(others, &effects::valve_stiction());
  others.push_back(&behind);
  for (const Effect* other : others) {
    if (fit) fit = fitter.extend(*fit, *other, Effort::kScreen);
  }
  return fit;
}

Trial trial_of(Fit fit, const Fit& base) {
  std::vector<const Effect*> members;
  for (const Effect* effect : fit.effects) {
    if (!contains(base.effects, *effect)) members.push_back(effect);
  }
  std::ranges::stable_sort(
      members, {}, [](const Effect* effect) { return effect->description().place; });
  Trial out;
  out.effect = members[0];
  out.partner = members[1];
  out.third = members.size() > 2 ? members[2] : nullptr;
  out.fit = std::move(fit);
  return out;
}

}  // namespace

std::vector<Trial> play_instead(const Fitter& fitter, const Fit& base,
                                const std::vector<Trial>& trials) {
  const Trial* stuck = closest_stuck(trials);
  if (stuck == nullptr || contains(base.effects, effects::valve_backlash())) return {};
  std::optional<Fit> least;
  const Effect* slow = nullptr;  // what is behind the play of `least`
  for (const Effect* behind :
       {&effects::process_dead_time(), &effects::process_second_lag()}) {
    if (contains(stuck->fit->effects, *behind)) continue;
    std::optional<Fit> fit = with_play(fitter, base, *stuck, *behind);
    if (!fit || (least && fit->error >= least->error)) continue;
    least = std::move(fit);
    slow = behind;
  }
  if (!least) return {};
  Trial play = trial_of(fitter.reconsider(fitter.refine(*least), nullptr), base);
  const NoiseColour colour = colour_of(play.fit->residual);
  const auto scores_better = [&](const Fit& other) {
    return score_of(*play.fit, colour) < score_of(other, colour);
  };
  if (!scores_better(*stuck->fit)) return {};
  const auto both = fitter.extend(*stuck->fit, *slow, Effort::kScreen);
  if (both && !scores_better(*both)) return {};
  examine(fitter, base, play);
  play.visible = u_is_seen(fitter, *play.fit);
  std::vector<Trial> out;
  if (each_is_needed(fitter, play)) out.push_back(std::move(play));
  return out;
}

}  // namespace workbench
