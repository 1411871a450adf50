#include "workbench/recording/signal_suggestion.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <string_view>

#include "workbench/recording/letters.hpp"
#include "workbench/recording/spelling/instrument_tag.hpp"

namespace workbench {
namespace {

using Indices = std::vector<std::size_t>;

// leftSpeed: left, speed.
std::vector<std::string> words_in(std::string_view text) {
  std::vector<std::string> out;
  bool lower = false;  // the letter before
  for (const char c : text) {
    if (out.empty() || (is_capital(c) && lower)) out.emplace_back();
    out.back() += lower_case(c);
    lower = is_small(c);
  }
  return out;
}

// PV1, FIC101.OP2: a signal with a number behind it.
Part numbered_part(const ColumnName& name) {
  constexpr std::size_t kFewestLetters = 2;
  if (name.part != Part::kNone || name.pieces.empty()) return Part::kNone;
  const std::string& last = name.pieces.back();
  const std::size_t letters = last.find_last_not_of("0123456789") + 1;
  if (letters == last.size() || letters < kFewestLetters) return Part::kNone;
  const Part part = part_named(last.substr(0, letters));
  return is_signal(part) ? part : Part::kNone;
}

Part hint_of(const ColumnName& name) {
  const Part inside = part_hinted(words_in(name.text));
  if (inside == Part::kSp || name.key.ends_with("stpt")) return Part::kSp;
  if (const Part part = numbered_part(name); part != Part::kNone) return part;
  const Part part = part_hinted(name.pieces);
  return part != Part::kNone ? part : inside;
}

auto is_part(Part part) {
  return [part](const NamedSignal& c) { return c.name.part == part; };
}

// The only candidate that holds numbers and fits, and how many do.
template <class Condition>
std::optional<std::size_t> only_one(const std::vector<NamedSignal>& candidates,
                                    const std::vector<bool>& taken, Condition fits) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const NamedSignal& c = candidates[i];
    if (taken[i] || !c.measured || c.empty || !fits(c)) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

class Suggester {
 public:
  Suggester(const std::vector<NamedSignal>& candidates, const std::vector<bool>& taken)
      : candidates_(candidates), taken_(taken) {}

  // A column for each: one whose name says so, or one of the last whose names say
  // nothing.
  [[nodiscard]] Indices suggestions(const std::vector<Column>& wanted) const {
    Indices out(wanted.size(), candidates_.size());
    if (mv_is_open() || input_is_open() || output_is_open()) return out;
    take_din_letters(wanted, out);
    take_positioner(wanted, out);
    for (const bool nameless_too : {false, true}) {
      const auto open = std::ranges::count(out, candidates_.size());
      if (nameless_too && nameless() != static_cast<std::size_t>(open)) break;
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (out[i] == candidates_.size())
          out[i] = suggestion(wanted[i], out, nameless_too);
      }
    }
    take_valve(wanted, out);
    return out;
  }

 private:
  // W, X and Y side by side are the reference, the measured value and the output of DIN
  // 19226, where y of the contract is the measured value.
  void take_din_letters(const std::vector<Column>& wanted, Indices& out) const {
    const auto named = [this](std::string_view key) {
      const auto found = std::ranges::find_if(candidates_, [key](const NamedSignal& c) {
        return c.measured && c.name.key == key;
      });
      return static_cast<std::size_t>(found - candidates_.begin());
    };
    const std::size_t x = named("x");
    const std::size_t y = named("y");
    if (std::max({named("w"), x, y}) == candidates_.size()) return;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (wanted[i] == Column::u && !taken_[y]) out[i] = y;
      if (wanted[i] == Column::y && !taken_[x]) out[i] = x;
    }
  }

