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

// What is accepted beside stiction in `stuck`.
std::vector<const Effect*> others_in(const Trial& stuck) {
  std::vector<const Effect*> others = members_of(stuck);
  std::erase(others, &effects::valve_stiction());
  return others;
}

}  // namespace

std::vector<Trial> play_instead(const Fitter& fitter, const Fit& base,
                                const std::vector<Trial>& trials) {
  const Trial* stuck = closest_stuck(trials);
  if (stuck == nullptr || contains(base.effects, effects::valve_backlash())) return {};
  std::vector<const Effect*> members = others_in(*stuck);
  std::optional<Fit> loose =
      fitter.extend(base, effects::valve_backlash(), Effort::kScreen);
  for (const Effect* other : members) {
    if (loose) loose = fitter.extend(*loose, *other, Effort::kScreen);
  }
  if (!loose) return {};
  std::optional<Fit> least;
  const Effect* slow = nullptr;  // what is behind the play of `least`
  for (const Effect* behind :
       {&effects::process_dead_time(), &effects::process_second_lag()}) {
    if (contains(stuck->fit->effects, *behind)) continue;
    std::optional<Fit> fit = fitter.extend(*loose, *behind, Effort::kScreen);
    if (!fit || (least && fit->error >= least->error)) continue;
    least = std::move(fit);
    slow = behind;
  }
  if (!least) return {};
  members.insert(members.end(), {&effects::valve_backlash(), slow});
  Trial play =
      in_signal_order(members, fitter.reconsider(fitter.refine(*least), nullptr));
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
