// The contract's JSON of an identification.
#pragma once

#include <nlohmann/json.hpp>

#include "ident/verdict/verdict.hpp"
#include "workbench/analysis/analysis.hpp"
#include "workbench/recording/recording_view.hpp"

namespace workbench {

/// {"value", "low", "high"}, all null where the data cannot tell.
[[nodiscard]] nlohmann::ordered_json json_of(const ident::Estimate<double>& estimate);

/// {"ascending", "descending"}.
[[nodiscard]] nlohmann::ordered_json json_of(const ident::PerStroke<double>& strokes);

/// The object of `stickband identify --json`.
[[nodiscard]] nlohmann::ordered_json identification_json(const RecordingView& recording,
                                                         const Analysis& analysis);

/// One line of JSON. Numbers that are not finite become null, bytes that are not UTF-8
/// the replacement character.
[[nodiscard]] std::string json_line(const nlohmann::ordered_json& json);

}  // namespace workbench