  // Flow beside Flow Setpoint: measured, and of a loop.
  [[nodiscard]] bool has_setpoint_of(const ColumnName& name) const {
    if (name.part != Part::kNone || hint_of(name) != Part::kY) return false;
    return std::ranges::any_of(candidates_, [&name](const NamedSignal& c) {
      return c.name.part == Part::kSp &&
             std::ranges::find(c.name.pieces, name.pieces.front()) != c.name.pieces.end();
    });
  }

  // The test of a positioner: a position beside what it is asked for, without a loop.
  void take_positioner(const std::vector<Column>& wanted, Indices& out) const {
    if (has(Part::kU) || has(Part::kY) || has(Part::kMv) || !has(Part::kX)) return;
    const bool measured = std::ranges::any_of(
        candidates_, [this](const NamedSignal& c) { return has_setpoint_of(c.name); });
    if (measured) return;
    const auto first = [this](auto fits) {
      std::size_t i = 0;
      while (i < candidates_.size() &&
             !(candidates_[i].measured && !taken_[i] && fits(candidates_[i].name))) {
        ++i;
      }
      return i;
    };
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (wanted[i] == Column::y) {
        out[i] = first([](const ColumnName& name) { return name.part == Part::kX; });
      } else if (wanted[i] == Column::u) {
        out[i] = first([](const ColumnName& name) {
          return name.part == Part::kSp || name.key == "w" ||
                 name.key.starts_with("input");
        });
      }
    }
  }

  // The only position is of a valve that nothing else moves.
  void take_valve(const std::vector<Column>& wanted, Indices& out) const {
    const auto position = only_one(candidates_, taken_, is_part(Part::kX));
    if (!position || std::ranges::find(out, *position) != out.end()) return;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (wanted[i] == Column::u && out[i] == candidates_.size()) out[i] = *position;
    }
  }

  [[nodiscard]] bool may_be_meant(std::size_t i) const {
    const NamedSignal& candidate = candidates_[i];
    const ColumnName& name = candidate.name;
    const bool says_nothing = hint_of(name) == Part::kNone;
    const bool rests = candidate.held == 1 && name.part == Part::kNone && says_nothing;
    return candidate.measured && !candidate.empty && !taken_[i] && !name.key.empty() &&
           !(candidate.counts && says_nothing) && !rests;
  }

  [[nodiscard]] std::size_t nameless() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const ColumnName& name = candidates_[i].name;
      count +=
          may_be_meant(i) && name.part == Part::kNone && hint_of(name) == Part::kNone;
    }
    return count;
  }

  // MV and CV without a PV: manipulated and controlled, or measured and control value.
  [[nodiscard]] bool mv_is_open() const {
    return has(Part::kMv) && has(Part::kU) && !has(Part::kY);
  }

  // Input and Output, of the process or of its controller.
  [[nodiscard]] bool input_is_open() const {
    const auto named = [this](std::string_view key) {
      return std::ranges::any_of(
          candidates_, [key](const NamedSignal& c) { return c.name.key == key; });
    };
    return named("input") && named("output") && !has(Part::kY);
  }

  // An output beside what a controller puts out, and nothing measured: it may be
  // either's.
  [[nodiscard]] bool output_is_open() const {
    if (has(Part::kY)) return false;
    std::multiset<std::string_view> tags;
    for (const NamedSignal& c : candidates_) {
      if (c.name.part == Part::kU) tags.insert(c.name.tag);
    }
    return std::ranges::any_of(
        tags, [&tags](std::string_view tag) { return tags.count(tag) > 1; });
  }

  [[nodiscard]] bool has(Part part) const {
    return std::ranges::any_of(candidates_, is_part(part));
  }

  // None: the number of columns.
  [[nodiscard]] std::size_t suggestion(Column column, const Indices& used,
                                       bool nameless_too) const {
    for (const Part part : {part_of(column), Part::kNone}) {
      std::size_t best = candidates_.size();
      for (std::size_t i = 0; i < candidates_.size(); ++i) {
        const NamedSignal& candidate = candidates_[i];
        const bool free = std::ranges::find(used, i) == used.end();
        const Part meant = hint_of(candidate.name);
        const bool other = meant != Part::kNone && meant != part_of(column);
        const bool said = part != Part::kNone || meant != Part::kNone ||
                          candidate.name.key.starts_with(name_of(column));
        if (!free || !may_be_meant(i) || candidate.name.part != part || other) continue;
        if (!said && !nameless_too) continue;
        if (best == candidates_.size() || looks_more_like(column, i, best)) best = i;
      }
      if (best < candidates_.size()) return best;
    }
    return candidates_.size();
  }

  // Named with its letter, or a word for it; as u, what is moved in steps; as y, what
  // not.
  [[nodiscard]] bool looks_more_like(Column column, std::size_t i,
                                     std::size_t than) const {
    constexpr double kSteps = 0.25;  // more of the values are those before
    const auto letter = [&](std::size_t k) {
      return candidates_[k].name.key.starts_with(name_of(column));
    };
    const auto word = [&](std::size_t k) {
      return hint_of(candidates_[k].name) == part_of(column);
    };
    const auto rests = [&](std::size_t k) { return candidates_[k].held == 1; };
    if (rests(i) != rests(than)) return rests(than);
    if (letter(i) != letter(than)) return letter(i);
    if (word(i) != word(than)) return word(i);
    const double more = candidates_[i].held - candidates_[than].held;
    return column == Column::u ? more > kSteps : column == Column::y && -more > kSteps;
  }

  const std::vector<NamedSignal>& candidates_;
  const std::vector<bool>& taken_;
};

