// Words of quality columns in the languages of the systems that export them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace workbench {

/// True for the name of a column that says how good a value is: quality, status, IsGood,
/// Bad, Qualité, 品質, DataQuality, PointStatus, ...; `key` as column_name.hpp makes
/// keys.
[[nodiscard]] bool is_quality_name(std::string_view key);

/// Of these, a name that means nothing else: not Q, which may be a flow, nor AirQuality.
[[nodiscard]] bool is_sure_quality_name(std::string_view key);

/// True for the name of a column whose 1 or True marks what is not good: Bad, Error,
/// Questionable. `pieces` as ColumnName::pieces; the last one counts.
[[nodiscard]] bool marks_bad(const std::vector<std::string>& pieces);

/// What a word of a quality column says.
enum class QualityWord : std::uint8_t { kUnknown, kGood, kUncertain, kBad };

/// In any case, with or without marks; of several in braces, {alarm,stale}, the worst.
/// Those of says_no_value() are not among the bad ones here.
[[nodiscard]] QualityWord quality_word(std::string_view word);

/// A number with the word for its quality behind a blank: 45.2 G, 45.2 (Good).
struct NumberWithQuality {
  std::string_view number;
  QualityWord word = QualityWord::kUnknown;
};

/// Takes such a cell apart; nothing where the word behind is not known. The number is not
/// looked at.
[[nodiscard]] std::optional<NumberWithQuality> number_with_quality(std::string_view cell);

/// True for a number that systems use as a code of quality: 0, 1, 100, the codes of OPC,
/// OPC UA and Ignition.
[[nodiscard]] bool is_quality_code(double number);

/// True for "true", "yes", "ja" and the like; false for all else, "false" included.
[[nodiscard]] bool says_yes(std::string_view word);

}  // namespace workbench
