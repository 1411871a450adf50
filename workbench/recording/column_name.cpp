#include "workbench/recording/column_name.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "wire/text.hpp"
#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/spelling/instrument_tag.hpp"
#include "workbench/recording/spelling/quality_words.hpp"
#include "workbench/recording/text_encoding.hpp"
#include "workbench/recording/time_unit.hpp"

namespace workbench {
namespace {

using namespace std::string_view_literals;

constexpr bool is_word_byte(char c) {
  return is_letter_byte(c) || is_digit(c);
}

std::string key_of(std::string_view text) {
  std::string key;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\xC3' && i + 1 < text.size()) {
      switch (text[++i]) {
        case '\xA4':
        case '\x84':
          key += "ae";
          break;
        case '\xB6':
        case '\x96':
          key += "oe";
          break;
        case '\xBC':
        case '\x9C':
          key += "ue";
          break;
        case '\x9F':
          key += "ss";
          break;
        default:
          key += c;
          key += text[i];
      }
    } else if (is_word_byte(c)) {
      key += lower_case(c);
    }
  }
  return key;
}

struct NamePiece {
  std::size_t begin;
  std::size_t end;
};

std::vector<NamePiece> pieces_of(std::string_view text) {
  std::vector<NamePiece> pieces;
  std::size_t at = 0;
  while (at < text.size()) {
    while (at < text.size() && !is_word_byte(text[at])) ++at;
    const std::size_t begin = at;
    while (at < text.size() && is_word_byte(text[at])) ++at;
    if (at > begin) pieces.push_back({begin, at});
  }
  return pieces;
}

std::string_view without_trailing(std::string_view text, std::string_view bytes) {
  while (!text.empty() && bytes.find(text.back()) != std::string_view::npos) {
    text.remove_suffix(1);
  }
  return text;
}

constexpr std::size_t kLongestUnit = 16;
// Of a longer name no units are cut: it may have as many brackets.
constexpr std::size_t kLongestName = 300;

// Words that make of a signal something that is none: its quality, its time.
bool says_other(std::string_view text) {
  for (const NamePiece& piece : pieces_of(text)) {
    const std::string key = key_of(text.substr(piece.begin, piece.end - piece.begin));
    const Part part = part_named(key);
    if (part == Part::kQuality || part == Part::kTime || is_value_word(key)) return true;
  }
  return false;
}

// FIC101.UNIT1@NET0: the name of a point of Ovation, where it is, and what follows.
void cut_address(std::string& name) {
  const std::size_t at = name.find('@');
  if (at == std::string::npos) return;
  const std::size_t dot = name.rfind('.', at);
  if (dot == std::string::npos || dot == 0) return;
  // FIC101.PV@1s avg: how the values were made.
  const Part part = part_named(key_of(name.substr(dot + 1, at - dot - 1)));
  if (is_signal(part)) return name.resize(at);
  name.erase(dot, std::min(name.find_first_of(" ,;", at), name.size()) - dot);
}

// A unit in brackets at the end; words that say more about the signal stay in the name.
void cut_bracketed_unit(std::string& name, std::string& unit) {
  constexpr std::array<std::pair<char, char>, 3> kBrackets = {
      {{'[', ']'}, {'(', ')'}, {'{', '}'}}};
  for (const auto& [open, close] : kBrackets) {
    if (name.empty() || name.back() != close) continue;
    std::size_t depth = 1;
    std::size_t at = name.size() - 1;
    while (at > 0 && depth > 0) {
      --at;
      if (name[at] == close) ++depth;
      if (name[at] == open) --depth;
    }
    if (depth > 0 || at == 0) return;
    const std::string inside(
        trimmed(std::string_view(name).substr(at + 1, name.size() - at - 2)));
    const std::string key = key_of(inside);
    const ColumnName alone = column_name(inside);
    if (is_signal(alone.part) && !alone.tag.empty()) {  // Reactor flow (FIC101.PV)
      name = inside;
      return;
    }
    // pos (4) is the fourth of its kind.
    const bool counts = std::ranges::all_of(inside, wire::is_digit);
    const bool says_more =
        !is_unit(inside) && seconds_of_unit(inside) == 0 &&
        (part_named(key) != Part::kNone || is_value_word(key) || counts);
    if (says_more) {
      name[at] = ' ';
      name.back() = ' ';
    } else {
      unit = inside;
      name.resize(at);
    }
    name = std::string(trimmed(name));
    return;
  }
}

