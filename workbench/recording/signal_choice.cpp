#include "workbench/recording/signal_choice.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "workbench/recording/filled.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/letters.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/signal_suggestion.hpp"

namespace workbench {
namespace {

using Indices = std::vector<std::size_t>;

// Places of one prefix, by part.
struct Loop {
  std::string prefix;
  std::map<Part, Indices> parts;
  Indices outputs;  // CV and MV, either of which may be u

  [[nodiscard]] bool has(Part part) const { return parts.contains(part); }
};

bool is_first_rank(const ColumnName& name) {
  return name.key.starts_with(name.tag) &&
         is_one_of(std::string_view(name.key).substr(name.tag.size()),
                   "u|op|y|pv|sp|x|pos|mv");
}

class Chooser {
 public:
  Chooser(const std::vector<NamedSignal>& candidates, const ColumnNames& names,
          const std::vector<Column>& required, const ChoiceContext& context)
      : candidates_(with_block_inputs(candidates)),
        names_(names),
        required_(required),
        context_(context) {}

  std::vector<PickedSignal> choose() {
    for (const Column column : kLoopColumns) {
      const std::string& name = names_.of(column);
      if (name.empty()) continue;
      const std::string option = "--" + std::string(name_of(column));
      const std::size_t index =
          candidate_named(name, option.c_str(), candidates_, context_);
      if (is_picked(index)) {
        throw std::invalid_argument(
            option + " and another option name the same signal, " +
            quoted(candidates_[index].name.text) + "; each is one of its own");
      }
      picked_[static_cast<std::size_t>(column)] = index;
    }
    find_rest();
    std::vector<PickedSignal> out;
    for (const Column column : kLoopColumns) {
      if (const auto index = picked(column)) {
        const bool last = by_elimination_ && column <= Column::y;
        out.push_back({column, *index, last && names_.of(column).empty()});
      }
    }
    add_loads(out);
    return out;
  }

 private:
  [[nodiscard]] std::optional<std::size_t> picked(Column column) const {
    return picked_[static_cast<std::size_t>(column)];
  }
  [[nodiscard]] bool is_picked(std::size_t index) const {
    return std::ranges::any_of(picked_,
                               [index](const auto& other) { return other == index; });
  }

  [[nodiscard]] std::vector<Column> missing() const {
    std::vector<Column> out;
    for (const Column column : required_) {
      if (column != Column::t && !picked(column)) out.push_back(column);
    }
    return out;
  }

  [[nodiscard]] std::vector<Loop> loops(bool by_loop) const {
    std::vector<Loop> out;
    std::map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const ColumnName& name = candidates_[i].name;
      if (!is_signal(name.part) || is_picked(i)) continue;
      const std::string& key = by_loop ? name.loop : name.tag;
      const auto [at, is_new] = known.try_emplace(key, out.size());
      if (is_new) out.push_back({name.prefix, {}, {}});
      out[at->second].parts[name.part].push_back(i);
    }
    for (Loop& loop : out) settle_mv(loop);
    return out;
  }

  // The manipulated variable is u, unless the loop has an output by another name.
  void settle_mv(Loop& loop) const {
    const auto mv = loop.parts.find(Part::kMv);
    if (mv == loop.parts.end()) return;
    const auto u = loop.parts.find(Part::kU);
    const bool cv = u != loop.parts.end() && is_only_cv(candidates_, u->second) &&
                    !picked(Column::u) && !picked(Column::y);
    if (cv && loop.has(Part::kY)) loop.outputs = {u->second[0], mv->second[0]};
    const Part part = loop.has(Part::kU) || picked(Column::u) ? Part::kX : Part::kU;
    if (!loop.has(part)) loop.parts[part] = mv->second;
    loop.parts.erase(Part::kMv);
  }

  void find_rest() {
    const std::vector<Column> wanted = missing();
    if (wanted.empty()) {
      const auto of_y = picked(Column::y) ? picked(Column::y) : picked(Column::u);
      if (of_y) add_companions(*of_y);
      return;
    }
    for (const bool by_loop : {false, true}) {
      std::vector<Loop> fitting;
      for (Loop& loop : loops(by_loop)) {
        const bool has_all = std::ranges::all_of(
            wanted, [&loop](Column c) { return loop.has(part_of(c)); });
        if (has_all) fitting.push_back(std::move(loop));
      }
      prefer(fitting);
      if (fitting.size() > 1) refuse_several(fitting);
      if (fitting.size() == 1) {
        take(fitting[0], wanted);
        by_elimination_ = are_of_two_loops();
        return;
      }
    }
    if (!take_the_only(wanted)) refuse_missing(wanted);
  }

