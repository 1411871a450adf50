// Texts that the first rows all say alike, and later ones do not; results of InfluxDB's
// Flux, whose tables follow each other in one file.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/columns/line_table.hpp"
#include "workbench/recording/csv_layout.hpp"

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

/// The line is the header once more, an annotation of InfluxDB above one, or the number
/// of a page.
[[nodiscard]] bool heads_again(std::string_view line, const std::string& header);

/// Sets LayoutColumn::changes_later: tags, of a file without a header texts that name a
/// signal, and what tells the tables of a Flux result apart. Life: new → add() while
/// are_open() → settle(). One walk through the rows, up to the first change where it is
/// no result.
class LaterTexts {
 public:
  /// Both must outlive this.
  LaterTexts(const CsvLayout& layout, const std::string& file);

  /// Further rows may say more.
  [[nodiscard]] bool are_open() const { return !resting_.empty() || tables_.are_there(); }
  /// Whole lines, from the first row on. Remarks below the rows say nothing.
  void add(std::string_view rows);
  /// `layout`: that of the beginning.
  void settle(CsvLayout& layout) const;

 private:
  const CsvLayout& layout_;
  const std::string& file_;
  std::vector<std::size_t> resting_;
  std::vector<std::size_t> changed_;
  FluxTables tables_;
};

}  // namespace workbench
