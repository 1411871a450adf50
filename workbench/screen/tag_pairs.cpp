#include "workbench/screen/tag_pairs.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <unordered_map>

#include "workbench/recording/cell_reader.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/signal_suggestion.hpp"
#include "workbench/recording/text_encoding.hpp"
#include "workbench/recording/text_file.hpp"

namespace workbench {
namespace {

constexpr std::size_t kLongestList = std::size_t{16} << 20;

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> out;
  while (true) {
    const std::size_t end = std::min(text.find(separator), text.size());
    out.emplace_back(trimmed(text.substr(0, end)));
    if (end == text.size()) return out;
    text.remove_prefix(end + 1);
  }
}

PairRules::Rule rule_of(const std::vector<std::string>& parts) {
  return {parts[0], parts[1], parts.size() > 2 ? parts[2] : "",
          parts.size() > 3 ? parts[3] : ""};
}

// What * stands for where `name` fits `pattern`; both in lower case.
std::optional<std::string> star_of(const std::string& pattern, const std::string& name) {
  const std::size_t star = pattern.find('*');
  const std::size_t behind = pattern.size() - star - 1;
  if (name.size() + 1 <= pattern.size() || name.compare(0, star, pattern, 0, star) != 0 ||
      name.compare(name.size() - behind, behind, pattern, star + 1) != 0) {
    return std::nullopt;
  }
  return name.substr(star, name.size() - star - behind);
}

bool is_starred(const PairRules::Rule& rule) {
  return rule.u.find('*') != std::string::npos;
}

std::string with_star(const std::string& pattern, const std::string& star) {
  std::string out = pattern;
  return out.replace(out.find('*'), 1, star);
}

PairRules read_list(const std::string& path) {
  const std::string bytes = read_text_file(path, kLongestList);
  std::string converted;
  const std::string_view text = text_of(bytes, path, converted);
  CellReader reader(text, path);
  const std::string_view head = reader.rest_of_line();
  const char separator = head.find(';') != std::string_view::npos    ? ';'
                         : head.find('\t') != std::string_view::npos ? '\t'
                                                                     : ',';
  std::map<std::string, std::size_t> column_of;
  for (const LineCell& cell : split_line(head, separator)) {
    column_of.try_emplace(lower_case(cell.text), column_of.size());
  }
  for (const char* needed : {"loop", "u", "y"}) {
    if (!column_of.contains(needed)) {
      throw InputError(path, 1, 1, "the columns loop, u and y, perhaps sp and x",
                       workbench::quoted(head), "write them into the first line");
    }
  }
  PairRules out;
  reader.skip_rest_of_line();
  while (reader.next_line(), !reader.at_end()) {
    const std::size_t line = reader.line();
    const std::vector<LineCell> cells = split_line(reader.rest_of_line(), separator);
    reader.skip_rest_of_line();
    const auto cell = [&](const char* name) {
      const auto at = column_of.find(name);
      return at == column_of.end() || at->second >= cells.size()
                 ? std::string()
                 : std::string(cells[at->second].text);
    };
    if (cells.size() == 1 && cells[0].text.empty()) continue;
    if (cell("loop").empty() || cell("u").empty() || cell("y").empty()) {
      throw InputError(path, line, 1, "a loop with the names of its u and y",
                       "an empty cell", "complete or remove the line");
    }
    out.list.push_back({cell("loop"), {cell("u"), cell("y"), cell("sp"), cell("x")}});
  }
  if (out.list.empty()) {
    throw InputError(path, 2, 0, "loops, one a line", "none", "write them");
  }
  return out;
}

// Signals of one tag by part.
struct Parts {
  std::string prefix;
  std::map<Part, std::vector<std::size_t>> of;
};

class Pairer {
 public:
  explicit Pairer(const std::vector<NamedSignal>& candidates)
      : candidates_(candidates), used_(candidates.size(), false) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      by_name_.try_emplace(lower_case(candidates[i].name.text), i);
      by_key_.try_emplace(candidates[i].name.key, i);
    }
  }

  void take_list(const std::vector<PairRules::Named>& list) {
    for (const PairRules::Named& named : list) {
      const auto u = find(named.tags.u);
      const auto y = find(named.tags.y);
      if (u && y) add({named.loop, *u, *y, find(named.tags.sp), find(named.tags.x)});
    }
  }

  // `alone`: the one rule there is; the file names its loop.
  void take_rule(const PairRules::Rule& rule, bool alone) {
    if (!is_starred(rule)) {
      const auto u = find(rule.u);
      const auto y = find(rule.y);
      if (u && y && *u != *y) {
        add({alone ? "" : candidates_[*u].name.text, *u, *y, find(rule.sp),
             find(rule.x)});
      }
      return;
    }
    const std::string pattern = lower_case(rule.u);
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (used_[i]) continue;
      const std::string& text = candidates_[i].name.text;
      const auto star = star_of(pattern, lower_case(text));
      if (!star) continue;
      const auto other = [&](const std::string& wanted) -> std::optional<std::size_t> {
        if (wanted.empty()) return std::nullopt;
        const auto at = by_name_.find(with_star(lower_case(wanted), *star));
        if (at == by_name_.end()) return std::nullopt;
        return at->second;
      };
      const auto y = other(rule.y);
      if (!y || *y == i) continue;
      add({text.substr(pattern.find('*'), star->size()), i, *y, other(rule.sp),
           other(rule.x)});
    }
  }

  void take_usual_names() {
    for (const bool by_loop : {false, true}) {
      for (Parts& parts : grouped(by_loop)) take(parts);
    }
  }

  TagPairs finish() {
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const NamedSignal& signal = candidates_[i];
      const Part part = signal.name.part;
      if (!used_[i] && signal.measured && part != Part::kTime && part != Part::kQuality &&
          part != Part::kMillis && !signal.name.text.empty()) {
        out_.unpaired.push_back(i);
      }
    }
    std::ranges::sort(out_.loops, [](const TagLoop& a, const TagLoop& b) {
      return std::min(a.u, a.y) < std::min(b.u, b.y);
    });
    return std::move(out_);
  }

 private:
  [[nodiscard]] std::optional<std::size_t> find(const std::string& name) const {
    if (name.empty()) return std::nullopt;
    for (std::size_t i = 0; i < candidates_.size() && name[0] == '#'; ++i) {
      if (name == '#' + std::to_string(candidates_[i].number)) return i;
    }
    if (const auto at = by_name_.find(lower_case(name)); at != by_name_.end()) {
      return at->second;
    }
    const std::string key = column_name(name).key;
    const auto at = by_key_.find(key);
    if (key.empty() || at == by_key_.end()) return std::nullopt;
    return at->second;
  }

  void add(TagLoop loop) {
    used_[loop.u] = used_[loop.y] = true;
    if (loop.sp) used_[*loop.sp] = true;
    if (loop.x) used_[*loop.x] = true;
    out_.loops.push_back(std::move(loop));
  }

  [[nodiscard]] std::vector<Parts> grouped(bool by_loop) const {
    std::vector<Parts> out;
    std::unordered_map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const ColumnName& name = candidates_[i].name;
      if (!is_signal(name.part) || used_[i] || !candidates_[i].measured) continue;
      const std::string& key = by_loop ? name.loop : name.tag;
      const auto [at, is_new] = known.try_emplace(key, out.size());
      if (is_new) out.push_back({name.prefix, {}});
      out[at->second].of[name.part].push_back(i);
    }
    return out;
  }

  void doubt(const Parts& parts, std::size_t one, std::size_t other) {
    const std::string text = parts.prefix + ": both " +
                             workbench::quoted(candidates_[one].name.text) + " and " +
                             workbench::quoted(candidates_[other].name.text);
    if (std::ranges::count(out_.doubts, text) == 0) out_.doubts.push_back(text);
  }

  // The one of several that has the plainest name: FIC101.OP before FIC101.OUT.
  [[nodiscard]] std::optional<std::size_t> one_of(const Parts& parts, Part part) {
    const auto at = parts.of.find(part);
    if (at == parts.of.end()) return std::nullopt;
    std::vector<std::size_t> best;
    for (const std::size_t i : at->second) {
      const ColumnName& name = candidates_[i].name;
      for (const char* word : {"u", "op", "y", "pv", "sp", "x", "pos", "mv"}) {
        if (name.key == name.tag + word) best.push_back(i);
      }
    }
    if (best.empty()) best = at->second;
    if (best.size() > 1 && (part == Part::kU || part == Part::kY)) {
      doubt(parts, best[0], best[1]);
      return std::nullopt;
    }
    return best[0];
  }

  void take(Parts& parts) {
    if (const auto mv = parts.of.find(Part::kMv); mv != parts.of.end()) {
      const auto cv = parts.of.find(Part::kU);
      if (cv != parts.of.end() && is_only_cv(candidates_, cv->second) &&
          parts.of.contains(Part::kY)) {
        doubt(parts, cv->second[0], mv->second[0]);
        return;
      }
      const Part part = parts.of.contains(Part::kU) ? Part::kX : Part::kU;
      parts.of.try_emplace(part, mv->second);
    }
    if (!parts.of.contains(Part::kU) || !parts.of.contains(Part::kY)) return;
    const auto u = one_of(parts, Part::kU);
    const auto y = one_of(parts, Part::kY);
    if (!u || !y) return;
    add({parts.prefix, *u, *y, one_of(parts, Part::kSp), one_of(parts, Part::kX)});
  }

  const std::vector<NamedSignal>& candidates_;
  std::vector<bool> used_;
  std::unordered_map<std::string, std::size_t> by_name_;
  std::unordered_map<std::string, std::size_t> by_key_;
  TagPairs out_;
};

}  // namespace

