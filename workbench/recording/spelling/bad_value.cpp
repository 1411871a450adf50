#include "workbench/recording/spelling/bad_value.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/spelling/cell_number.hpp"
#include "workbench/recording/spelling/column_words.hpp"
#include "workbench/recording/spelling/quality_words.hpp"
#include "workbench/recording/text_encoding.hpp"

namespace workbench {
namespace {

constexpr double kGoodCode = 192;  // OPC Data Access
constexpr double kUncertainCode = 64;
constexpr double kOpcUaBad = 2147483648.0;  // severity bits of OPC UA
constexpr double kOpcUaUncertain = 1073741824.0;

constexpr std::string_view kWords =
    "null|<null>|none|nil|n/a|n.a.|nodata|void|invalid|missing|unknown|unavailable|"
    "shutdown|off-line|offline|off-scan|off scan|oos|err|schlecht|fehler|fehlend|"
    "keine daten|kein wert|ol|+ol|-ol|ung\xC3\xBCltig|ung\xFCltig|ungueltig|"
    "gest\xC3\xB6rt|gest\xF6rt|gestoert|na|nd|n.d.|n/d|n.c.|s/d|\\n|<na>|<gated>|(null)|"
    "@@@@";

constexpr std::string_view kBeginnings =
    "bad|no data|no good|no result|no value|no sample|i/o timeout|io timeout|timeout|"
    "timed out|digital state|digital set|pt created|scan |comm|out of serv|not connect|"
    "not avail|not collect|configure|calc |over range|overrange|under range|underrange|"
    "intf|equip|failed|error|arc |set to bad|access denied|resize to|no_data|<bad|<no|"
    "trace off|doubtful";

constexpr std::string_view kExportWords = "nan|-nan|+nan|nan(ind)|-|*|?|.";

// As Microsoft's printf writes them, with as many zeros behind as it has decimals.
constexpr std::string_view kPrintedNan = "1.#qnan|1.#snan|1.#ind|1.#nan";
constexpr std::string_view kPrintedInfinity = "1.#inf";

// What may stand for 1 and 0.
constexpr std::string_view kNumberWords =
    "true|false|yes|ein|aus|wahr|falsch|open|closed|auf|zu";

constexpr std::size_t kLongest = 48;

std::string_view without_sign(std::string_view word) {
  if (!word.empty() && (word[0] == '+' || word[0] == '-')) word.remove_prefix(1);
  return word;
}

// 1.#INF00 of 1.#INF.
bool is_printed(std::string_view word, std::string_view as) {
  return word.starts_with(as) &&
         word.find_first_not_of('0', as.size()) == std::string_view::npos;
}

bool is_printed_nan(std::string_view lower) {
  return any_word(kPrintedNan, [&lower](std::string_view as) {
    return is_printed(without_sign(lower), as);
  });
}

bool is_infinity(std::string_view lower) {
  const std::string_view word = without_sign(lower);
  return word == "inf" || word == "infinity" || is_printed(word, kPrintedInfinity);
}

// -----, +++++++, ***, ?????: beyond the range, or too wide for the column.
bool is_row_of_marks(std::string_view cell) {
  constexpr std::size_t kFewest = 3;
  const char mark = cell.front();
  const std::size_t fewest = mark == '-' || mark == '#' ? 2 : kFewest;
  return std::string_view("-+*?#").find(mark) != std::string_view::npos &&
         cell.size() >= fewest && cell.find_first_not_of(mark) == std::string_view::npos;
}

}  // namespace

bool says_no_value(std::string_view cell, bool export_file) {
  if (cell.empty()) return false;
  const char first = cell.front();
  if ((first >= '0' && first <= '9' && cell.find('#') == std::string_view::npos)) {
    return false;
  }
  const std::string lower = lower_case(cell.substr(0, kLongest));
  if (lower[0] == '#' && lower.size() > 1 && is_small(lower[1])) return true;
  if (is_row_of_marks(cell)) return true;
  return is_one_of(lower, kWords) || begins_with_one_of(lower, kBeginnings) ||
         (export_file && (is_one_of(lower, kExportWords) || is_printed_nan(lower)));
}

bool is_beyond(std::string_view cell) {
  if (cell.empty() || (cell[0] != '<' && cell[0] != '>')) return false;
  cell.remove_prefix(1);
  if (!cell.empty() && cell[0] == '=') cell.remove_prefix(1);
  NumberEvidence number;
  return number.add(trimmed(cell.substr(0, cell.size() - unit_behind(cell).size())));
}

bool reads_as_word(std::string_view cell) {
  if (is_beyond(cell)) return true;
  const std::string_view word = without_sign(cell);
  const std::string lower = lower_case(word.substr(0, kLongest));
  if (is_infinity(lower)) return true;
  if (word.empty() || word[0] == '.' || word[0] == ',') return false;
  if (is_digit(word[0])) {
    const std::size_t blank = cell.find(' ');
    return blank != std::string_view::npos &&
           says_no_value(without_brackets(cell.substr(blank)), false);
  }
  const auto letters =
      static_cast<std::size_t>(std::ranges::count_if(word, is_letter_byte));
  const auto digits = static_cast<std::size_t>(std::ranges::count_if(word, is_digit));
  constexpr std::size_t kFewestLetters = 3;
  return letters >= kFewestLetters && letters > digits && !lower.starts_with("inf") &&
         !lower.starts_with("nan") && !is_one_of(lower, kNumberWords);
}

namespace {

// The code of a cell that is a number, decimal or as 0x80000000.
std::optional<double> numeric_code(std::string_view cell) {
  if (cell.starts_with("0x") || cell.starts_with("0X")) {
    const auto code = wire::number_of<std::uint64_t>(cell.substr(2), 16);
    return code ? std::optional(static_cast<double>(*code)) : std::nullopt;
  }
  const std::optional<double> code = wire::number_of<double>(cell);
  // The code of OPC UA and Ignition in a signed number of 32 bits.
  if (code >= -kOpcUaBad && code < -kOpcUaUncertain) return *code + 2 * kOpcUaBad;
  return code >= 0.0 ? code : std::nullopt;
}

// OPC's codes below uncertain, and those of Ignition with three digits (500: disabled,
// 600: not found); the upper byte of an OPC code is the vendor's, with 192 below it.
bool is_bad_beside_192(double code) {
  constexpr double kFirstOfIgnition = 256;
  constexpr double kLastOfIgnition = 1023;
  if (code < kUncertainCode) return true;
  return code >= kFirstOfIgnition && code <= kLastOfIgnition &&
         std::fmod(code, kFirstOfIgnition) != kGoodCode;
}

}  // namespace

double QualityScale::add(std::string_view cell) {
  if (cell.empty()) return marks_bad_ ? 0 : kGoodCode;
  ++cells_;
  if (const std::optional<double> code = numeric_code(cell)) {
    if (*code == 0) ++zeros_;
    has_192_ = has_192_ || *code == kGoodCode;
    most_ = std::max(most_, *code);
    flags_only_ = flags_only_ && (*code == 0 || *code == 1);
    return *code;
  }
  const std::string lower = lower_case(cell.substr(0, kLongest));
  if (marks_bad_) return says_yes(lower) ? 1 : 0;
  most_ = std::max(most_, kGoodCode);
  const QualityWord word = quality_word(lower);
  if (word == QualityWord::kUncertain) return kUncertainCode;
  if (word == QualityWord::kBad || says_no_value(cell, true)) return 0;
  if (word == QualityWord::kUnknown) unknown_.add(cell);
  return kGoodCode;
}

Quality QualityScale::meaning(double code) const {
  constexpr std::size_t kNearlyAll = 10;  // all but one of so many
  bool bad = false;
  bool uncertain = false;
  if (marks_bad_) {
    bad = flags_only_ && code == 1;
  } else if (most_ >= kOpcUaUncertain) {
    bad = code >= kOpcUaBad || (has_192_ && is_bad_beside_192(code));
    uncertain = code >= kOpcUaUncertain;
  } else if (most_ >= kGoodCode) {
    bad = has_192_ ? is_bad_beside_192(code) : code < kUncertainCode;
    uncertain = code >= kUncertainCode && code < kGoodCode;
  } else if (kNearlyAll * (cells_ - zeros_) <= cells_) {
    bad = code != 0 && code != kGoodCode;
  } else {
    bad = code == 0;
  }
  if (bad) return Quality::kBad;
  return uncertain ? Quality::kUncertain : Quality::kGood;
}

void WordCounts::add(std::string_view word) {
  ++total_;
  const auto known =
      std::ranges::find_if(words_, [word](const auto& w) { return w.first == word; });
  if (known != words_.end()) {
    ++known->second;
  } else if (words_.size() < kMostWords) {
    words_.emplace_back(word, 1);
  }
}

std::string WordCounts::list() const {
  std::string text;
  std::size_t listed = 0;
  for (const auto& [word, count] : words_) {
    text +=
        (text.empty() ? "" : ", ") + quoted(utf8_of(word)) + ' ' + std::to_string(count);
    listed += count;
  }
  if (listed < total_) text += ", others " + std::to_string(total_ - listed);
  return text;
}

}  // namespace workbench
