#include "workbench/recording/column_words.hpp"

#include <algorithm>
#include <array>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/folded.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/number_spelling.hpp"
#include "workbench/recording/part_words.hpp"
#include "workbench/recording/quality_words.hpp"

namespace workbench {
namespace {

struct PartWord {
  std::string_view key;
  Part part;
};

// Beginnings of words in longer names.
constexpr std::array kHints = std::to_array<PartWord>({
    {"valve", Part::kU},    {"pwm", Part::kU},      {"heater", Part::kU},
    {"pump", Part::kU},     {"command", Part::kU},  {"control", Part::kU},
    {"duty", Part::kU},     {"output", Part::kU},   {"xmv", Part::kU},
    {"xmeas", Part::kY},    {"velocity", Part::kY}, {"actual", Part::kY},
    {"temp", Part::kY},     {"level", Part::kY},    {"flow", Part::kY},
    {"press", Part::kY},    {"speed", Part::kY},    {"humidity", Part::kY},
    {"measured", Part::kY}, {"input", Part::kU},    {"drive", Part::kU},
    {"dac", Part::kU},      {"adc", Part::kY},      {"veloc", Part::kY},
    {"encoder", Part::kY},  {"angle", Part::kY},    {"rpm", Part::kY},
    {"weight", Part::kY},   {"druck", Part::kY},    {"durchfl", Part::kY},
    {"niveau", Part::kY},   {"nivel", Part::kY},    {"presi", Part::kY},
    {"caudal", Part::kY},   {"vaza", Part::kY},     {"cmd", Part::kU},
    {"static", Part::kY},
});

// Words of what is wanted, and of what it lacks: neither u nor y.
constexpr std::string_view kAims = "sp|set|ref|aim|dev|err|goal|soll|stpt";
constexpr std::string_view kAimBeginnings =
    "setp|target|desired|sollw|error|deviation|reference";

bool is_aim(std::string_view piece) {
  const bool numbered = piece.size() > 3 && piece.ends_with("sp") &&  // t2sp
                        wire::is_digit(piece[piece.size() - 3]);
  return numbered || is_one_of(piece, kAims) || begins_with_one_of(piece, kAimBeginnings);
}

// AI1, AO: what a card reads and what it puts out.
Part part_of_card(std::string_view piece) {
  const std::string_view letters = piece.substr(0, piece.find_first_of("0123456789"));
  return letters == "ao" ? Part::kU : letters == "ai" ? Part::kY : Part::kNone;
}

// T2
bool is_temperature(std::string_view piece) {
  return piece.size() > 1 && piece[0] == 't' &&
         std::all_of(piece.begin() + 1, piece.end(), wire::is_digit);
}

// Pieces behind the name that only say "the value of it".
constexpr std::string_view kValueWords =
    "value|val|cv|valuey|wert|avg|average|mean|mittelwert|readvalue|presentvalue|fcv|"
    "current|raw|interpolated|interpolation|trend";

constexpr std::string_view kUnits =
    "%|s|sec|ms|min|h|seconds|sek|m3/h|m³/h|m^3/h|m3/min|m3/s|nm3/h|nm³/h|sm3/h|l/h|"
    "l/min|l/s|kg/h|kg/s|kg/min|t/h|gpm|usgpm|gal/min|scfm|scfh|cfm|lb/h|lb/hr|lb/min|"
    "klb/h|bbl/d|bpd|mmscfd|°c|degc|deg c|c|grad c|°f|degf|deg f|f|k|bar|mbar|barg|bara|"
    "bar(g)|pa|hpa|kpa|mpa|psi|psig|psia|inh2o|mmh2o|inhg|kg/cm2|mmhg|m|mm|cm|in|ft|a|"
    "ma|v|mv|w|kw|mw|hz|rpm|1/min|u/min|ph|ppm|us/cm|m/s|n|kn|none|-|pct|percent|"
    "prozent|eu|no engunits|kj/kg|kg/m3|l|m3|kg|t|nl/min|unit|units|einheit|engunits";

}  // namespace

Part part_named(std::string_view key) {
  const Part part = part_word(folded(key));
  if (part != Part::kNone) return part;
  return is_quality_name(key) ? Part::kQuality : Part::kNone;
}

Part part_hinted(const std::vector<std::string>& pieces) {
  if (std::ranges::any_of(pieces, is_aim)) return Part::kSp;
  // Its speed is what the controller asks of a drive.
  if (std::ranges::find(pieces, "vfd") != pieces.end()) return Part::kU;
  for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {
    if (is_temperature(*piece)) return Part::kY;
    if (const Part card = part_of_card(*piece); card != Part::kNone) return card;
    for (const PartWord& hint : kHints) {
      if (piece->starts_with(hint.key)) return hint.part;
    }
  }
  return Part::kNone;
}

bool is_value_word(std::string_view key) {
  return is_one_of(key, kValueWords);
}

bool is_unit(std::string_view text) {
  const std::string lower = lower_case(without_brackets(trimmed(text)));
  return is_one_of(lower, kUnits);
}

std::string_view unit_behind(std::string_view cell) {
  const std::size_t digit = cell.find_last_of("0123456789.");
  if (digit == std::string_view::npos) return {};
  const std::size_t blank = cell.find_last_of(" \xA0\xAF");
  // The digit of m3/h belongs to the unit.
  for (const std::size_t before : {digit, blank}) {
    if (before == std::string_view::npos || before + 1 >= cell.size()) continue;
    const std::string_view unit = without_blanks(cell.substr(before + 1));
    if (is_unit(unit) && unit[0] != '-') return unit;
  }
  return {};
}

std::string_view without_brackets(std::string_view unit) {
  unit = trimmed(unit);
  if (unit.size() >= 2 && ((unit.front() == '[' && unit.back() == ']') ||
                           (unit.front() == '(' && unit.back() == ')') ||
                           (unit.front() == '{' && unit.back() == '}'))) {
    unit = trimmed(unit.substr(1, unit.size() - 2));
  }
  return unit;
}

}  // namespace workbench