// CH1, 101, D100: a terminal or register, which says nothing of the loop.
bool is_terminal(std::string_view piece) {
  constexpr std::string_view kTerminals = "ch|ai|ao|in|out|db|iw|qw";
  const std::size_t digits = piece.find_first_of("0123456789");
  if (digits == std::string_view::npos ||
      piece.find_first_not_of("0123456789", digits) != std::string_view::npos) {
    return false;
  }
  const std::string_view letters = piece.substr(0, digits);
  return letters.size() < 2 || is_one_of(letters, kTerminals);
}

// 101, CH2: the channel of a recorder, not a unit of the plant.
bool is_channel(std::string_view piece) {
  constexpr std::size_t kFewestDigits = 3;
  const std::size_t letters = piece.find_first_of("0123456789");
  return is_terminal(piece) && letters != 1 &&
         (letters > 0 || piece.size() >= kFewestDigits);
}

// 101 <FIC101.OP>, 102 <FIC101.PV>: one instrument on two channels.
bool are_of_one_instrument(const ColumnName& a, const ColumnName& b) {
  if (!is_channel(a.pieces.front()) || !is_channel(b.pieces.front())) return false;
  const auto loop = loop_of_instrument(std::span(a.pieces).subspan(1));
  return loop && loop == loop_of_instrument(std::span(b.pieces).subspan(1));
}

// Two names that do not say of which loop they are, or one that does not.
bool may_be_one_loop(const ColumnName& a, const ColumnName& b) {
  const auto open = [](const ColumnName& name) {
    return !name.by_letters && std::ranges::all_of(name.pieces, [](const auto& piece) {
      return is_terminal(piece) || is_unit(piece) || is_signal(part_named(piece));
    });
  };
  return a.tag.empty() || b.tag.empty() || (open(a) && open(b)) ||
         are_of_one_instrument(a, b);
}

// A signal whose name says nothing, and nothing against `column`.
bool may_be(const NamedSignal& candidate, Column column) {
  constexpr std::string_view kOpen = "input|in|eingang|entree|eing";
  const ColumnName& name = candidate.name;
  const Part hint = hint_of(name);
  const bool open = std::ranges::any_of(name.pieces, [&kOpen](const std::string& piece) {
    return is_one_of(piece, kOpen);
  });
  if (open) return false;
  return column == Column::u ? hint == Part::kU : hint == Part::kNone || hint == Part::kY;
}

}  // namespace