  [[nodiscard]] bool are_of_two_loops() const {
    if (!picked(Column::u) || !picked(Column::y)) return false;
    const ColumnName& u = candidates_[*picked(Column::u)].name;
    const ColumnName& y = candidates_[*picked(Column::y)].name;
    return !u.tag.empty() && !y.tag.empty() && u.tag != y.tag && u.loop != y.loop;
  }

  [[nodiscard]] std::vector<bool> taken() const {
    std::vector<bool> out(candidates_.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = is_picked(i);
    return out;
  }

  bool take_the_only(const std::vector<Column>& wanted) {
    if (!names_.loads.empty()) return false;
    const std::vector<PickedSignal> only = only_signals(candidates_, taken(), wanted);
    if (only.empty()) return false;
    for (const PickedSignal& signal : only) {
      picked_[static_cast<std::size_t>(signal.column)] = signal.index;
      by_elimination_ = signal.by_elimination;
    }
    for (const Column column : wanted) {
      if (const auto index = picked(column)) add_companions(*index);
    }
    return true;
  }

  // Of several loops, the one with bare names, with a tag already named, with a pair.
  void prefer(std::vector<Loop>& fitting) const {
    const auto keep = [&fitting](auto condition) {
      std::vector<Loop> kept;
      std::ranges::copy_if(fitting, std::back_inserter(kept), condition);
      if (!kept.empty()) fitting = std::move(kept);
    };
    std::vector<std::string> named_tags;
    for (const auto& index : picked_) {
      if (index) named_tags.push_back(candidates_[*index].name.tag);
    }
    const auto name_of_one = [this](const Loop& loop) -> const ColumnName& {
      return candidates_[loop.parts.begin()->second.front()].name;
    };
    keep([&](const Loop& loop) {
      return std::ranges::find(named_tags, name_of_one(loop).tag) != named_tags.end();
    });
    keep([](const Loop& loop) { return loop.has(Part::kU) && loop.has(Part::kY); });
    keep([&](const Loop& loop) { return !name_of_one(loop).by_letters; });
    keep([&](const Loop& loop) { return name_of_one(loop).tag.empty(); });
  }

  void take(const Loop& loop, const std::vector<Column>& wanted) {
    if (!loop.outputs.empty()) refuse_twice(Column::u, loop.outputs);
    for (const Column column : kLoopColumns) {
      const auto found = loop.parts.find(part_of(column));
      if (found == loop.parts.end() || picked(column)) continue;
      const bool needed = std::ranges::find(wanted, column) != wanted.end();
      Indices best;
      std::ranges::copy_if(
          found->second, std::back_inserter(best),
          [this](std::size_t i) { return is_first_rank(candidates_[i].name); });
      if (best.empty()) best = found->second;
      if (best.size() > 1) leave_out_extremes(best);
      if (best.size() > 1) prefer_plain(best);
      if (best.size() == 1) {
        picked_[static_cast<std::size_t>(column)] = best[0];
      } else if (needed || !loop.prefix.empty() || context_.header_line > 0) {
        refuse_twice(column, best);
      }
    }
  }

  // PV (Min) and PV (Max), where another one is left.
  void leave_out_extremes(Indices& best) const {
    Indices others;
    std::ranges::copy_if(best, std::back_inserter(others), [this](std::size_t i) {
      return !is_extreme(candidates_[i].name);
    });
    if (!others.empty()) best = std::move(others);
  }

  // PV before PV_raw and PV.Value: the name without a word for how it is a value.
  void prefer_plain(Indices& best) const {
    std::vector<std::size_t> lengths;
    for (const std::size_t i : best) lengths.push_back(candidates_[i].name.words_cut);
    const std::size_t fewest = *std::ranges::min_element(lengths);
    if (std::ranges::count(lengths, fewest) != 1) return;
    std::erase_if(best,
                  [&](std::size_t i) { return candidates_[i].name.words_cut != fewest; });
  }

  // Setpoint and valve position of the loop whose u or y is named.
  void add_companions(std::size_t of) {
    const std::string& tag = candidates_[of].name.tag;
    if (candidates_[of].name.part == Part::kNone) return;
    for (const Loop& loop : loops(false)) {
      if (candidates_[loop.parts.begin()->second.front()].name.tag != tag) continue;
      for (const Column column : {Column::sp, Column::x}) {
        const auto found = loop.parts.find(part_of(column));
        if (found == loop.parts.end() || found->second.size() != 1 || picked(column) ||
            is_load(found->second[0])) {
          continue;
        }
        picked_[static_cast<std::size_t>(column)] = found->second[0];
      }
    }
  }

  [[nodiscard]] bool is_load(std::size_t index) const {
    return std::ranges::any_of(names_.loads, [&](const std::string& name) {
      return name != "all" &&
             candidate_named(name, "--load", candidates_, context_) == index;
    });
  }

  void add_loads(std::vector<PickedSignal>& out) const {
    const auto taken = [&out](std::size_t index) {
      return std::ranges::any_of(
          out, [index](const PickedSignal& s) { return s.index == index; });
    };
    for (const std::string& name : names_.loads) {
      if (name == "all") {
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
          const bool counts = candidates_[i].measured && !candidates_[i].empty &&
                              !candidates_[i].name.key.empty() &&
                              candidates_[i].name.part != Part::kQuality &&
                              candidates_[i].name.part != Part::kTime;
          if (counts && !taken(i)) out.push_back({Column::t, i});
        }
        continue;
      }
      const std::size_t index = candidate_named(name, "--load", candidates_, context_);
      // A model names its loads in full beside what the user calls them.
      const bool is_load = std::ranges::any_of(out, [index](const auto& s) {
        return s.index == index && s.column == Column::t;
      });
      if (is_load) continue;
      if (taken(index)) {
        throw std::invalid_argument("--load " + name + ": '" +
                                    candidates_[index].name.text +
                                    "' is already another signal of the loop");
      }
      out.push_back({Column::t, index});
    }
  }

