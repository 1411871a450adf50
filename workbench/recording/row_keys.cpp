#include "workbench/recording/row_keys.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "workbench/recording/letters.hpp"
#include "workbench/recording/quality_words.hpp"

namespace workbench {
namespace {

using Codes = std::vector<std::uint16_t>;

constexpr std::string_view kParts =
    "parameter|param|attribute|property|field|metric|variable|signal";

constexpr std::size_t kFewestRows = 10;

// Rows of one tag each, in the order of the file.
std::map<std::uint32_t, std::vector<std::size_t>> grouped(
    const std::vector<std::uint32_t>& group) {
  std::map<std::uint32_t, std::vector<std::size_t>> out;
  for (std::size_t i = 0; i < group.size(); ++i) out[group[i]].push_back(i);
  return out;
}

class Splitting {
 public:
  Splitting(const std::vector<std::uint32_t>& group, const Codes& texts,
            const std::vector<std::uint32_t>& stamps) {
    for (const auto& [tag, rows] : grouped(group)) look(rows, texts, stamps);
  }

  [[nodiscard]] bool is_found(bool is_named) const {
    constexpr double kOften = 0.2;
    constexpr double kRepeats = 0.3;
    constexpr double kStillRepeats = 0.05;
    constexpr double kTurns = 0.95;
    if (rows_ < kFewestRows || !few_) return false;
    const auto of_rows = [this](std::size_t count) {
      return static_cast<double>(count) / static_cast<double>(rows_);
    };
    if (is_named && of_rows(changes_) > kOften) return true;
    if (of_rows(repeats_) > kRepeats && of_rows(still_) < kStillRepeats) return true;
    return of_rows(changes_) > 0.9 && comparable_ >= kFewestRows &&
           static_cast<double>(turns_) > kTurns * static_cast<double>(comparable_);
  }

 private:
  void look(const std::vector<std::size_t>& rows, const Codes& texts,
            const std::vector<std::uint32_t>& stamps) {
    std::set<std::uint16_t> different;
    std::set<std::uint32_t> seen;
    std::set<std::pair<std::uint32_t, std::uint16_t>> seen_with;
    for (const std::size_t i : rows) different.insert(texts[i]);
    if (different.size() > 1) few_ = few_ && different.size() * 3 <= rows.size();
    rows_ += rows.size();
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const std::uint16_t text = texts[rows[k]];
      changes_ += k > 0 && text != texts[rows[k - 1]];
      if (different.size() > 1 && k >= different.size()) {
        ++comparable_;
        turns_ += text == texts[rows[k - different.size()]];
      }
      if (stamps.empty()) continue;
      const bool is_new = seen.insert(stamps[rows[k]]).second;
      const bool is_new_with = seen_with.insert({stamps[rows[k]], text}).second;
      repeats_ += !is_new && is_new_with;
      still_ += !is_new_with;
    }
  }

  std::size_t rows_ = 0;
  std::size_t changes_ = 0;
  std::size_t repeats_ = 0;  // rows that repeat a time with another text
  std::size_t still_ = 0;    // with the same text
  std::size_t comparable_ = 0;
  std::size_t turns_ = 0;  // rows that say what one round ago was said
  bool few_ = true;        // each text comes several times
};

void divide(std::vector<std::uint32_t>& group, const Codes& by) {
  std::map<std::pair<std::uint32_t, std::uint16_t>, std::uint32_t> known;
  for (std::size_t i = 0; i < group.size(); ++i) {
    group[i] =
        known.try_emplace({group[i], by[i]}, static_cast<std::uint32_t>(i)).first->second;
  }
}

bool may_be_key(const LayoutColumn& column, std::size_t rows) {
  return column.same_as.size() == rows && (!column.rests() || column.changes_later) &&
         (column.content == Content::kText || column.name.part == Part::kTag) &&
         column.name.part != Part::kQuality &&
         quality_word(column.first) == QualityWord::kUnknown;
}

}  // namespace

std::vector<std::size_t> row_keys(const CsvLayout& layout,
                                  const std::vector<std::size_t>& times,
                                  const std::vector<std::size_t>& given) {
  const std::vector<LayoutColumn>& columns = layout.columns;
  std::size_t rows = 0;
  for (const LayoutColumn& column : columns) {
    rows = std::max(rows, column.same_as.size());
  }
  std::vector<std::uint32_t> group(rows, 0);
  std::vector<std::uint32_t> stamps;
  for (const std::size_t time : times) {
    if (columns[time].same_as.size() != rows) continue;
    stamps.resize(rows, 0);
    divide(stamps, columns[time].same_as);
  }
  std::vector<std::size_t> keys = given;
  for (const std::size_t key : given) {
    if (columns[key].same_as.size() == rows) divide(group, columns[key].same_as);
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto is_among = [i](const std::vector<std::size_t>& some) {
      return std::ranges::find(some, i) != some.end();
    };
    if (is_among(given) || is_among(times) || !may_be_key(columns[i], rows)) continue;
    const Splitting splitting(group, columns[i].same_as, stamps);
    const bool is_named = columns[i].name.part == Part::kTag;
    if (!columns[i].changes_later && !splitting.is_found(is_named)) continue;
    keys.push_back(i);
    divide(group, columns[i].same_as);
  }
  const auto names_a_part = [&columns](std::size_t key) {
    return is_one_of(columns[key].name.key, kParts);
  };
  std::ranges::sort(keys);
  std::ranges::stable_partition(keys,
                                [&](std::size_t key) { return !names_a_part(key); });
  return keys;
}

}  // namespace workbench