PairRules PairRules::parse(const std::string& text) {
  std::error_code ignored;
  if (text.find('*') == std::string::npos && std::filesystem::exists(text, ignored)) {
    return read_list(text);
  }
  PairRules out;
  // A list that is not there is no rule for a column of its name.
  const bool is_list = lower_case(text).ends_with(".csv");
  for (const std::string& rule : split(text, ',')) {
    const std::vector<std::string> parts = split(rule, '/');
    const auto stars = std::ranges::count(parts[0], '*');
    const bool alike = std::ranges::all_of(parts, [stars](const auto& part) {
      return !part.empty() && std::ranges::count(part, '*') == stars;
    });
    if (parts.size() < 2 || parts.size() > 4 || !alike || stars > 1 || is_list) {
      throw std::invalid_argument(
          "--pairs: expected rules such as *.OP/*.PV/*.SP (u, y, perhaps sp and x, one * "
          "each for the tag) or LV_106/FT_115, or a CSV file with the columns loop, u, "
          "y; found " +
          workbench::quoted(rule));
    }
    out.rules.push_back(rule_of(parts));
  }
  return out;
}

TagPairs pair_tags(const std::vector<NamedSignal>& candidates, const PairRules& rules) {
  Pairer pairer(candidates);
  if (!rules.list.empty()) {
    pairer.take_list(rules.list);
  } else {
    for (const PairRules::Rule& rule : rules.rules) {
      pairer.take_rule(rule, rules.rules.size() == 1);
    }
    pairer.take_usual_names();
  }
  return pairer.finish();
}

}  // namespace workbench