// A unit without brackets: "OP, %", "Zeit in s", "PID1/PV.CV GPM", "PV m3/h", "t / s".
void cut_bare_unit(std::string& name, std::string& unit) {
  const auto cut = [&](std::size_t end, std::size_t begin) {
    unit = std::string(trimmed(std::string_view(name).substr(begin)));
    name = std::string(without_trailing(std::string_view(name).substr(0, end), " ,/"));
  };
  for (const std::string_view between : {", "sv, " in "sv, " / "sv, ","sv, "/"sv}) {
    const std::size_t at = name.rfind(between);
    if (at == std::string::npos || at == 0) continue;
    const std::string_view tail = std::string_view(name).substr(at + between.size());
    // OP/% is a part and its unit, FIC101/PV and "OUT gal/min" are not.
    const std::string head = key_of(std::string_view(name).substr(0, at));
    const bool fits = between != "/" || (part_named(head) != Part::kNone &&
                                         part_named(key_of(tail)) == Part::kNone);
    const bool of_time = between == " in " && seconds_of_unit(tail) > 0;
    if ((is_unit(tail) || of_time) && fits) return cut(at, at + between.size());
  }
  const std::size_t first = name.find(' ');
  if (first == std::string::npos) return;
  const std::string_view tag = std::string_view(name).substr(0, first);
  const std::string_view rest = trimmed(std::string_view(name).substr(first));
  const bool least = key_of(rest) == "min";  // beside Max: no minutes
  if (is_unit(rest) && !least && part_named(key_of(rest)) == Part::kNone) {
    return cut(first, first + 1);
  }
  // FIC101.PV and a unit or a description; "FIC101.PV Quality" is something else.
  if (tag.find_first_of("./\\") != std::string_view::npos && !says_other(rest) &&
      is_signal(column_name(tag).part)) {
    const bool is_short =
        rest.size() <= kLongestUnit && rest[0] != '-' && !least && key_of(rest) != "max";
    if (is_short) return cut(first, first + 1);
    name.resize(first);
    return;
  }
  const std::size_t last = name.rfind(' ');
  const std::string_view tail = std::string_view(name).substr(last + 1);
  if (key_of(tail) == "min") return;  // beside Max: the least, no minutes
  if (is_unit(tail) && part_named(key_of(tail)) == Part::kNone) cut(last, last + 1);
}

// Time_ms, t_s, "Zeit min": a time column with its unit as the last piece.
bool cut_time_unit(std::string& name, std::string& unit) {
  const std::vector<NamePiece> pieces = pieces_of(name);
  if (pieces.size() < 2 || !is_word_byte(name.back())) return false;
  const std::string last = name.substr(pieces.back().begin);
  const std::string rest = name.substr(0, pieces[pieces.size() - 2].end);
  if (seconds_of_unit(last) <= 0 || part_named(key_of(rest)) != Part::kTime) return false;
  unit = last;
  name = rest;
  return true;
}

// The part that the last piece is, or the last two or three together.
struct EndPart {
  Part part = Part::kNone;
  std::size_t before = 0;  // pieces in front of it
};

EndPart end_part(const std::vector<std::string>& keys) {
  for (const std::size_t count : {std::size_t{3}, std::size_t{2}, std::size_t{1}}) {
    if (keys.size() < count) continue;
    std::string joined;
    for (std::size_t i = keys.size() - count; i < keys.size(); ++i) joined += keys[i];
    const Part part = part_named(joined);
    // Quality Code and the like are of what stands before them.
    if (count > 1 && part == Part::kQuality && !is_sure_quality_name(joined)) continue;
    const bool lone_letter = joined.size() == 1 && joined != "q" && keys.size() > count;
    if (part != Part::kNone && !lone_letter) return {part, keys.size() - count};
  }
  return {};
}

// FIC101.OP_IP_TREND_VALUE: the value of a tag in the history of IP.21.
void cut_field_of_history(std::vector<std::string>& keys) {
  constexpr std::array kField = {"ip"sv, "trend"sv, "value"sv};
  const bool has = keys.size() > kField.size() &&
                   std::equal(kField.rbegin(), kField.rend(), keys.rbegin());
  if (!has) return;
  const std::vector<std::string> inner(keys.begin(), keys.end() - kField.size());
  if (is_signal(end_part(inner).part)) keys = inner;
}

// The part at the end of a name, less the words there that only say that it is a value.
EndPart signal_part(std::vector<std::string>& keys) {
  cut_field_of_history(keys);
  // F_CV, A_CV: the current value of a block, as a number or as text.
  if (keys.size() > 2 && keys.back() == "cv" && keys[keys.size() - 2].size() == 1) {
    keys.resize(keys.size() - 2);
  }
  EndPart end = end_part(keys);
  while (!is_signal(end.part) && end.part != Part::kTime && keys.size() > 1 &&
         is_value_word(keys.back())) {
    const EndPart whole = end;
    keys.pop_back();
    end = end_part(keys);
    if (!is_signal(end.part) && end.part != Part::kTime) end = whole;
  }
  // FIC101.OP.CV is OP, but a block's own CV is its output.
  if (end.part == Part::kU && keys.back() == "cv" && keys.size() > 1) {
    const std::vector<std::string> inner(keys.begin(), keys.end() - 1);
    if (is_signal(end_part(inner).part)) {
      keys.pop_back();
      end = end_part(keys);
    }
  }
  return end;
}

// The signal that the first pieces are, with others behind them; `before` counts them.
EndPart front_part(const std::vector<std::string>& keys) {
  for (const std::size_t count : {std::size_t{3}, std::size_t{2}, std::size_t{1}}) {
    if (keys.size() <= count) continue;
    std::string joined;
    for (std::size_t i = 0; i < count; ++i) joined += keys[i];
    const Part part = part_named(joined);
    if (joined.size() > 1 && part != Part::kX && is_signal(part)) return {part, count};
  }
  return {};
}

