// Models on their way into a session.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/model/base/work.hpp"
#include "workbench/serve/session.hpp"

namespace workbench {

/// Throws InputError where no model of `output` can be fitted to the recording.
void check(const Recording& recording, Column output);

/// A model, judged on the recording.
[[nodiscard]] ModelStep step_of(const Recording& recording, Model model);
[[nodiscard]] std::shared_ptr<const ModelStep> shared_step(const Recording& recording,
                                                           Model model);

/// The recording that is open joined (model/joined.hpp) with those beside it that are
/// fitted, under names that tell them apart and without a clock time; itself where none
/// is. Throws InputError as joined().
[[nodiscard]] std::shared_ptr<const Recording> together(
    const std::shared_ptr<const Recording>& own,
    const std::vector<BesideRecording>& beside);

/// `model` fitted again, as a step of its history: HistoryStep::effect is kRefitted.
[[nodiscard]] Model fitted_anew(const Recording& recording, const Model& model,
                                const Work& search);
inline constexpr std::string_view kRefitted = "refit";

/// `model`, of which somebody set values since `before`, as a step of its history:
/// HistoryStep::effect is kSetByHand, or kFittedByHand where a fit went on from them.
[[nodiscard]] Model by_hand(const Recording& recording, const Model& before, Model model,
                            std::string_view how);
inline constexpr std::string_view kSetByHand = "by hand";
inline constexpr std::string_view kFittedByHand = "refit by hand";
/// Whether the model is none that commands make from the recording.
[[nodiscard]] bool is_by_hand(const Model& model);

/// Whether `found` says what `model` lacks, not what one before it lacked: tries nothing
/// that is in it.
[[nodiscard]] bool speaks_of(const ExplainResult& found, const Model& model);

/// `model` with effects added one after the other.
[[nodiscard]] Model with_effects(const Recording& recording, Model model,
                                 const std::vector<std::string>& effects,
                                 const Worker::Report& report, const Work& search);

/// `model` fitted again from where it is; what is held keeps its value, without an
/// interval. Intervals of the others are those of a fit in which nothing was held, which
/// are wider.
[[nodiscard]] Model refitted(const Recording& recording, const Model& model,
                             const HeldNames& held, const Work& search);

}  // namespace workbench
