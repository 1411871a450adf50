#include "workbench/recording/rows/value_reader.hpp"

#include <algorithm>
#include <cmath>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/spelling/bad_value.hpp"
#include "workbench/recording/spelling/column_words.hpp"
#include "workbench/recording/spelling/mark_doubt.hpp"
#include "workbench/recording/spelling/quality_words.hpp"
#include "workbench/recording/text_encoding.hpp"
#include "workbench/recording/time_parts.hpp"
#include "workbench/recording/time_unit.hpp"
#include "workbench/recording/written_time.hpp"

namespace workbench {
namespace {

// 0.0 B: a number that its own word calls bad.
bool says_bad(std::string_view cell) {
  const std::optional<NumberWithQuality> found = number_with_quality(cell);
  NumberEvidence number;
  return found && found->word == QualityWord::kBad && number.add(found->number);
}

// 0.0 ?: a number that its own word calls questionable.
bool says_uncertain(std::string_view cell) {
  const std::optional<NumberWithQuality> found = number_with_quality(cell);
  return found && found->word == QualityWord::kUncertain;
}

// True and False, as programs write what a switch is told.
std::optional<double> truth_of(std::string_view cell) {
  if (cell.empty() || !is_letter_byte(cell.front())) return std::nullopt;
  const std::string word = lower_case(cell.substr(0, 6));
  if (word == "true") return 1;
  if (word == "false") return 0;
  return std::nullopt;
}

}  // namespace

// Of a switch all values are of its kind.
bool ValueReader::append_truth(const RowScanner& row, std::size_t slot,
                               SignalRows& signal) const {
  if (signal.column != Column::u) return false;
  const std::string_view cell = row.cell(slot);
  const std::optional<double> truth = truth_of(cell);
  if (!truth && signal.truths == 0) return false;
  const bool is_first = signal.truths == 0;
  const bool number_before = is_first && std::ranges::any_of(signal.values, [](double v) {
                               return v > 1 || v < 0;
                             });
  if (number_before || !(truth || cell.empty() || cell == "0" || cell == "1")) {
    throw InputError(row.error(
        slot,
        "True or False in column " + quoted(signal.name) + ", or a number in each row",
        quoted(cell), "repair the cells of another kind"));
  }
  signal.truths += truth ? 1 : 0;
  signal.values.push_back(truth          ? *truth
                          : cell.empty() ? kNoValue
                                         : static_cast<double>(cell == "1"));
  return true;
}

void ValueReader::append(const RowScanner& row, std::size_t slot, SignalRows& signal) {
  if (append_truth(row, slot, signal)) return;
  const std::string_view cell = row.cell(slot);
  double value = kNoValue;
  if (!cell.empty()) {
    std::string_view unit;
    const NumberReader::Result result = read(cell, value, unit);
    if (result == NumberReader::Result::kOk) {
      scale_to_unit(row, slot, signal, unit, value);
      if (!plain_ && says_uncertain(cell)) ++signal.uncertain;
      const bool bracketed = !plain_ && cell.front() == '(';
      if (bracketed && !signal.bracket) signal.bracket = bracket_error(row, slot, signal);
      signal.brackets.add(value, bracketed);
      const std::string_view number =
          bracketed ? without_brackets(cell) : cell.substr(0, cell.size() - unit.size());
      if (!marks_given_ && separator_ == ',')
        doubt_fraction(row, slot, signal, trimmed(number));
      if (!plain_ && !marks_known_)
        doubt_marks(row, slot, signal, trimmed(number), value);
    } else {
      if (signal.column != Column::t && !says_no_value(cell, !plain_) &&
          (plain_ || !says_bad(cell))) {
        const InputError error = number_error(row, slot, signal.name, result);
        if (plain_ || !reads_as_word(cell)) throw InputError(error);
        if (!signal.stranger) signal.stranger = error;
        signal.strangers.add(cell);
      }
      value = kNoValue;
      if (signal.bad++ == 0) signal.bad_word = utf8_of(cell.substr(0, 40));
    }
  }
  signal.values.push_back(value);
}

void ValueReader::doubt_marks(const RowScanner& row, std::size_t slot, SignalRows& signal,
                              std::string_view number, double value) const {
  signal.marks.add(number, value);
  if (signal.doubt || number_shape(number) != NumberShape::kThree) return;
  signal.doubt = number_error(row, slot, signal.name, NumberReader::Result::kUnclear);
}

void ValueReader::doubt_fraction(const RowScanner& row, std::size_t slot,
                                 SignalRows& signal, std::string_view number) const {
  signal.fractions.add(number);
  if (signal.fraction || number.size() < 2 || number[0] != '0') return;
  signal.fraction = row.error(
      slot, "a number in column " + quoted(signal.name),
      quoted(number) + ", which may be the decimals of a number before the comma",
      "separate the columns with semicolons, or write decimal points; where it is a "
      "number of its own, say --decimal point");
}

NumberReader::Result ValueReader::read(std::string_view cell, double& value,
                                       std::string_view& unit) {
  const NumberReader::Result result = numbers_.read(cell, value);
  if (plain_ || result != NumberReader::Result::kText) return result;
  if (const auto negative = negative_of(cell)) return numbers_.read(*negative, value);
  unit = unit_behind(cell);
  if (!unit.empty()) {
    return numbers_.read(trimmed(cell.substr(0, cell.size() - unit.size())), value);
  }
  const std::optional<NumberWithQuality> found = number_with_quality(cell);
  if (!found || found->word == QualityWord::kBad) return result;
  unit = unit_behind(found->number);
  const std::size_t length = found->number.size() - unit.size();
  return numbers_.read(trimmed(found->number.substr(0, length)), value);
}

void ValueReader::scale_to_unit(const RowScanner& row, std::size_t slot,
                                SignalRows& signal, std::string_view unit,
                                double& value) {
  constexpr double kThousand = 1000;
  if (!signal.cell_unit) {
    signal.cell_unit = unit;
    if (signal.unit.empty()) signal.unit = utf8_of(unit);
  }
  if (*signal.cell_unit == unit && signal.scaled.thousands() == 0) return;
  if (const auto ratio = unit_ratio(unit, *signal.cell_unit)) {
    signal.scaled.add(unit);
    value *= *ratio;
    return;
  }
  const InputError error =
      row.error(slot,
                (signal.cell_unit->empty() ? std::string("no unit")
                                           : "the unit " + quoted(*signal.cell_unit)) +
                    ", as before, in column " + quoted(signal.name),
                quoted(row.cell(slot)), "export the numbers without units");
  if (unit.empty() && says_thousand(*signal.cell_unit)) {
    // All before were thousands; their K is no unit.
    for (double& before : signal.values) {
      if (std::isnan(before)) continue;
      if (!signal.scaled.add_thousand(before)) throw InputError(error);
      before *= kThousand;
    }
    if (signal.unit == *signal.cell_unit) signal.unit.clear();
    signal.cell_unit = unit;
    signal.thousand = error;
  }
  if (!signal.cell_unit->empty()) throw InputError(error);
  if (unit.empty()) {
    if (std::abs(value) >= kThousand) throw InputError(error);
    return;
  }
  const bool fits =
      signal.scaled.thousands() > 0 || std::ranges::all_of(signal.values, [](double v) {
        return !(std::abs(v) >= kThousand);
      });
  if (!says_thousand(unit) || !fits || !signal.scaled.add_thousand(value)) {
    throw InputError(error);
  }
  if (!signal.thousand) signal.thousand = error;
  value *= kThousand;
}

InputError ValueReader::bracket_error(const RowScanner& row, std::size_t slot,
                                      const SignalRows& signal) {
  return row.error(slot, "a number with one meaning in column " + quoted(signal.name),
                   quoted(row.cell(slot)) + ", negative or marked",
                   "write a minus sign where it is negative, else no brackets");
}

bool ValueReader::append_time(const RowScanner& row, const TimeSlots& slots,
                              TimeColumn& times) {
  const std::string_view cell = row.cell(slots.column);
  if (cell.empty()) return false;
  double millis = 0;
  if (slots.millis && !row.cell(*slots.millis).empty() &&
      numbers_.read(row.cell(*slots.millis), millis) != NumberReader::Result::kOk) {
    return false;
  }
  const double extra_s = slots.millis_s * millis;
  if (!slots.parts.empty()) {
    const std::optional<std::string> time = joined_time(row, slots);
    if (!time) return false;
    const bool beside_date =
        slots.parts.front() != slots.column && !parts_have_date(slots.parts.size());
    return beside_date ? times.add(cell, *time, extra_s) : times.add(*time, "", extra_s);
  }
  if (times.form() == TimeForm::kNumber) {
    double value = 0;
    std::string_view unit;
    time_result_ = read(cell, value, unit);
    const double unit_s = unit.empty() ? 1 : seconds_of_unit(unit);
    if (time_result_ != NumberReader::Result::kOk || unit_s <= 0) return false;
    times.add(value * unit_s + extra_s);
    return true;
  }
  const std::string_view clock = slots.clock ? row.cell(*slots.clock) : "";
  if (slots.clock && clock.empty()) return false;
  if (!slots.clock_is_number) return times.add(cell, clock, extra_s);
  double of_day = 0;
  if (numbers_.read(clock, of_day) != NumberReader::Result::kOk) return false;
  return times.add(cell, of_day, std::min(clock.find_first_of(".,"), clock.size()),
                   extra_s);
}

std::optional<std::string> ValueReader::joined_time(const RowScanner& row,
                                                    const TimeSlots& slots) {
  std::vector<double> numbers;
  for (const std::size_t slot : slots.parts) {
    double value = 0;
    if (numbers_.read(row.cell(slot), value) != NumberReader::Result::kOk) {
      return std::nullopt;
    }
    numbers.push_back(value);
  }
  return time_of_parts(numbers);
}

InputError ValueReader::time_error(const RowScanner& row, const TimeSlots& slots,
                                   TimeForm form) const {
  const std::string_view cell = row.cell(slots.column);
  if (cell.empty() || (slots.clock && row.cell(*slots.clock).empty())) {
    return row.error(slots.column,
                     form == TimeForm::kNumber ? "a time in seconds" : "a date and time",
                     "an empty cell", "write the time, or remove the row");
  }
  if (!slots.parts.empty()) {
    std::string found;
    for (const std::size_t slot : slots.parts) {
      found += (found.empty() ? "" : " ") + std::string(row.cell(slot));
    }
    return row.error(slots.column,
                     "the numbers of a time in the columns " + quoted(slots.name),
                     quoted(found), "repair the row, or give --ts SECONDS");
  }
  if (form != TimeForm::kNumber) {
    return row.error(
        slots.column, "a date and time as in the other rows", quoted(cell),
        "write times as 2026-05-03 14:30:00, say --date-order dmy, mdy or ymd "
        "where the day does not fit, or give --ts SECONDS");
  }
  if (written_time(cell) || cell.find(':') != std::string_view::npos) {
    return row.error(slots.column, "a number in column " + quoted(slots.name),
                     quoted(cell),
                     "write all times alike, in seconds or as 2026-05-03 14:30:00, or "
                     "give --ts SECONDS");
  }
  return number_error(row, slots.column, slots.name, time_result_);
}

InputError ValueReader::number_error(const RowScanner& row, std::size_t slot,
                                     const std::string& name,
                                     NumberReader::Result result) const {
  const std::string_view cell = row.cell(slot);
  const std::string column = "in column " + quoted(name);
  switch (result) {
    case NumberReader::Result::kNotFinite:
      return row.error(slot, "a finite number " + column, quoted(cell),
                       "leave the cell empty where the value is missing");
    case NumberReader::Result::kMixedMarks:
      return row.error(slot, "one decimal mark in the whole file",
                       "both '.' and ',' up to " + quoted(cell),
                       "export without thousands separators, or say which is the decimal "
                       "mark: --decimal point or --decimal comma");
    case NumberReader::Result::kUnclear:
      return row.error(
          slot, "a number with one meaning " + column,
          quoted(cell) + (cell.find(',') != std::string_view::npos
                              ? ", with a decimal or a thousands comma"
                              : ", with a decimal or a thousands point"),
          "export with decimal points and without thousands separators, or say "
          "which it is: --decimal point or --decimal comma");
    case NumberReader::Result::kOk:
    case NumberReader::Result::kText:
      break;
  }
  if (is_beyond(cell)) {
    return row.error(slot, "a number " + column,
                     quoted(cell) + ", a limit of the instrument in place of the value",
                     "export a time when the signal stayed within its range");
  }
  if (separator_ == ',' && cell.find(',') != std::string_view::npos) {
    return row.error(slot, "a number " + column, quoted(cell),
                     "write a decimal point, or separate the columns with semicolons");
  }
  if (written_time(cell)) {
    return row.error(slot, "a number " + column, quoted(cell),
                     "name the column with the values, for example --u COLUMN, and that "
                     "with the times with --time COLUMN");
  }
  return row.error(slot, "a number " + column, quoted(cell),
                   "repair the cell, or leave it empty if missing");
}

}  // namespace workbench
