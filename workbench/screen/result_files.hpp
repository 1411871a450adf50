// A screening as files.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "workbench/screen/screening.hpp"

namespace workbench {

enum class ResultKind { kHtml, kJsonLines, kCsv, kSqlite };

/// By the ending: .html or .htm; .jsonl, .ndjson or .json; .csv; .sqlite, .sqlite3 or
/// .db. Throws std::invalid_argument for another.
[[nodiscard]] ResultKind kind_of_result(const std::string& path);

/// One row a loop: `loop,verdict,cost,...`, numbers with a point, empty where unknown.
[[nodiscard]] std::string csv_of(const Screening& screening);
[[nodiscard]] std::string json_lines_of(const Screening& screening);

/// Tables loops (the columns of the CSV), trend (loop, month, verdict, nats, stick_band,
/// oscillating_share), files (loop, file) and unpaired (tag). Written beside `path` and
/// moved there when complete. Throws std::runtime_error.
void write_sqlite(const Screening& screening, const std::string& path);

/// Writes the result to `path` in the kind of its ending, through `write` but for SQLite.
void write_result(const Screening& screening, const std::string& path,
                  const std::function<void(const std::string&, std::string_view)>& write);

}  // namespace workbench
