// What a file holds, before it is decided which of its signals are u and y.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "workbench/recording/csv.hpp"

namespace workbench {

/// Points drawn of each signal.
inline constexpr int kPreviewPixels = 120;
/// Signals at most; a file with more is previewed with the first.
inline constexpr std::size_t kMostPreviewed = 400;

/// {"schema","name","header_line","columns","problem","picked","signals","loops","time",
/// "needs_time","rows","samples","sample_period_s","start","notes"}.
///
/// "columns": names of all columns, for a choice of the time. "picked": what `options`
/// would take as u, y, sp and x, by name; "problem": the error they would meet instead,
/// as in /api/state. "time": where none is told by its name, a column that rises evenly
/// and is taken as seconds, "#1"; "needs_time": there is none, and "sample_period_s" is
/// null. "signals": of every column or tag that holds numbers its "name",
/// "unit", "low", "high", and "points", the smallest and largest value of each stretch.
/// "loops": tags that have both an output and a measured value, with "name", "u", "y"
/// and, where there are, "sp" and "x". Where rows cannot be read at all "signals" is
/// empty and "problem" says why. Throws what parse_csv() throws for a file without a
/// header. Cost: reads the file twice, without times up to four times.
[[nodiscard]] nlohmann::ordered_json column_preview(std::string_view text,
                                                    const std::string& name,
                                                    CsvOptions options);

}  // namespace workbench
