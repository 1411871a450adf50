// Models as files: JSON that survives a round trip, and refuses what is not one.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/base/model.hpp"

namespace workbench {

/// Version of the file format; a file with another one is refused.
inline constexpr int kModelSchema = 1;

/// {"schema", "kind", "output", "recording", "process", "effects", "initial_state",
/// "history"}, and of one fitted under a noise colour {"noise_colour"}. Numbers that are
/// not finite become null.
[[nodiscard]] nlohmann::ordered_json model_json(const Model& model);

/// {"name": {"value", "low", "high", "unit", "bounds"}, …}.
[[nodiscard]] nlohmann::ordered_json json_of(const std::vector<Parameter>& parameters);

/// What stands beside the name of an effect: {"phenomenological", "parameters"}, and of
/// one that bends the signal along a curve {"kind", "curve": [[before, after], …]}.
/// `parameters` as the fit left them.
[[nodiscard]] nlohmann::ordered_json effect_json(
    const std::string& effect, bool phenomenological,
    const std::vector<Parameter>& parameters);

/// {"rmse_before", "rmse_after", "error_reduction_percent"}.
[[nodiscard]] nlohmann::ordered_json ahead_json(const AheadErrors& errors);

/// One effect of a model: its code, and what stands beside it.
[[nodiscard]] nlohmann::ordered_json term_json(const EffectTerm& term);

/// Reads a model file. Throws InputError naming the file, the key, what was expected,
/// what was found and what to do, for: text that is not JSON; JSON that is not a model;
/// another version; an effect that is not in the catalogue, or twice; a missing key; a
/// number that is not one or not finite.
[[nodiscard]] Model read_model(const std::string& path);

/// The same for a text already in memory; `name` stands in messages.
[[nodiscard]] Model parse_model(const std::string& text, const std::string& name);

}  // namespace workbench
