// Texts that the first rows all say alike, and later ones do not.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/csv_layout.hpp"
#include "workbench/recording/flux_tables.hpp"

namespace workbench {

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
