#include "workbench/model/search/known_first.hpp"

#include <algorithm>

#include "workbench/effects/effects.hpp"

namespace workbench {
namespace {

void list_first(Trial& trial, const Trial& best) {
  trial.score = std::min(trial.score, best.score - 1e-9);
}

Trial* least_score(std::vector<Trial*> found) {
  const auto least = std::ranges::min_element(
      found, {}, [](const Trial* trial) { return trial->score; });
  return least == found.end() ? nullptr : *least;
}

// (W36) With a recorded load in place of the others that `best` has, and nothing else.
bool is_with_recorded(const Trial& trial, const Trial& best) {
  const std::vector<const Effect*> wanted = members_of(best);
  const std::vector<const Effect*> members = members_of(trial);
  return has_recorded_load(members) &&
         std::ranges::all_of(members, [&wanted](const Effect* member) {
           return member->description().recorded ||
                  std::ranges::count(wanted, member) > 0;
         });
}

}  // namespace

bool is_lone_load_step(const Trial& trial) {
  return trial.partner == nullptr && trial.effect == &effects::disturbance_step();
}

bool is_slow_load(const Effect& effect) {
  const Description& of = effect.description();
  return of.is_unmeasured_load() && of.view == View::kTime;
}

bool has_unknown_cause(const std::vector<const Effect*>& effects) {
  return !has_recorded_load(effects) &&
         std::ranges::any_of(effects, [](const Effect* effect) {
           return effect->description().is_unmeasured_load();
         });
}

Trial* known_first(const Fitter& fitter, std::vector<Trial>& trials, Trial* best) {
  constexpr double kMost = 2;  // of the squared error
  std::vector<Trial*> found;
  for (Trial& trial : trials) {
    if (!accepted(trial)) continue;
    const bool known =
        (is_lone_load_step(*best) && trial.identified) ||
        (has_unknown_cause(members_of(*best)) && is_with_recorded(trial, *best) &&
         share_left(fitter, trial, *best) < kMost);
    if (known) found.push_back(&trial);
  }
  Trial* const known = least_score(std::move(found));
  if (known == nullptr) return best;
  list_first(*known, *best);
  return known;
}

}  // namespace workbench
