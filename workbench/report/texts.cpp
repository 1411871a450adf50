#include "workbench/report/texts.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "workbench/recording/letters.hpp"

namespace workbench {
namespace {

constexpr std::size_t kShort = 7;
constexpr std::size_t kShortCount = 10;  // "3 backlash"
constexpr std::string_view kNoBreakSpace = "\u00a0";
// How the language writes 1.5.
constexpr std::string_view kMarked = "1.5";

// One string of a script from its quote on; moves `at` behind it.
bool read_quoted(std::string_view line, std::size_t& at, std::string& out) {
  if (at >= line.size() || line[at] != '\'') return false;
  for (++at; at < line.size(); ++at) {
    if (line[at] == '\'') {
      ++at;
      return true;
    }
    if (line[at] == '\\' && ++at == line.size()) return false;
    out += line[at];
  }
  return false;
}

// Where a gap begins: {0} … {9}.
std::size_t next_gap(std::string_view text, std::size_t from) {
  for (std::size_t i = from; i + 2 < text.size(); ++i) {
    if (text[i] == '{' && is_digit(text[i + 1]) && text[i + 2] == '}') return i;
  }
  return std::string_view::npos;
}

// White space as the page takes it: runs of it are one blank.
std::string with_single_blanks(std::string_view text) {
  std::string out;
  bool blank = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool wide = text.substr(i).starts_with(kNoBreakSpace);
    if (wide || std::isspace(static_cast<unsigned char>(text[i])) != 0) {
      blank = true;
      if (wide) ++i;
      continue;
    }
    if (blank && !out.empty()) out += ' ';
    blank = false;
    out += text[i];
  }
  return out;
}

// A capital of ASCII, or one of Ä, Ö, Ü.
bool begins_with_capital(std::string_view text) {
  if (text.empty()) return false;
  if (text[0] >= 'A' && text[0] <= 'Z') return true;
  return text.starts_with("Ä") || text.starts_with("Ö") || text.starts_with("Ü");
}

// True where a sentence ends at `i`, a blank, and another begins.
bool ends_sentence(std::string_view text, std::size_t i) {
  return i > 0 && text[i] == ' ' &&
         (text[i - 1] == '.' || text[i - 1] == '!' || text[i - 1] == '?') &&
         begins_with_capital(text.substr(i + 1));
}

std::vector<std::string_view> sentences_of(std::string_view text) {
  std::vector<std::string_view> out;
  std::size_t from = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!ends_sentence(text, i)) continue;
    out.push_back(text.substr(from, i - from));
    from = i + 1;
  }
  out.push_back(text.substr(from));
  return out;
}

// "valve.stiction"
bool is_code(std::string_view name) {
  const std::size_t dot = name.find('.');
  return dot != std::string_view::npos && dot > 0 && dot + 1 < name.size() &&
         name.find(' ') == std::string_view::npos;
}

// "3", not "+".
bool is_word(std::string_view text) {
  return text != "+" && text.find(' ') == std::string_view::npos;
}

// Each gap takes as little as it can so that the rest still fits.
bool fits(std::span<const std::string> pieces, bool words, std::string_view text,
          std::vector<std::string_view>& taken) {
  if (!text.starts_with(pieces[0])) return false;
  text.remove_prefix(pieces[0].size());
  pieces = pieces.subspan(1);
  if (pieces.empty()) return text.empty();
  const std::string& next = pieces[0];
  // The last piece ends the text.
  if (pieces.size() == 1) {
    if (text.size() <= next.size() || !text.ends_with(next)) return false;
    const std::string_view gap = text.substr(0, text.size() - next.size());
    if (words && !is_word(gap)) return false;
    taken.push_back(gap);
    return true;
  }
  for (std::size_t length = 1; length <= text.size(); ++length) {
    if (words && text[length - 1] == ' ') return false;
    if (!next.empty()) {
      length = text.find(next, length);
      if (length == std::string_view::npos) return false;
      if (words && !is_word(text.substr(0, length))) return false;
    }
    taken.push_back(text.substr(0, length));
    if (fits(pieces, words, text.substr(length), taken)) return true;
    taken.pop_back();
  }
  return false;
}

}  // namespace

