// What to know about a model before its numbers are used.
#pragma once

#include <string>
#include <vector>

#include "workbench/model/base/model.hpp"
#include "workbench/model/search/explain.hpp"

namespace workbench {

/// True where the model is hardly better than a constant. `fit_percent`: that of the
/// model on the recording, contract's fit.
[[nodiscard]] bool says_hardly_anything(double fit_percent);

/// True where the interval of the process gain holds 0: of the gain by itself the
/// recording tells nothing.
[[nodiscard]] bool may_lack_gain(const Model& model);

/// True where u may not move the output at all: the model is hardly better than a
/// constant, or may lack its gain and the output does not follow u. Nothing that is left
/// over is worth a word then.
[[nodiscard]] bool tells_nothing(const Model& model, const FitQuality& quality);

/// True of what the readings show whatever the model, a coarse resolution, where next to
/// none of the error is its doing. `best`: an accepted candidate.
[[nodiscard]] bool is_beside_the_point(const Candidate& best);

/// (W31) True where little but the controller moves u in the recording, and the model
/// has neither a stem nor a recorded load that would move y.
[[nodiscard]] bool is_left_to_controller(const Model& model, const Recording& recording);

/// (W31) True where the setpoint of the recording rests and its controller would drive a
/// process with the gain of the model away from it.
[[nodiscard]] bool would_run_away(const Model& model, const Recording& recording);

/// Whole sentences in plain text, empty where there is nothing to say: u that only the
/// controller moves, a fit that a constant would reach, too, a gain that may be none or
/// is told only together with other parameters or has the wrong sign, a first lag that
/// only the length of the recording bounds. `quality`: of the model on `recording`.
[[nodiscard]] std::vector<std::string> cautions(const Model& model,
                                                const Recording& recording,
                                                const FitQuality& quality,
                                                bool left_to_controller);

}  // namespace workbench
