#include "hidden/tables.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>

#include "hidden/case_list.hpp"

namespace hidden {
namespace {

using Test = std::function<bool(const Outcome&)>;

std::string cell(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string share(std::size_t count, std::size_t of) {
  return of == 0
             ? "–"
             : cell("%.1f", 100.0 * static_cast<double>(count) / static_cast<double>(of));
}

std::size_t count_if(const std::vector<Outcome>& all, const Test& test) {
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), test));
}

std::vector<Outcome> select(const std::vector<Outcome>& all, const Test& test) {
  std::vector<Outcome> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some), test);
  return some;
}

std::vector<Outcome> at_ratio(const std::vector<Outcome>& all, double ratio) {
  return select(all, [&](const Outcome& o) { return o.key.signal_to_noise == ratio; });
}

/// Of at least one value.
double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

bool anything(const Outcome& o) {
  return !o.named.first.empty();
}

bool nothing(const Outcome& o) {
  return !anything(o);
}

/// One row of figures with a column for each signal-to-noise ratio and one for all.
std::string row(const std::string& name, const std::vector<Outcome>& all,
                const std::function<std::string(const std::vector<Outcome>&)>& figure,
                const char* goal) {
  std::string text = "| " + name + " |";
  for (const double ratio : kRatios) {
    text += " " + figure(at_ratio(all, ratio)) + " |";
  }
  return text + " " + figure(all) + " | " + goal + " |\n";
}

std::string share_row(const std::string& name, const std::vector<Outcome>& all,
                      const Test& test, const char* goal) {
  return row(
      name, all,
      [&](const std::vector<Outcome>& some) {
        return share(count_if(some, test), some.size());
      },
      goal);
}

std::string heading(const char* title) {
  return std::string("\n### ") + title +
         "\n\n| signal-to-noise | 40 | 10 | 4 | all | goal "
         "|\n|---|---|---|---|---|---|\n";
}

std::string count_row(const std::vector<Outcome>& all) {
  return row(
      "recordings", all,
      [](const std::vector<Outcome>& some) { return std::to_string(some.size()); }, "");
}

bool small(const Outcome& o) {
  return o.size < 0.1;
}

std::string one_effect_table(const std::vector<Outcome>& all) {
  std::string text = heading("One hidden effect, % of recordings");
  text += count_row(all);
  text += share_row("right effect or its group named first", all, right_first,
                    "95 / 90 / 75");
  text += share_row(
      "the effect itself named first", all,
      [](const Outcome& o) {
        return anything(o) && o.named.first[0].effect == code_of(o.key.effects[0]);
      },
      "");
  text += share_row("wrong name first", all, wrong_first, "5");
  text += share_row("nothing named", all, nothing, "");
  text += share_row(
      "final model: right and nothing else", all,
      [](const Outcome& o) { return hidden_found(o) == 1 && needless(o) == 0; }, "");
  text += share_row(
      "final model: right and further effects", all,
      [](const Outcome& o) { return hidden_found(o) == 1 && needless(o) > 0; }, "");
  for (const Excitation excitation :
       {Excitation::kSetpointSteps, Excitation::kLimitCycle}) {
    text += share_row(
        "right, " + std::string(name_of(excitation)),
        select(all, [&](const Outcome& o) { return o.key.excitation == excitation; }),
        right_first, "");
  }
  text += share_row("right, effect's size < 0.1", select(all, small), right_first, "");
  text +=
      share_row("right, size ≥ 0.1",
                select(all, [](const Outcome& o) { return !small(o); }), right_first, "");
  return text + row(
                    "names in the group, mean", select(all, right_first),
                    [](const std::vector<Outcome>& some) {
                      std::size_t names = 0;
                      for (const Outcome& o : some) {
                        names += 1 + o.named.first[0].indistinguishable_from.size();
                      }
                      return some.empty()
                                 ? std::string("–")
                                 : cell("%.2f", static_cast<double>(names) /
                                                    static_cast<double>(some.size()));
                    },
                    "");
}

