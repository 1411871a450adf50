#include "workbench/recording/spelling/quality_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/spelling/column_words.hpp"

namespace workbench {
namespace {

constexpr std::string_view kNames =
    "quality|status|validity|q|qc|qual|qualitaet|opcquality|statuscode|confidence|"
    "qstatus|guete|good|isgood|valid|isvalid|qualite|calidad|qualidade|qualita|"
    "kwaliteit|kvalitet|kvalita|jakosc|minoseg|calitate|kalite|dataintegrity|"
    "qualitydesc|tagquality|stav|laatu|estado|ステータス|品質|状態|质量|状态|качество|"
    "статус|품질|상태|trendflags|statusflags|dataquality";
// Words behind which other words than these mean the same: DataQuality, PointStatus.
constexpr std::string_view kQualityEndings =
    "quality|qualitaet|qualite|calidad|qualidade|kwaliteit|qualitycode";
constexpr std::string_view kStatusEndings = "status|statuscode|validity|qual";
constexpr std::string_view kOfAValue =
    "data|value|point|tag|opc|ua|sample|signal|item|meas|reading|source";
constexpr std::string_view kNamesOfBad =
    "bad|isbad|error|iserror|invalid|isinvalid|questionable|isquestionable";

constexpr std::string_view kGood =
    "alarm|unackedalarm|overridden|g|nr|cnd|cal|ja|yes|oui|si|valido|sim|bon|buena|"
    "bueno|buona|buono|boa|bom|goed|bra|dobra|dobry|valida|正常|良好|良|好|有效|норма|"
    "хорошее|хорошо|양호|정상";
constexpr std::string_view kGoodBeginnings =
    "good|gut|ok|valid|true|wahr|normal|gultig|bonne|vrai";
constexpr std::string_view kUncertain = "u|qst|?";
constexpr std::string_view kUncertainBeginnings =
    "uncertain|ques|suspect|unsicher|doubtful|incert|douteu";
// IOP and what follows it: open inputs and outputs, failed points of CENTUM.
constexpr std::string_view kBad =
    "stale|disabled|null|b|no|non|nein|nao|iop|iop+|iop-|oop|ptpf|ncom|nefv|nfp|mala|"
    "malo|ruim|cattiva|cattivo|slecht|異常|异常|不良|坏|无效|無効|плохое|плохо|불량|이상";
constexpr std::string_view kBadBeginnings =
    "false|falsch|poor|mauvais|faux|invalid|fault|down|nok|not ok";
constexpr std::string_view kYes = "true|yes|ja|oui|si|wahr|vrai|sim|x|1";

bool ends_in_quality(std::string_view plain) {
  const auto ends = [plain](std::string_view end) {
    return plain.size() > end.size() && plain.ends_with(end);
  };
  if (any_word(kQualityEndings, ends)) return true;
  return any_word(kStatusEndings, [&](std::string_view end) {
    return ends(end) && is_one_of(plain.substr(0, plain.size() - end.size()), kOfAValue);
  });
}

// Of one word, without regard to case and marks.
QualityWord meaning_of(std::string_view word_of_any_case) {
  const std::string word = folded(word_of_any_case);
  if (is_one_of(word, kUncertain) || begins_with_one_of(word, kUncertainBeginnings)) {
    return QualityWord::kUncertain;
  }
  if (is_one_of(word, kBad) || begins_with_one_of(word, kBadBeginnings)) {
    return QualityWord::kBad;
  }
  if (is_one_of(word, kGood) || begins_with_one_of(word, kGoodBeginnings)) {
    return QualityWord::kGood;
  }
  return QualityWord::kUnknown;
}

// {fault,down} of Niagara: all that holds at once, of which the worst counts.
QualityWord worst_of(std::string_view set) {
  set = set.substr(1, set.find('}') - 1);
  QualityWord worst = QualityWord::kGood;
  while (!trimmed(set).empty()) {
    const QualityWord word = meaning_of(trimmed(wire::take_until(set, ',')));
    if (word == QualityWord::kBad) return word;
    if (word != QualityWord::kGood && worst != QualityWord::kUncertain) worst = word;
  }
  return worst;
}

}  // namespace

bool is_quality_name(std::string_view key) {
  const std::string plain = folded(key);
  return is_one_of(plain, kNames) || is_one_of(plain, kNamesOfBad) ||
         ends_in_quality(plain);
}

bool is_sure_quality_name(std::string_view key) {
  const std::string plain = folded(key);
  return plain != "q" && (is_one_of(plain, kNames) || is_one_of(plain, kNamesOfBad));
}

bool marks_bad(const std::vector<std::string>& pieces) {
  return !pieces.empty() && is_one_of(pieces.back(), kNamesOfBad);
}

QualityWord quality_word(std::string_view word) {
  return word.starts_with('{') ? worst_of(word) : meaning_of(without_brackets(word));
}

std::optional<NumberWithQuality> number_with_quality(std::string_view cell) {
  const std::size_t blank = cell.rfind(' ');
  if (blank == std::string_view::npos || blank == 0) return std::nullopt;
  const std::string_view word = cell.substr(blank + 1);
  const QualityWord quality = quality_word(lower_case(word));
  if (word.empty() || is_digit(word[0]) || quality == QualityWord::kUnknown) {
    return std::nullopt;
  }
  return NumberWithQuality{trimmed(cell.substr(0, blank)), quality};
}

bool is_quality_code(double number) {
  constexpr std::array kCodes = {0,  1,  4,  8,  12, 16,  20,  24, 28,
                                 64, 68, 80, 84, 88, 100, 192, 216};
  constexpr double kLastOfIgnition = 1023;
  constexpr double kOpcUaUncertain = 1073741824;
  if (number != std::floor(number)) return false;
  return std::ranges::find(kCodes, number) != kCodes.end() ||
         (number >= 256 && number <= kLastOfIgnition && std::fmod(number, 10) == 0) ||
         std::abs(number) >= kOpcUaUncertain;
}

bool says_yes(std::string_view word) {
  return is_one_of(word, kYes);
}

}  // namespace workbench
