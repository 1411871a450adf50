#include "workbench/recording/columns/long_format.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "workbench/recording/columns/mode_column.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/spelling/bad_value.hpp"
#include "workbench/recording/spelling/column_words.hpp"
#include "workbench/recording/spelling/quality_words.hpp"

namespace workbench {
namespace {

// Names of columns that hold numbers in place of tags.
constexpr std::string_view kNumbersOfTags =
    "tagid|tagindex|tagno|itemid|pointid|sensorid|nodeid|valueid";

// Where a table has a column for values of each type.
constexpr std::string_view kFractions = "floatvalue|doublevalue";
constexpr std::string_view kWholes = "intvalue|longvalue|integervalue";

constexpr std::string_view kUnits =
    "unit|units|uom|engunit|engunits|eu|unitname|engineeringunits|einheit|unite|unidad|"
    "unita";

constexpr std::string_view kParameters = "parameter|param|attribute|property";

class LongFinder {
 public:
  LongFinder(const CsvLayout& layout, const std::vector<std::size_t>& times)
      : columns_(layout.columns), nameless_(layout.header.empty()), times_(times) {}

  std::optional<LongFormat> find() const {
    if (has_output()) return std::nullopt;
    std::optional<std::size_t> value =
        first([](const LayoutColumn& c) { return c.name.part == Part::kValue; }, true);
    const bool bare = value && columns_[*value].name.tag.empty();
    const std::optional<std::size_t> tag =
        nameless_ ? tag_without_header() : tag_of(bare);
    if (tag && !value) value = unnamed_value(*tag);
    if (!tag || !value) return std::nullopt;
    LongFormat out;
    out.tag = *tag;
    out.value = *value;
    if (is_one_of(columns_[*value].name.key, kFractions)) {
      out.whole = first(
          [](const LayoutColumn& c) { return is_one_of(c.name.key, kWholes); }, true);
    }
    take_parameter(out);
    out.unit = first(
        [this, &out](const LayoutColumn& c) {
          return c.content == Content::kText && is_one_of(c.name.key, kUnits) &&
                 &c != &columns_[out.tag];
        },
        false);
    for (std::size_t i = 0; i < columns_.size() && !out.quality; ++i) {
      if (i != *tag && is_quality(columns_[i])) out.quality = i;
    }
    return out;
  }

 private:
  template <class Condition>
  [[nodiscard]] std::optional<std::size_t> first(Condition fits, bool measured) const {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const bool time = std::ranges::find(times_, i) != times_.end();
      if (!time && fits(columns_[i]) && (!measured || is_measured(columns_[i]))) return i;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool has_output() const {
    return std::ranges::any_of(columns_, [](const LayoutColumn& c) {
      return c.name.part == Part::kU || c.name.part == Part::kMv;
    });
  }

  // FIC101 in one column, OP in another.
  void take_parameter(LongFormat& out) const {
    const auto parameter = first(
        [](const LayoutColumn& c) {
          return c.content == Content::kText && is_one_of(c.name.key, kParameters);
        },
        false);
    if (!parameter) return;
    const auto tag = first(
        [](const LayoutColumn& c) {
          return c.content == Content::kText && c.name.part == Part::kTag &&
                 !is_one_of(c.name.key, kParameters);
        },
        false);
    if (!tag) return;
    out.tag = *tag;
    out.parameter = parameter;
  }

  [[nodiscard]] bool is_quality(const LayoutColumn& c) const {
    if (!nameless_) return c.name.part == Part::kQuality;
    return c.content == Content::kText &&
           quality_word(lower_case(c.first)) != QualityWord::kUnknown;
  }

  // Any text may name the tags beside a value that says so, best one that changes.
  [[nodiscard]] std::optional<std::size_t> tag_of(bool any_text) const {
    for (const bool may_rest : {false, true}) {
      const auto named = first(
          [may_rest](const LayoutColumn& c) {
            const bool numbered = c.content == Content::kNumber &&
                                  is_one_of(c.name.key, kNumbersOfTags) && !c.counts;
            return (c.content == Content::kText || numbered) &&
                   c.name.part == Part::kTag && (may_rest || !c.rests());
          },
          false);
      if (named) return named;
    }
    for (const bool may_rest : {false, true}) {
      const auto text = first(
          [may_rest](const LayoutColumn& c) {
            return c.content == Content::kText && c.name.part == Part::kNone &&
                   (may_rest || !c.rests());
          },
          false);
      if (text && any_text) return text;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<std::size_t> tag_without_header() const {
    const auto text =
        first([](const LayoutColumn& c) { return c.content == Content::kText; }, false);
    if (!text) return std::nullopt;
    const std::string& tag = columns_[*text].first;
    const bool alone = columns_.size() == times_.size() + 2 && may_name_tag(tag);
    return alone || is_signal(column_name(tag).part) ? text : std::nullopt;
  }

  [[nodiscard]] std::optional<std::size_t> unnamed_value(std::size_t tag) const {
    const auto of_process =
        first([](const LayoutColumn& c) { return c.name.part == Part::kY; }, true);
    if (of_process) return of_process;
    const auto numbers = [tag, this](const LayoutColumn& c) {
      return &c != &columns_[tag] && c.content == Content::kNumber &&
             c.name.part != Part::kTime && c.name.part != Part::kQuality &&
             c.name.part != Part::kMillis;
    };
    const auto average = first(
        [&numbers](const LayoutColumn& c) {
          return numbers(c) && !c.name.pieces.empty() &&
                 is_value_word(c.name.pieces.back());
        },
        true);
    if (average) return average;
    const auto only = first(numbers, true);
    if (!only) return std::nullopt;
    for (std::size_t i = *only + 1; i < columns_.size(); ++i) {
      const bool time = std::ranges::find(times_, i) != times_.end();
      if (!time && numbers(columns_[i]) && is_measured(columns_[i])) return std::nullopt;
    }
    return only;
  }

  const std::vector<LayoutColumn>& columns_;
  bool nameless_;
  const std::vector<std::size_t>& times_;
};

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

bool is_measured(const LayoutColumn& column) {
  constexpr std::string_view kCounters = "id|index|nr|no|row|zeile|rownum|sequence";
  return (column.content == Content::kNumber || column.content == Content::kNothing) &&
         !is_one_of(column.name.key, kCounters);
}

bool may_name_tag(std::string_view cell) {
  return quality_word(lower_case(cell)) == QualityWord::kUnknown &&
         !says_no_value(cell, true) && !is_unit(cell) && mode_code(cell) == kNoMode;
}

std::optional<LongFormat> long_format(const CsvLayout& layout,
                                      const std::vector<std::size_t>& times) {
  return LongFinder(layout, times).find();
}

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
