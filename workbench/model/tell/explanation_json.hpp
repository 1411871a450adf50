// The contract's JSON of compare, explain, add and ladder.
#pragma once

#include <nlohmann/json.hpp>

#include "workbench/model/judge/compare.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/ladder.hpp"

namespace workbench {

[[nodiscard]] nlohmann::ordered_json comparison_json(const Comparison& comparison);
[[nodiscard]] nlohmann::ordered_json explanation_json(const ExplainResult& result);
[[nodiscard]] nlohmann::ordered_json ladder_json(const LadderResult& result);
/// Each recording for itself.
[[nodiscard]] nlohmann::ordered_json recordings_json(
    const std::vector<RecordingFit>& recordings);
/// Of the last step of the model's history.
[[nodiscard]] nlohmann::ordered_json added_json(const Model& model);
/// The same of an effect that the last step took out; the effects that stay.
[[nodiscard]] nlohmann::ordered_json removed_json(const Model& model);

}  // namespace workbench
