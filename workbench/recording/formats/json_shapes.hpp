// JSON of services and programs, in a shape that json_table.hpp reads.
#pragma once

#include <nlohmann/json.hpp>

namespace workbench {

/// Whether `values` has some, all of one kind, as &Json::is_object tells it.
[[nodiscard]] bool all_of_kind(const nlohmann::ordered_json& values,
                               bool (nlohmann::ordered_json::*kind)() const noexcept);

/// `root` in a known shape, or as it was:
/// - ThingSpeak: `feeds` as rows, field1 … named as the channel names them;
/// - Graphite and Grafana: [{"target": NAME, "datapoints": [[VALUE, TIME], …]}, …] as
///   series of rows with their times first;
/// - pandas' `to_json`, with orient split, columns or index: an index that tells
///   more than the number of the row becomes the last column, `time` or `index`.
[[nodiscard]] nlohmann::ordered_json known_shape(nlohmann::ordered_json root);

}  // namespace workbench