  [[noreturn]] void refuse(std::size_t column, std::string expected, std::string found,
                           std::string advice) const {
    throw InputError(context_.file, context_.header_line,
                     context_.header_line > 0 ? column : 0, std::move(expected),
                     std::move(found), std::move(advice));
  }

  [[nodiscard]] std::string option_for(Column column, std::size_t index) const {
    return "--" + std::string(name_of(column)) + ' ' +
           option_word(candidates_[index].name.text, candidates_[index].number);
  }

  [[noreturn]] void refuse_several(const std::vector<Loop>& fitting) const {
    const std::string prefixes =
        first_listed(fitting, {.letters = kLongestList}, ", ",
                     [](const Loop& loop) { return cut_name(loop.prefix); });
    std::string options;
    for (const Column column : missing()) {
      options += (options.empty() ? "" : " ") +
                 option_for(column, fitting[0].parts.at(part_of(column)).front());
    }
    refuse(1, "one loop", std::to_string(fitting.size()) + " loops: " + prefixes,
           "name the " + std::string(context_.candidates) + ", for example " + options);
  }

  [[noreturn]] void refuse_twice(Column column, const Indices& both) const {
    const NamedSignal& other = candidates_[both[1]];
    refuse(other.column, "one column for " + std::string(name_of(column)),
           "both " + quoted(candidates_[both[0]].name.text) + " and " +
               quoted(other.name.text),
           "rename or remove one of them, or name the right one with " +
               option_for(column, both[0]));
  }

  [[noreturn]] void refuse_missing(const std::vector<Column>& wanted) const {
    // Columns that no loop has at all; where there are none, the pair is torn apart.
    std::vector<Column> absent;
    for (const Column column : wanted) {
      const bool somewhere =
          std::ranges::any_of(candidates_, [column](const NamedSignal& c) {
            return c.name.part == part_of(column) ||
                   (c.name.part == Part::kMv && column != Column::y);
          });
      if (!somewhere) absent.push_back(column);
    }
    std::string what = listed(absent.empty() ? wanted : absent, " and ", with_aliases);
    if (absent.empty()) what = filled("{0} of one tag", {what});
    std::string options = context_.time_option.empty() ? "" : ' ' + context_.time_option;
    const Indices suggested = suggested_signals(candidates_, taken(), wanted);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      options += ' ' + (suggested[i] < candidates_.size()
                            ? option_for(wanted[i], suggested[i])
                            : "--" + std::string(name_of(wanted[i])) + " COLUMN");
    }
    refuse(1, what, list_of(candidates_, context_),
           "name the " + std::string(context_.candidates) + ", for example" + options);
  }

  const std::vector<NamedSignal> candidates_;
  const ColumnNames& names_;
  const std::vector<Column>& required_;
  const ChoiceContext& context_;
  std::array<std::optional<std::size_t>, kColumns> picked_;
  bool by_elimination_ = false;
};

}  // namespace

std::string elimination_note(const std::vector<PickedSignal>& picked,
                             const std::vector<NamedSignal>& candidates) {
  std::string which;
  for (const PickedSignal& signal : picked) {
    if (!signal.by_elimination) continue;
    which += (which.empty() ? "" : ", ") + std::string(name_of(signal.column)) + ' ' +
             quoted(candidates[signal.index].name.text);
  }
  return which.empty() ? which : "taken for lack of any other: " + which;
}

const std::string& ColumnNames::of(Column column) const {
  return of_column(column, time, u, y, sp, x);
}

std::vector<PickedSignal> choose_signals(const std::vector<NamedSignal>& candidates,
                                         const ColumnNames& names,
                                         const std::vector<Column>& required,
                                         const ChoiceContext& context) {
  return Chooser(candidates, names, required, context).choose();
}

}  // namespace workbench
