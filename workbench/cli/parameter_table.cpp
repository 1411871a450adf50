#include "workbench/cli/parameter_table.hpp"

#include "workbench/cli/console.hpp"
#include "workbench/model/tell/curve_of.hpp"
#include "workbench/model/tell/parameter_words.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/resample.hpp"

namespace workbench::cli {
namespace {

bool is_rate(const Parameter& p) {
  return p.name == "opening_rate" || p.name == "closing_rate";
}

// A limit that the recording never came to lies beyond all of it.
bool is_not_reached(const Parameter& p) {
  return (p.name == "lower_limit" && p.value <= p.bound_low) ||
         ((p.name == "upper_limit" || is_rate(p)) && p.value >= p.bound_high);
}

std::string line_of_unreached(const Parameter& p) {
  const bool lower = p.name == "lower_limit";
  const double end = lower ? p.high : p.low;
  return padded(p.name, 24) + padded("not reached", 12) +
         padded((lower ? "below " : "above ") + number(end, 4), 26) + p.unit + '\n';
}

bool is_instant(const Parameter& p) {
  return p.name == "time" || p.name == "end" || p.name == "start";
}

// A time that only the search bounds: longer ones were not tried.
bool is_open_above(const Parameter& p) {
  return p.unit == "s" && !is_instant(p) && p.low < p.high &&
         p.bound_low < p.bound_high && p.high >= 0.999 * p.bound_high;
}

std::string interval_of(const Parameter& p) {
  if (!(p.low < p.high)) return {};
  return is_open_above(p) ? number(p.low, 4) + " and above"
                          : number(p.low, 4) + " to " + number(p.high, 4);
}

std::string name_in_table(const Parameter& p) {
  return p.name == "time" || p.name == "end" ? p.name + "_from_start" : p.name;
}

bool is_whole_range(const Parameter& p) {
  return p.bound_low < p.bound_high && p.low <= p.bound_low && p.high >= p.bound_high &&
         choice_in_words(p).empty() && !is_not_reached(p);
}

// A form of the effect that says nothing at this value.
bool may_say_nothing(const Parameter& p) {
  return (p.name == "flow_ratio" || p.name == "falling_over_rising") && p.low < 1 &&
         p.high > 1;
}

std::string named(const std::vector<Parameter>& parameters,
                  bool (*is_meant)(const Parameter&)) {
  std::vector<std::string> names;
  for (const Parameter& p : parameters) {
    if (is_meant(p)) names.push_back(name_in_table(p));
  }
  return listed(names);
}

}  // namespace

std::string parameter_table(const std::vector<Parameter>& parameters,
                            std::size_t indent) {
  std::string text;
  for (const Parameter& p : parameters) {
    if (is_not_reached(p)) {
      text += std::string(indent, ' ') + line_of_unreached(p);
      continue;
    }
    const std::string name = std::string(indent, ' ') + padded(name_in_table(p), 24);
    // A choice is a number in files alone.
    const std::string choice = p.unit == "1" ? choice_in_words(p) : std::string();
    if (!choice.empty()) {
      text += name + choice + '\n';
      continue;
    }
    const std::string unit = p.unit == "1" ? std::string() : p.unit;
    const std::size_t room = unit.size() > 5 ? 22 : 26;
    text += without_end_blanks(name + padded(number(p.value, 4), 12) +
                               padded(interval_of(p), room) + unit) +
            '\n';
  }
  return text;
}

std::string notes_on(const EffectTerm& term, std::size_t indent) {
  std::string text;
  const auto say = [&](const std::string& sentence) {
    text += std::string(indent, ' ') + wrapped(sentence, indent) + '\n';
  };
  const std::vector<Parameter> told = told_parameters(term);
  const std::string open = named(told, is_open_above);
  const std::string any = named(told, is_whole_range);
  const std::string nothing = named(told, may_say_nothing);
  if (term.phenomenological) {
    say("At the edge of its physical range: a phenomenological term, not physics.");
  } else if (!open.empty()) {
    say("The interval of " + open +
        " reaches the edge of its physical range: it may be something else that is "
        "slow.");
  }
  if (term.untold) {
    say("Uncertain: its intervals reach to where it would be absent.");
  }
  if (!any.empty()) say("Not told: " + any + "; any value in its range does as well.");
  if (!nothing.empty()) say(nothing + " may as well be 1, which changes nothing.");
  return text;
}

std::string effect_table(const EffectTerm& term, std::size_t indent) {
  std::string text;
  if (const auto curve = curve_of(term.effect, term.parameters)) {
    text += std::string(indent, ' ') + wrapped(curve->words, indent) + '\n';
  }
  return text + parameter_table(told_parameters(term), indent) + notes_on(term, indent);
}

}  // namespace workbench::cli
