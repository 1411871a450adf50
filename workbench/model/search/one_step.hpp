// A model from the start, and with one effect more or less.
//
// Throws as the ladder does (ladder.hpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/base/model.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/judge/quality.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// The effect of that code, or of what somebody may have meant by it. Throws
/// std::invalid_argument where there is none.
[[nodiscard]] const Effect& effect_named(std::string_view code,
                                         const Catalogue& catalogue);

/// Those of the codes. Throws the same, and where one is named twice.
[[nodiscard]] std::vector<const Effect*> effects_named(
    const std::vector<std::string>& codes, const Catalogue& catalogue);

/// What `effect` did to the errors; `before` null: it is the start.
[[nodiscard]] HistoryStep step_of(const Fitter& fitter, std::string effect,
                                  const Fit* before, const Fit& after);

/// A model with its effects, fitted to the estimation blocks of the recording.
struct FittedModel {
  Model model;
  FitQuality quality;
};

/// First-order process, linear valve, no dead time, and the effects of `with`.
[[nodiscard]] FittedModel start_model(const Recording& recording, Column output,
                                      const std::vector<std::string>& with = {},
                                      const Catalogue& catalogue = standard_catalogue(),
                                      const Work& work = Work::unlimited());

/// `model` with one more effect, everything fitted again. `history` grows by one step.
/// Where the free run does not show the effect and one sample ahead does, the model is
/// the one that tells it, under its noise colour (told_ahead.hpp).
[[nodiscard]] FittedModel add_effect(const Recording& recording, const Model& model,
                                     std::string_view effect,
                                     const Catalogue& catalogue = standard_catalogue(),
                                     const Work& work = Work::unlimited());

/// `model` without one of its effects, everything else fitted again. `history` grows by
/// one step, whose effect is the code after a minus. Throws std::invalid_argument where
/// the model lacks it.
[[nodiscard]] FittedModel remove_effect(const Recording& recording, const Model& model,
                                        std::string_view effect,
                                        const Catalogue& catalogue = standard_catalogue(),
                                        const Work& work = Work::unlimited());

}  // namespace workbench
