// Results of InfluxDB's Flux: tables that follow each other in one file.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "workbench/recording/csv_layout.hpp"
#include "workbench/recording/line_table.hpp"

namespace workbench {

/// The columns of text that tell the tables of a result apart, which may rest for longer
/// than the first rows. Life: new → add(row) for each row of the file → keys().
class FluxTables {
 public:
  /// `layout` must outlive this.
  explicit FluxTables(const CsvLayout& layout);

  /// False: no columns result, table and _time, or more tables than are looked at.
  [[nodiscard]] bool are_there() const;
  /// A whole row; heads and annotations are none.
  void add(const std::vector<LineCell>& cells);
  /// As few columns as do it, names of tags before others. Empty: no text differs from
  /// table to table.
  [[nodiscard]] std::vector<std::size_t> keys() const;

 private:
  [[nodiscard]] int merit(std::size_t k) const;
  [[nodiscard]] std::size_t told_apart(const std::vector<std::size_t>& by) const;

  const CsvLayout& layout_;
  std::optional<std::size_t> result_;
  std::optional<std::size_t> table_;
  bool timed_ = false;
  std::vector<std::size_t> texts_;  // columns
  std::set<std::size_t> moving_;    // of texts_: differ within a table
  std::map<std::string, std::vector<std::string>> tables_;
};

}  // namespace workbench
