#include "workbench/recording/long_format.hpp"

#include <algorithm>

#include "workbench/recording/bad_value.hpp"
#include "workbench/recording/column_words.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/mode_column.hpp"
#include "workbench/recording/quality_words.hpp"

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

}  // namespace workbench
