#include "workbench/recording/spelling/instrument_tag.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

// 211, 211a: of a loop, and perhaps one of several alike.
bool is_number(std::string_view text) {
  const auto digits =
      static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin());
  return digits >= 2 && text.size() <= digits + 1;
}

Part part_of_letters(std::string_view letters) {
  constexpr std::string_view kMeasured = "fltpad";
  if (letters.size() < 2 || kMeasured.find(letters[0]) == std::string_view::npos ||
      part_named(letters) != Part::kNone) {
    return Part::kNone;
  }
  const std::string_view does = letters.substr(1);
  if (does == "t" || does == "it" || does == "i") return Part::kY;
  return does == "v" || does == "cv" ? Part::kU : Part::kNone;
}

// Blocks and devices that every loop may have.
constexpr std::string_view kRoles =
    "pid|pida|pidb|pidl|pidconl|pidconr|daca|dacb|dataacq|dataacqa|regctl|regctla|ai|ao|"
    "ain|aout|di|do|in|ctl|ctrl|ctr|con|control|contr|controller|regler|regulator|loop|"
    "regelkreis|measure|measurement|messung|sensor|transmitter|valve|ventil|actuator|"
    "positioner|process|plant|mon|monanl|block|faceplate";

bool is_role(std::string_view piece) {
  return is_one_of(piece, kRoles) || is_signal(part_named(piece));
}

// Servers and stations whose names look like those of instruments.
bool is_station(std::string_view letters) {
  constexpr std::string_view kStations = "plc|dcs|srv|svc";
  return any_word(kStations,
                  [letters](std::string_view s) { return letters.ends_with(s); });
}

// FIC, PDIC, LT, FCV: a variable, what modifies it, and what is done with it (ISA-5.1).
bool is_instrument(std::string_view letters, std::size_t digits) {
  constexpr std::string_view kVariables = "acdefhilmpqstuvwxyz";
  constexpr std::string_view kFunctions = "dfiqracskhlztvy";
  constexpr std::string_view kLast = "civty";
  constexpr std::size_t kMostLetters = 5;
  if (letters.size() < 2 || letters.size() > kMostLetters || is_role(letters) ||
      is_station(letters)) {
    return false;
  }
  const bool controls = letters.ends_with("ic") && letters.size() > 2;
  const bool shaped =
      kVariables.find(letters.front()) != std::string_view::npos &&
      letters.find_first_not_of(kFunctions, 1) == std::string_view::npos &&
      kLast.find(letters.back()) != std::string_view::npos;
  return shaped && digits >= (controls ? 1U : 2U);
}

std::string_view digits_in_front(std::string_view text) {
  const auto end = std::ranges::find_if_not(text, is_digit);
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

// 101, 101a, b: what numbers an instrument or one of several alike.
bool counts_on(std::string_view piece) {
  const std::size_t digits = digits_in_front(piece).size();
  return piece.size() <= digits + 1;
}

// Of the instrument that begins at a piece: its loop, and the piece behind it.
struct Instrument {
  std::string loop;
  std::size_t end = 0;  // 0: none begins here
};

Instrument instrument_at(std::span<const std::string> pieces, std::size_t at) {
  std::string_view text = pieces[at];
  const std::string_view unit = digits_in_front(text);
  text.remove_prefix(unit.size());
  const auto letters_end = std::ranges::find_if(text, is_digit);
  const std::string_view letters =
      text.substr(0, static_cast<std::size_t>(letters_end - text.begin()));
  std::string_view number = text.substr(letters.size());
  std::size_t end = at + 1;
  if (number.empty() && end < pieces.size()) number = pieces[end++];
  const std::size_t digits = digits_in_front(number).size();
  if (!is_instrument(letters, digits) || number.size() > digits + 1) return {};
  const std::size_t variable = letters[1] == 'd' ? 2 : 1;
  Instrument out{
      std::string(unit) + std::string(letters.substr(0, variable)) + std::string(number),
      end};
  while (out.end < pieces.size() && counts_on(pieces[out.end])) {
    out.loop += pieces[out.end++];
  }
  return out;
}

std::string joined(std::span<const std::string> pieces) {
  std::string out;
  for (const std::string& piece : pieces) out += piece;
  return out;
}

}  // namespace

std::optional<InstrumentTag> instrument_tag(const std::vector<std::string>& pieces) {
  if (pieces.empty()) return std::nullopt;
  std::size_t piece = pieces.size() - 1;
  std::string letters = pieces[piece];
  std::string number;
  if (is_number(letters) && piece > 0) {
    number = letters;
    letters = pieces[--piece];
  } else {
    const auto end = std::ranges::find_if(letters, is_digit);
    number.assign(end, letters.end());
    letters.erase(end, letters.end());
  }
  const Part part = part_of_letters(letters);
  if (part == Part::kNone || !is_number(number)) return std::nullopt;
  InstrumentTag out{part, {}, piece};
  for (std::size_t i = 0; i < piece; ++i) out.tag += pieces[i];
  out.tag += letters.front() + number;
  return out;
}

std::optional<std::string> loop_of_instrument(std::span<const std::string> pieces) {
  for (std::size_t at = pieces.size(); at-- > 0;) {
    const Instrument found = instrument_at(pieces, at);
    if (found.end > 0) return joined(pieces.first(at)) + found.loop;
  }
  return std::nullopt;
}

std::string loop_of_tag(std::span<const std::string> pieces) {
  if (const std::optional<std::string> loop = loop_of_instrument(pieces)) return *loop;
  while (pieces.size() > 1 && is_role(pieces.back())) {
    pieces = pieces.first(pieces.size() - 1);
  }
  return joined(pieces);
}

}  // namespace workbench
