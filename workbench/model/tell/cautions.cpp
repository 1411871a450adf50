#include "workbench/model/tell/cautions.hpp"

#include <algorithm>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/base/controller_law.hpp"
#include "workbench/model/base/joined.hpp"
#include "workbench/recording/filled.hpp"

namespace workbench {
namespace {

bool rests(const std::vector<double>& setpoint) {
  return !setpoint.empty() && std::ranges::count(setpoint, setpoint.front()) ==
                                  static_cast<std::ptrdiff_t>(setpoint.size());
}

}  // namespace

bool says_hardly_anything(double fit_percent) {
  constexpr double kLeast = 5;  // %, a tenth of the squared error
  return fit_percent < kLeast;
}

bool may_lack_gain(const Model& model) {
  const Parameter* gain = find(model.process, "gain");
  return gain != nullptr && gain->low < gain->high && gain->low <= 0 && gain->high >= 0;
}

bool tells_nothing(const Model& model, const FitQuality& quality) {
  return says_hardly_anything(quality.fit_percent) ||
         (may_lack_gain(model) && !quality.output_follows_u);
}

bool is_beside_the_point(const Candidate& best) {
  constexpr double kHardlyAnyPercent = 5;
  const Effect* effect = standard_catalogue().find(best.effect);
  return best.with.empty() && effect->description().place == Place::kRecord &&
         best.error_reduction_percent < kHardlyAnyPercent;
}

bool is_left_to_controller(const Model& model, const Recording& recording) {
  const Catalogue catalogue = standard_catalogue().with(recording.loads);
  const bool has_other_cause =
      std::ranges::any_of(model.effects, [&catalogue](const EffectTerm& term) {
        const Effect* effect = catalogue.find(term.effect);
        return effect != nullptr &&
               (effect->description().is_stem() || effect->description().recorded);
      });
  if (model.output != Column::y || has_other_cause) return false;
  return follows_law(law_share(recording.u, recording.y, parts_of(recording).pieces));
}

// Where u rises with y under a constant setpoint, a gain above 0 would take it farther.
bool would_run_away(const Model& model, const Recording& recording) {
  constexpr double kMuch = 0.5;   // of the level of u
  constexpr double kSome = 0.25;  // of its changes
  const Parameter* gain = find(model.process, "gain");
  if (model.output != Column::y || gain == nullptr || may_lack_gain(model) ||
      !rests(recording.sp)) {
    return false;
  }
  const LawShare law = law_share(recording.u, recording.y, parts_of(recording).pieces);
  return law.of_level > kMuch && law.of_changes > kSome && !law.leads &&
         law.slope * gain->value > 0;
}

std::vector<std::string> cautions(const Model& model, const Recording& recording,
                                  const FitQuality& quality, bool left_to_controller) {
  constexpr double kAtBound = 0.99;
  if (left_to_controller) {
    return {
        "Little but the controller moves u in this recording. Unless the valve itself "
        "makes the loop cycle, what the process makes of u is not told from what the "
        "controller makes of y, and this model may be that of the controller: change the "
        "setpoint a few times, or move u by hand."};
  }
  if (says_hardly_anything(quality.fit_percent)) {
    return {
        "From u alone the model says hardly more about the output than a constant would: "
        "it lacks something large, or u is not the column that moves the output."};
  }
  if (may_lack_gain(model)) {
    if (quality.output_follows_u) {
      return {
          "The interval of the gain holds 0 although the output follows u: the gain is "
          "told only together with the other parameters. Use the model as a whole, not "
          "that number."};
    }
    return {
        "The interval of the gain holds 0: how far the output follows u, if at all, is "
        "not told. Move u further, or give the column that moves the output."};
  }
  if (would_run_away(model, recording)) {
    return {
        "With a gain of this sign the controller of this recording would drive the "
        "process away from its setpoint: the model may be that of the controller turned "
        "round, or lack a dead time. Change the setpoint a few times, or move u by "
        "hand."};
  }
  const Parameter* lag = find(model.process, "first_lag");
  if (lag == nullptr || lag->value < kAtBound * lag->bound_high) return {};
  return {filled(
      "The first lag is as long as the recording: the process may be slower still, or "
      "never settle ({0}).",
      {"process.integrating"})};
}

}  // namespace workbench