std::string two_effects_table(const std::vector<Outcome>& all) {
  std::string text = heading("Two hidden effects, % of recordings");
  text += count_row(all);
  text += share_row(
      "both found", all, [](const Outcome& o) { return hidden_found(o) == 2; }, "75");
  text += share_row(
      "at least one found", all, [](const Outcome& o) { return hidden_found(o) >= 1; },
      "95");
  text += share_row(
      "no other effect", all, [](const Outcome& o) { return needless(o) == 0; }, "90");
  const auto alone = [](const Outcome& o) {
    return std::all_of(
        o.named.added.begin(), o.named.added.end(),
        [](const AddedEffect& added) { return added.indistinguishable_from.empty(); });
  };
  text += share_row(
      "both found and no other, every one without rivals", all,
      [&](const Outcome& o) {
        return hidden_found(o) == 2 && needless(o) == 0 && alone(o);
      },
      "");
  return text + row(
                    "names in the group of an effect, mean", all,
                    [](const std::vector<Outcome>& some) {
                      std::size_t names = 0;
                      std::size_t groups = 0;
                      for (const Outcome& o : some) {
                        groups += o.named.added.size();
                        for (const AddedEffect& added : o.named.added) {
                          names += 1 + added.indistinguishable_from.size();
                        }
                      }
                      return groups == 0 ? std::string("–")
                                         : cell("%.2f", static_cast<double>(names) /
                                                            static_cast<double>(groups));
                    },
                    "");
}

std::string clean_table(const std::vector<Outcome>& all) {
  std::string text = heading("No hidden effect, % of recordings");
  text += count_row(all);
  text += share_row("an effect accepted", all, anything, "2");
  text += share_row(
      "said to be explained", all, [](const Outcome& o) { return o.named.explained; },
      "");
  return text + share_row(
                    "said that little but the controller moves u", all,
                    [](const Outcome& o) {
                      return !o.named.explained && o.named.left_to_controller;
                    },
                    "");
}

std::string not_excited_table(const std::vector<Outcome>& all) {
  std::string text = heading("Hidden effect not excited, % of recordings");
  text += count_row(all);
  text += share_row(
      "the effect is said to be not excited", all,
      [](const Outcome& o) {
        return o.named.said_not_excited(code_of(o.key.effects[0]));
      },
      "95");
  text += share_row(
      "the effect is not named", all, [](const Outcome& o) { return !right_first(o); },
      "");
  return text + share_row("wrong name", all, wrong_first, "0");
}

/// How well the engine fits when it is told what is hidden.
double of_noise(const Outcome& o) {
  return o.true_model_rmse / o.noise;
}

std::string ladder_table(const Results& results) {
  std::vector<Outcome> all = results.one_effect;
  all.insert(all.end(), results.two_effects.begin(), results.two_effects.end());
  std::string text =
      heading("After the ladder: validation error over that of the true model refitted");
  text += count_row(all);
  text += share_row(
      "ratio at most 1.10, %", all,
      [](const Outcome& o) { return error_ratio(o) <= 1.10; }, "90");
  const auto by_kind = [&](const char* name, std::size_t effects) {
    return share_row(
        name,
        select(all, [&](const Outcome& o) { return o.key.effects.size() == effects; }),
        [](const Outcome& o) { return error_ratio(o) <= 1.10; }, "");
  };
  text += by_kind("… one effect, %", 1);
  text += by_kind("… two effects, %", 2);
  const auto medians = [&](const char* name, double (*figure)(const Outcome&)) {
    return row(
        name, all,
        [&](const std::vector<Outcome>& some) {
          std::vector<double> values;
          for (const Outcome& o : some) {
            values.push_back(figure(o));
          }
          return values.empty() ? std::string("–") : cell("%.3f", median(values));
        },
        "");
  };
  text += medians("ratio, median", error_ratio);
  text += share_row(
      "true model within 1.10 of the noise, %", all,
      [](const Outcome& o) { return of_noise(o) <= 1.10; }, "");
  return text + medians("true model over the noise, median", of_noise);
}

struct Coverage {
  std::size_t covered = 0;
  std::size_t count = 0;

  void add(const Interval& interval) {
    covered += interval.covers() ? 1 : 0;
    ++count;
  }
};

