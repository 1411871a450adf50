// Points of InfluxDB as lines of text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace workbench {

/// Line protocol of InfluxDB (measurement,tag=a op=44.9,pv=60 1773475200000000000) as a
/// table of time, tag and value with a row a field. The tag of a row is the measurement,
/// the values of its tags and the name of the field, with points between. Nothing where
/// the first line is none such, remarks and CREATE DATABASE aside. Throws InputError
/// naming `file` for a later line that is none, one without a time stamp included; the
/// last one may be cut off.
/// O(bytes).
[[nodiscard]] std::optional<std::string> line_protocol_text(std::string_view text,
                                                            const std::string& file);

}  // namespace workbench