// rOut, fPV, lrSetpoint: the type of a variable of IEC 61131-3 before its name.
std::string_view without_type(std::string_view piece) {
  for (const std::string_view type :
       {"lr"sv, "di"sv, "r"sv, "f"sv, "i"sv, "n"sv, "w"sv}) {
    if (!piece.starts_with(type) || piece.size() <= type.size()) continue;
    const std::string_view rest = piece.substr(type.size());
    if (is_capital(rest[0]) && is_signal(part_named(key_of(rest)))) {
      return rest;
    }
  }
  return piece;
}

// FT_211 and FV_211, as they are or with a word for the value: loop F_211.
bool take_instrument(const std::string& name, const std::vector<NamePiece>& pieces,
                     ColumnName& out) {
  std::vector<std::string> keys = out.pieces;
  while (keys.size() > 1 && is_value_word(keys.back())) keys.pop_back();
  const std::optional<InstrumentTag> found = instrument_tag(keys);
  if (!found) return false;
  const NamePiece& letters = pieces[found->piece];
  std::size_t behind = letters.begin;
  while (behind < letters.end && (name[behind] < '0' || name[behind] > '9')) ++behind;
  out.part = found->part;
  out.tag = out.loop = found->tag;
  out.prefix = name.substr(0, letters.begin + 1) +
               name.substr(behind, pieces[keys.size() - 1].end - behind);
  out.by_letters = true;
  return true;
}

// The part at the end of a name, and the tag before it.
void take_end(const EndPart& end, const std::string& name,
              const std::vector<NamePiece>& pieces, ColumnName& out) {
  out.part = end.part;
  const std::size_t before = std::min(end.before, out.pieces.size());
  if (before == 0) return;
  for (std::size_t i = 0; i < before; ++i) out.tag += out.pieces[i];
  out.loop = loop_of_tag(std::span(out.pieces).first(before));
  out.prefix = std::string(
      without_trailing(std::string_view(name).substr(0, pieces[before - 1].end), " "));
}

}  // namespace

std::optional<Column> role_of(std::string_view name) {
  constexpr std::array kNames = {"t"sv, "u|op"sv, "y|pv"sv, "sp"sv, "x|mv|pos"sv};
  const std::string lower = lower_case(name);
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (is_one_of(lower, kNames[i])) return static_cast<Column>(i);
  }
  return std::nullopt;
}

std::string with_aliases(Column column) {
  constexpr std::array kNames = {"a column t (time in seconds)", "a column u (or OP)",
                                 "a column y (or PV)", "a column sp",
                                 "a column x (or MV, POS)"};
  return kNames[static_cast<std::size_t>(column)];
}

ColumnName column_name(std::string_view text) {
  ColumnName out;
  out.text = utf8_of(trimmed(text));
  std::ranges::replace_if(
      out.text, [](char c) { return is_line_end(c); }, ' ');
  std::string name = out.text;
  if (cut_time_unit(name, out.unit)) {
    out.key = out.loop = key_of(name);
    out.pieces = {out.key};
    out.part = Part::kTime;
    return out;
  }
  cut_address(name);
  if (name.size() <= kLongestName) {
    cut_bracketed_unit(name, out.unit);
    if (out.unit.empty()) cut_bare_unit(name, out.unit);
  }

  std::vector<NamePiece> pieces = pieces_of(name);
  std::vector<std::string> keys;
  for (const NamePiece& piece : pieces) {
    const std::string_view word =
        std::string_view(name).substr(piece.begin, piece.end - piece.begin);
    keys.push_back(key_of(&piece == &pieces.back() ? without_type(word) : word));
  }
  // PID_Compact and its like call what they control their input.
  if (keys.size() > 1 && keys.back() == "input" &&
      std::ranges::find(keys, "pid") != keys.end()) {
    keys.back() = "pv";
  }
  if (keys.empty()) return out;
  const EndPart end = signal_part(keys);
  out.words_cut = pieces.size() - keys.size();
  for (const std::string& key : keys) out.key += key;
  out.pieces = keys;
  out.loop = keys.front();
  if (end.part == Part::kValue && take_instrument(name, pieces, out)) return out;
  if (end.part != Part::kNone) {
    take_end(end, name, pieces, out);
    return out;
  }
  if (const EndPart front = front_part(keys); front.part != Part::kNone) {
    const std::size_t behind = front.before;
    out.part = front.part;
    // Stellgröße Y, Regelgröße X: the letter of the control loop is no tag.
    if (keys.size() == behind + 1 && keys[behind].size() == 1) return out;
    for (std::size_t i = behind; i < keys.size(); ++i) out.tag += keys[i];
    out.prefix = name.substr(pieces[behind].begin);
    out.loop = loop_of_tag(std::span(keys).subspan(behind));
    return out;
  }
  take_instrument(name, pieces, out);
  return out;
}

}  // namespace workbench
