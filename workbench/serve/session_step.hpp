// Models on their way into a session.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "workbench/model/work.hpp"
#include "workbench/serve/session.hpp"

namespace workbench {

/// Throws InputError where no model of `output` can be fitted to the recording.
void check(const Recording& recording, Column output);

/// A model, judged on the recording.
[[nodiscard]] ModelStep step_of(const Recording& recording, Model model);
[[nodiscard]] std::shared_ptr<const ModelStep> shared_step(const Recording& recording,
                                                           Model model);

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