Part part_of(Column column) {
  constexpr std::array kParts = {Part::kTime, Part::kU, Part::kY, Part::kSp, Part::kX};
  return kParts[static_cast<std::size_t>(column)];
}

bool is_only_cv(const std::vector<NamedSignal>& candidates, const Indices& of) {
  return of.size() == 1 && !candidates[of[0]].name.pieces.empty() &&
         candidates[of[0]].name.pieces.back() == "cv";
}

std::vector<NamedSignal> with_block_inputs(std::vector<NamedSignal> candidates) {
  const auto has = [&candidates](Part part, const std::string& tag) {
    return std::ranges::any_of(candidates, [&](const NamedSignal& c) {
      return c.name.part == part && c.name.tag == tag;
    });
  };
  for (NamedSignal& candidate : candidates) {
    ColumnName& name = candidate.name;
    if (name.part != Part::kNone || name.pieces.empty() ||
        name.pieces.back() != "input") {
      continue;
    }
    const std::string tag =
        name.key.substr(0, name.key.size() - name.pieces.back().size());
    const bool output = std::ranges::any_of(candidates, [&tag](const NamedSignal& c) {
      return c.name.key == tag + "output";
    });
    if (!output || !has(Part::kSp, tag) || has(Part::kY, tag)) continue;
    name.part = Part::kY;
    name.tag = tag;
  }
  return candidates;
}

bool is_extreme(const ColumnName& name) {
  constexpr std::string_view kExtremes = "min|max|minimum|maximum|stddev|std|range|count";
  const std::size_t end = name.text.find_last_not_of(" )]}") + 1;
  const std::size_t begin = name.text.find_last_of(" ([{|._-:/", end - 1) + 1;
  const std::string last =
      lower_case(std::string_view(name.text).substr(begin, end - begin));
  return is_one_of(last, kExtremes);
}

std::vector<std::size_t> suggested_signals(const std::vector<NamedSignal>& candidates,
                                           const std::vector<bool>& taken,
                                           const std::vector<Column>& wanted) {
  return Suggester(candidates, taken).suggestions(wanted);
}

std::vector<PickedSignal> only_signals(const std::vector<NamedSignal>& candidates,
                                       const std::vector<bool>& taken,
                                       const std::vector<Column>& wanted) {
  const bool pair =
      wanted.size() == 2 && wanted[0] == Column::u && wanted[1] == Column::y;
  if (!pair) return {};
  const auto count = [&candidates](Part part) {
    return std::ranges::count_if(candidates, is_part(part));
  };
  const Part output = count(Part::kU) > 0 ? Part::kU : Part::kMv;
  const bool one_output =
      count(output) == 1 && (output == Part::kMv || count(Part::kMv) == 0);
  if (count(output) > 1 || count(Part::kY) > 1) return {};
  const auto of_part = [&](Part part) {
    return only_one(candidates, taken, is_part(part));
  };
  std::optional<std::size_t> u = one_output ? of_part(output) : std::nullopt;
  std::optional<std::size_t> y = of_part(Part::kY);
  const auto other = [&](Column column) {
    const auto found = only_one(candidates, taken, [](const NamedSignal& c) {
      return (c.name.part == Part::kNone || c.name.part == Part::kValue) &&
             !c.name.key.empty() && !c.counts;
    });
    return found && may_be(candidates[*found], column) ? found : std::nullopt;
  };
  if (u && y) {
    if (!may_be_one_loop(candidates[*u].name, candidates[*y].name)) return {};
  } else if (u && count(Part::kY) == 0) {
    y = other(Column::y);
  } else if (y && count(Part::kU) + count(Part::kMv) == 0) {
    u = other(Column::u);
  }
  if (!u || !y) return {};
  return {{Column::u, *u, true}, {Column::y, *y, true}};
}

}  // namespace workbench
