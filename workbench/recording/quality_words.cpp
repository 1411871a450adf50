#include "workbench/recording/quality_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/column_words.hpp"
#include "workbench/recording/folded.hpp"
#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

using namespace std::string_view_literals;

constexpr std::array kNames = {
    "quality"sv,   "status"sv,    "validity"sv,      "q"sv,           "qc"sv,
    "qual"sv,      "qualitaet"sv, "opcquality"sv,    "statuscode"sv,  "confidence"sv,
    "qstatus"sv,   "guete"sv,     "good"sv,          "isgood"sv,      "valid"sv,
    "isvalid"sv,   "qualite"sv,   "calidad"sv,       "qualidade"sv,   "qualita"sv,
    "kwaliteit"sv, "kvalitet"sv,  "kvalita"sv,       "jakosc"sv,      "minoseg"sv,
    "calitate"sv,  "kalite"sv,    "dataintegrity"sv, "qualitydesc"sv, "tagquality"sv,
    "stav"sv,      "laatu"sv,     "estado"sv,        "ステータス"sv,  "品質"sv,
    "状態"sv,      "质量"sv,      "状态"sv,          "качество"sv,    "статус"sv,
    "품질"sv,      "상태"sv,      "trendflags"sv,    "statusflags"sv, "dataquality"sv};
// Words behind which other words than these mean the same: DataQuality, PointStatus.
constexpr std::array kQualityEndings = {"quality"sv,    "qualitaet"sv, "qualite"sv,
                                        "calidad"sv,    "qualidade"sv, "kwaliteit"sv,
                                        "qualitycode"sv};
constexpr std::array kStatusEndings = {"status"sv, "statuscode"sv, "validity"sv,
                                       "qual"sv};
constexpr std::array kOfAValue = {"data"sv, "value"sv, "point"sv,   "tag"sv,
                                  "opc"sv,  "ua"sv,    "sample"sv,  "signal"sv,
                                  "item"sv, "meas"sv,  "reading"sv, "source"sv};
constexpr std::array kNamesOfBad = {"bad"sv,          "isbad"sv,         "error"sv,
                                    "iserror"sv,      "invalid"sv,       "isinvalid"sv,
                                    "questionable"sv, "isquestionable"sv};

constexpr std::array kGood = {
    "alarm"sv,  "unackedalarm"sv, "overridden"sv, "g"sv,     "nr"sv,    "cnd"sv,
    "cal"sv,    "ja"sv,           "yes"sv,        "oui"sv,   "si"sv,    "valido"sv,
    "sim"sv,    "bon"sv,          "buena"sv,      "bueno"sv, "buona"sv, "buono"sv,
    "boa"sv,    "bom"sv,          "goed"sv,       "bra"sv,   "dobra"sv, "dobry"sv,
    "valida"sv, "正常"sv,         "良好"sv,       "良"sv,    "好"sv,    "有效"sv,
    "норма"sv,  "хорошее"sv,      "хорошо"sv,     "양호"sv,  "정상"sv};
constexpr std::array kGoodBeginnings = {"good"sv,  "gut"sv,  "ok"sv,     "valid"sv,
                                        "true"sv,  "wahr"sv, "normal"sv, "gultig"sv,
                                        "bonne"sv, "vrai"sv};
constexpr std::array kUncertain = {"u"sv, "qst"sv, "?"sv};
constexpr std::array kUncertainBeginnings = {"uncertain"sv, "ques"sv,     "suspect"sv,
                                             "unsicher"sv,  "doubtful"sv, "incert"sv,
                                             "douteu"sv};
// IOP and what follows it: open inputs and outputs, failed points of CENTUM.
constexpr std::array kBad = {
    "stale"sv,  "disabled"sv, "null"sv, "b"sv,    "no"sv,   "non"sv,     "nein"sv,
    "nao"sv,    "iop"sv,      "iop+"sv, "iop-"sv, "oop"sv,  "ptpf"sv,    "ncom"sv,
    "nefv"sv,   "nfp"sv,      "mala"sv, "malo"sv, "ruim"sv, "cattiva"sv, "cattivo"sv,
    "slecht"sv, "異常"sv,     "异常"sv, "不良"sv, "坏"sv,   "无效"sv,    "無効"sv,
    "плохое"sv, "плохо"sv,    "불량"sv, "이상"sv};
constexpr std::array kBadBeginnings = {"false"sv, "falsch"sv,  "poor"sv,  "mauvais"sv,
                                       "faux"sv,  "invalid"sv, "fault"sv, "down"sv,
                                       "nok"sv,   "not ok"sv};
constexpr std::array kYes = {"true"sv, "yes"sv,  "ja"sv,  "oui"sv, "si"sv,
                             "wahr"sv, "vrai"sv, "sim"sv, "x"sv,   "1"sv};

bool begins_with_one(std::string_view word,
                     std::span<const std::string_view> beginnings) {
  return std::ranges::any_of(beginnings,
                             [word](std::string_view b) { return word.starts_with(b); });
}

bool ends_in_quality(std::string_view plain) {
  const auto ends = [plain](std::string_view end) {
    return plain.size() > end.size() && plain.ends_with(end);
  };
  if (std::ranges::any_of(kQualityEndings, ends)) return true;
  return std::ranges::any_of(kStatusEndings, [&](std::string_view end) {
    return ends(end) && is_one_of(plain.substr(0, plain.size() - end.size()), kOfAValue);
  });
}

// Of one word, without regard to case and marks.
QualityWord meaning_of(std::string_view word_of_any_case) {
  const std::string word = folded(word_of_any_case);
  if (is_one_of(word, kUncertain) || begins_with_one(word, kUncertainBeginnings)) {
    return QualityWord::kUncertain;
  }
  if (is_one_of(word, kBad) || begins_with_one(word, kBadBeginnings)) {
    return QualityWord::kBad;
  }
  if (is_one_of(word, kGood) || begins_with_one(word, kGoodBeginnings)) {
    return QualityWord::kGood;
  }
  return QualityWord::kUnknown;
}

// {fault,down} of Niagara: all that holds at once, of which the worst counts.
QualityWord worst_of(std::string_view set) {
  set = set.substr(1, set.find('}') - 1);
  QualityWord worst = QualityWord::kGood;
  while (!trimmed(set).empty()) {
    const std::size_t comma = std::min(set.find(','), set.size());
    const QualityWord word = meaning_of(trimmed(set.substr(0, comma)));
    if (word == QualityWord::kBad) return word;
    if (word != QualityWord::kGood && worst != QualityWord::kUncertain) worst = word;
    set.remove_prefix(std::min(comma + 1, set.size()));
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