std::string capitalised(std::string text) {
  if (text.empty()) return text;
  const auto first = static_cast<unsigned char>(text[0]);
  if (first >= 'a' && first <= 'z') {
    text[0] = static_cast<char>(first - 'a' + 'A');
  } else if (first == 0xC3 && text.size() > 1 &&
             static_cast<unsigned char>(text[1]) >= 0xA0) {
    text[1] = static_cast<char>(static_cast<unsigned char>(text[1]) - 0x20);
  }
  return text;
}

void Texts::take(std::string_view script) {
  while (!script.empty()) {
    const std::string_view line = wire::take_until(script, '\n');
    std::size_t at = std::min(line.find_first_not_of(' '), line.size());
    Entry entry;
    if (!read_quoted(line, at, entry.key) || line.substr(at, 2) != ": ") continue;
    at += 2;
    if (!read_quoted(line, at, entry.other)) continue;
    const auto [place, added] = places_.try_emplace(entry.key, entries_.size());
    if (added) {
      entries_.push_back(std::move(entry));
      add_pattern(place->second);
    } else {
      entries_[place->second].other = std::move(entry.other);
    }
  }
  std::ranges::stable_sort(
      patterns_, [](const Pattern& a, const Pattern& b) { return a.fixed > b.fixed; });
}

void Texts::add_pattern(std::size_t entry) {
  const std::string& key = entries_[entry].key;
  Pattern pattern;
  pattern.entry = entry;
  std::size_t from = 0;
  for (std::size_t gap = next_gap(key, 0); gap != std::string::npos;
       gap = next_gap(key, from)) {
    pattern.pieces.push_back(key.substr(from, gap - from));
    pattern.gaps.push_back(static_cast<std::size_t>(key[gap + 1] - '0'));
    from = gap + 3;
  }
  if (pattern.gaps.empty()) return;
  pattern.pieces.push_back(key.substr(from));
  for (const std::string& piece : pattern.pieces) pattern.fixed += characters(piece);
  const char first = key.front();
  const bool counts = pattern.pieces[0].empty() && pattern.pieces[1].starts_with(' ') &&
                      key.find(':') == std::string::npos;
  pattern.words = pattern.fixed < (counts ? kShortCount : kShort) &&
                  (first == '{' || first == '_' ||
                   std::isalnum(static_cast<unsigned char>(first)) != 0);
  patterns_.push_back(std::move(pattern));
}

const std::string* Texts::find(std::string_view key) const {
  const auto found = places_.find(std::string(key));
  return found == places_.end() ? nullptr : &entries_[found->second].other;
}

std::string_view Texts::entry(std::string_view key) const {
  const std::string* found = find(key);
  return found == nullptr ? key : std::string_view(*found);
}

bool Texts::filled_in(const Pattern& pattern, std::string_view bare,
                      std::string& out) const {
  std::vector<std::string_view> taken;
  if (!fits(pattern.pieces, pattern.words, bare, taken)) return false;
  // A gap is no place for the end of one sentence and the begin of another.
  for (const std::string_view gap : taken) {
    std::string whole;
    if (sentences_of(gap).size() > 1 && !known(gap, whole)) return false;
  }
  std::array<std::string, 10> values;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    values[pattern.gaps[i]] = translated(taken[i]);
  }
  out.clear();
  const std::string_view other = entries_[pattern.entry].other;
  std::size_t from = 0;
  for (std::size_t gap = next_gap(other, 0); gap != std::string_view::npos;
       gap = next_gap(other, from)) {
    out += other.substr(from, gap - from);
    out += values[static_cast<std::size_t>(other[gap + 1] - '0')];
    from = gap + 3;
  }
  out += other.substr(from);
  return true;
}

