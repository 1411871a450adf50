// Tables in JSON, as web services and programs write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// The rows of a JSON text as lines of cells with tabs between, names in the first line:
/// - an array of objects, or an object a line; objects in them give `outer.inner`;
/// - an object with such an array, or an array of arrays, under data, rows, values,
/// items,
///   records, samples, value (OData) or Items (PI Web API), names under columns or
///   schema.fields;
/// - an object of columns, each an array or an object of the same keys, or of numbered
/// rows;
/// - several series, each with its rows: Items in Items (PI Web API), data.result
///   (Prometheus), results.series (InfluxDB), the states of each entity of Home
///   Assistant's history; their names stand in a first column;
/// - what known_shape() makes one of these (json_shapes.hpp).
/// A value that is an object is its Name (a digital state of PI), null an empty cell.
/// Nothing: another shape, or no JSON. At most 64 MiB are looked at.
[[nodiscard]] std::optional<std::string> json_text(std::string_view text);

}  // namespace workbench
