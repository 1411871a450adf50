#include "workbench/recording/columns/quality_columns.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "workbench/recording/letters.hpp"
#include "workbench/recording/spelling/bad_value.hpp"
#include "workbench/recording/spelling/quality_words.hpp"

namespace workbench {
namespace {

// What the cells of a column are as qualities.
struct Evidence {
  bool codes = true;  // numbers that systems use as codes, or no numbers
  bool words = true;  // all that is written is a word for a quality
  bool good = false;  // OPC's 192 is among them
  bool any = false;
};

Evidence evidence_of(const LineTable& table, std::size_t column) {
  constexpr double kGoodOfOpc = 192;
  Evidence out;
  for (std::size_t i = table.first_row(); table.has_rows() && i < table.lines(); ++i) {
    if (column >= table.cells(i).size()) continue;
    const std::string_view cell = table.cells(i)[column].text;
    if (cell.empty()) continue;
    out.any = true;
    const std::optional<double> number = wire::number_of<double>(cell);
    const bool is_code = number && is_quality_code(*number);
    out.good = out.good || number == kGoodOfOpc;
    out.codes = out.codes && (number ? is_code : kind_of(cell) != CellKind::kNumber);
    out.words = out.words && !number &&
                (quality_word(lower_case(cell)) != QualityWord::kUnknown ||
                 says_no_value(cell, true));
  }
  return out;
}

void check_name(const LineTable& table, std::size_t column, ColumnName& name) {
  const bool doubtful =
      name.part == Part::kQuality && !is_sure_quality_name(name.pieces.back());
  if (!doubtful || evidence_of(table, column).codes) return;
  name.part = Part::kNone;
  name.tag.clear();
  name.prefix.clear();
}

bool may_have_quality(const LayoutColumn& column) {
  const Part part = column.name.part;
  return !column.name.key.empty() && part != Part::kQuality && part != Part::kTime &&
         part != Part::kTag && part != Part::kMillis;
}

// What stands behind the name of a signal in that of its quality; "": nothing does.
std::string_view behind(std::string_view key, std::string_view signal) {
  return key.size() > signal.size() && key.starts_with(signal) ? key.substr(signal.size())
                                                               : std::string_view();
}

// Q1, PVQ
bool names_quality_beside(const ColumnName& name) {
  const std::string& last = name.pieces.back();
  return last.ends_with('q') || (last.size() > 1 && last.starts_with('q') &&
                                 std::all_of(last.begin() + 1, last.end(), is_digit));
}

bool is_quality_of(const LineTable& table, const std::vector<LayoutColumn>& columns,
                   std::size_t quality, std::size_t signal) {
  constexpr double kNearlyAll = 0.9;
  const LayoutColumn& column = columns[quality];
  const std::string_view word = behind(column.name.key, columns[signal].name.key);
  const bool beside = quality == signal + 1 && names_quality_beside(column.name);
  const bool status = word == "st";
  if (!status && !beside && (word.empty() || !is_quality_name(word))) return false;
  const Evidence evidence = evidence_of(table, quality);
  if (!evidence.any) return false;
  if (evidence.words) return true;
  if (!evidence.codes || column.content != Content::kNumber) return false;
  return evidence.good || (!word.empty() && (!status || column.held >= kNearlyAll));
}

}  // namespace

void settle_qualities(const LineTable& table, std::vector<LayoutColumn>& columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) check_name(table, i, columns[i].name);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    ColumnName& name = columns[i].name;
    const bool open = name.part == Part::kNone || name.part == Part::kQuality;
    if (!open || name.key.empty()) continue;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (k == i || !may_have_quality(columns[k])) continue;
      if (name.part == Part::kQuality && behind(name.key, columns[k].name.key).empty()) {
        continue;
      }
      if (!is_quality_of(table, columns, i, k)) continue;
      name.part = Part::kQuality;
      name.tag = columns[k].name.key;
      break;
    }
  }
}

}  // namespace workbench