bool Texts::known(std::string_view bare, std::string& out) const {
  if (const std::string* found = find(bare)) {
    out = *found;
    return true;
  }
  std::string lower(bare);
  if (!lower.empty() && lower[0] >= 'A' && lower[0] <= 'Z') {
    lower[0] = static_cast<char>(lower[0] - 'A' + 'a');
    if (const std::string* found = find(lower)) {
      out = capitalised(*found);
      return true;
    }
  }
  return std::ranges::any_of(
      patterns_, [&](const Pattern& pattern) { return filled_in(pattern, bare, out); });
}

bool Texts::listed(std::string_view bare, std::string& out) const {
  constexpr std::array<std::string_view, 4> kBetween = {", ", " or ", " and ", " with "};
  std::string text;
  bool several = false;
  while (true) {
    std::size_t end = bare.size();
    std::string_view between;
    for (const std::string_view word : kBetween) {
      const std::size_t at = bare.find(word);
      if (at < end) {
        end = at;
        between = word;
      }
    }
    std::string name;
    if (!known(bare.substr(0, end), name)) {
      if (!is_code(bare.substr(0, end))) return false;
      name = bare.substr(0, end);
    }
    text += name;
    if (between.empty()) break;
    several = true;
    text += entry(between);
    bare.remove_prefix(end + between.size());
  }
  if (several) out = std::move(text);
  return several;
}

std::string Texts::in_turn(std::string_view bare) const {
  const std::vector<std::string_view> sentences = sentences_of(bare);
  const auto between = [&](std::size_t first, std::size_t last) {
    const char* const begin = sentences[first].data();
    return std::string_view(
        begin, static_cast<std::size_t>(sentences[last].data() + sentences[last].size() -
                                        begin));
  };
  std::string out;
  for (std::size_t i = 0; i < sentences.size();) {
    std::string found;
    std::size_t to = sentences.size();
    while (to > i && !known(between(i, to - 1), found)) --to;
    if (i > 0) out += ' ';
    out += to > i ? found : with_mark(sentences[i]);
    i = std::max(to, i + 1);
  }
  return out;
}

std::string Texts::with_mark(std::string_view text) const {
  const std::string_view marked = entry(kMarked);
  const std::string_view mark =
      marked.size() > 2 ? marked.substr(1, marked.size() - 2) : std::string_view(".");
  std::string out;
  bool quoted = false;
  const auto at = [&](std::size_t i) { return i < text.size() ? text[i] : ' '; };
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '\'') {  // what is quoted is the file's own
      quoted = !quoted && text.find('\'', i + 1) != std::string_view::npos;
    }
    if (quoted || !is_digit(text[i])) {
      out += text[i++];
      continue;
    }
    std::size_t end = i;
    while (is_digit(at(end))) ++end;
    std::size_t last = end + 1;
    while (is_digit(at(last))) ++last;
    // No date, no version: one point with digits on both sides.
    const bool alone = i == 0 || text[i - 1] != '.';
    const bool number = at(end) == '.' && last > end + 1 && alone &&
                        !(at(last) == '.' && at(last + 1) != ' ');
    out += text.substr(i, end - i);
    i = end;
    if (!number) continue;
    out += mark;
    out += text.substr(end + 1, last - end - 1);
    i = last;
  }
  return out;
}

std::string Texts::translated(std::string_view text) const {
  const std::string bare = with_single_blanks(text);
  if (bare.empty() || empty()) return std::string(text);
  std::string other;
  if (!known(bare, other) && !listed(bare, other)) other = in_turn(bare);
  const auto is_blank = [](char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
  };
  const auto first = std::ranges::find_if_not(text, is_blank);
  const auto last = std::find_if_not(text.rbegin(), text.rend(), is_blank).base();
  return std::string(text.begin(), first) + other + std::string(last, text.end());
}

}  // namespace workbench
