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

// Play with `others`, and behind it `slow`, where that is told from `stuck`.
std::optional<Trial> play_with(const Fitter& fitter, const Fit& base, const Trial& stuck,
                               std::vector<const Effect*> others, const Effect& slow,
                               const Fit& found) {
  others.insert(others.end(), {&effects::valve_backlash(), &slow});
  Trial play = in_told_order(others, fitter.reconsider(fitter.refine(found), nullptr));
  const NoiseColour colour = colour_of(play.fit->residual);
  const auto scores_better = [&](const Fit& other) {
    return score_of(*play.fit, colour) < score_of(other, colour);
  };
  if (!scores_better(*stuck.fit)) return std::nullopt;
  const auto both = fitter.extend(*stuck.fit, slow, Effort::kScreen);
  if (both && !scores_better(*both)) return std::nullopt;
  examine(fitter, base, play);
  play.visible = u_is_seen(fitter, *play.fit);
  if (!each_is_needed(fitter, play)) return std::nullopt;
  return play;
}

}  // namespace

std::vector<Trial> play_instead(const Fitter& fitter, const Fit& base,
                                const std::vector<Trial>& trials) {
  const Trial* stuck = closest_stuck(trials);
  if (stuck == nullptr || contains(base.effects, effects::valve_backlash())) return {};
  const std::vector<const Effect*> others = others_in(*stuck);
  std::optional<Fit> loose =
      fitter.extend(base, effects::valve_backlash(), Effort::kScreen);
  for (const Effect* other : others) {
    if (loose) loose = fitter.extend(*loose, *other, Effort::kScreen);
  }
  if (!loose) return {};
  std::vector<std::pair<const Effect*, Fit>> found;
  for (const Effect* slow :
       {&effects::process_dead_time(), &effects::process_second_lag(),
        &effects::process_integrating()}) {
    if (contains(stuck->fit->effects, *slow)) continue;
    std::optional<Fit> fit = fitter.extend(*loose, *slow, Effort::kScreen);
    if (fit) found.emplace_back(slow, std::move(*fit));
  }
  std::ranges::stable_sort(found, {},
                           [](const auto& behind) { return behind.second.error; });
  for (const auto& [slow, fit] : found) {
    std::optional<Trial> play = play_with(fitter, base, *stuck, others, *slow, fit);
    if (play) return {std::move(*play)};
  }
  return {};
}

}  // namespace workbench