std::string coverage_table(const Results& results) {
  std::map<std::string, std::map<double, Coverage>> by_name;
  std::map<double, Coverage> total;
  for (const auto* outcomes : {&results.one_effect, &results.two_effects}) {
    for (const Outcome& o : *outcomes) {
      for (const Interval& interval : o.intervals) {
        by_name[interval.parameter][o.key.signal_to_noise].add(interval);
        total[o.key.signal_to_noise].add(interval);
      }
    }
  }
  std::string text =
      "\n### 95 % intervals of true effects in the final model: % that cover the "
      "truth\n\n"
      "| signal-to-noise | 40 | 10 | 4 | all | intervals |\n|---|---|---|---|---|---|\n";
  const auto add = [&](const std::string& name, const std::map<double, Coverage>& some) {
    Coverage all;
    text += "| " + name + " |";
    for (const double ratio : kRatios) {
      const auto found = some.find(ratio);
      const Coverage one = found == some.end() ? Coverage{} : found->second;
      text += " " + share(one.covered, one.count) + " |";
      all.covered += one.covered;
      all.count += one.count;
    }
    text +=
        " " + share(all.covered, all.count) + " | " + std::to_string(all.count) + " |\n";
  };
  for (const auto& [name, some] : by_name) {
    add(name, some);
  }
  add("all (goal 90 – 98)", total);
  return text;
}

/// What was named first instead, most frequent first.
std::string instead_of(const std::vector<Outcome>& all) {
  std::map<std::string, int> count;
  for (const Outcome& o : all) {
    if (wrong_first(o)) {
      ++count[o.named.first[0].effect];
    }
  }
  std::vector<std::pair<int, std::string>> sorted;
  for (const auto& [effect, times] : count) {
    sorted.emplace_back(-times, effect);
  }
  std::sort(sorted.begin(), sorted.end());
  std::string text;
  for (const auto& [times, effect] : sorted) {
    text += (text.empty() ? "" : ", ") + effect + " " + std::to_string(-times);
  }
  return text;
}

std::string confusion_table(const Results& results) {
  std::string text =
      "\n### One hidden effect, effect by effect\n\n"
      "| hidden effect | excitation | n | right % at 40 | 10 | 4 | nothing named | "
      "named first instead |\n|---|---|---|---|---|---|---|---|\n";
  for (const Effect effect : all_effects()) {
    for (const Excitation excitation :
         {Excitation::kSetpointSteps, Excitation::kLimitCycle}) {
      const auto some = select(results.one_effect, [&](const Outcome& o) {
        return o.key.effects[0] == effect && o.key.excitation == excitation;
      });
      if (some.empty()) {
        continue;
      }
      text += "| " + std::string(code_of(effect)) + " | " +
              std::string(name_of(excitation)) + " | " + std::to_string(some.size()) +
              " |";
      for (const double ratio : kRatios) {
        const auto part = at_ratio(some, ratio);
        text += " " + share(count_if(part, right_first), part.size()) + " |";
      }
      const auto silent = count_if(some, nothing);
      text += " " + std::to_string(silent) + " | " + instead_of(some) + " |\n";
    }
  }
  std::map<std::string, int> invented;
  for (const Outcome& o : results.clean) {
    for (const AddedEffect& added : o.named.added) {
      ++invented[added.effect];
    }
  }
  if (!invented.empty()) {
    text += "\nAccepted on clean recordings:";
    for (const auto& [effect, times] : invented) {
      text += " " + effect + " " + std::to_string(times) + ",";
    }
    text.back() = '.';
    text += "\n";
  }
  return text;
}

}  // namespace

std::string tables_of(const Results& results) {
  std::string text;
  if (!results.one_effect.empty()) {
    text += one_effect_table(results.one_effect);
  }
  if (!results.two_effects.empty()) {
    text += two_effects_table(results.two_effects);
  }
  if (!results.clean.empty()) {
    text += clean_table(results.clean);
  }
  if (!results.not_excited.empty()) {
    text += not_excited_table(results.not_excited);
  }
  if (!results.one_effect.empty() || !results.two_effects.empty()) {
    text += ladder_table(results);
    text += coverage_table(results);
    text += confusion_table(results);
  }
  return text;
}

}  // namespace hidden
