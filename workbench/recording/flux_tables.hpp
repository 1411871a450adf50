// Results of InfluxDB's Flux: tables that follow each other in one file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/csv_layout.hpp"

namespace workbench {

/// The columns of text that tell the tables of a result apart, which may rest for longer
/// than the first rows: as few as do it, names of tags before others. Empty: no columns
/// result, table and _time, or no text differs from table to table. `rows`: the text from
/// the first row on. One walk through the file where it is a result.
[[nodiscard]] std::vector<std::size_t> flux_keys(std::string_view rows,
                                                 const std::string& file,
                                                 const CsvLayout& layout);

}  // namespace workbench
