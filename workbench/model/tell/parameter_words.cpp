#include "workbench/model/tell/parameter_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace workbench {
namespace {

struct Words {
  std::string_view parameter;
  std::string_view name;
  std::array<std::string_view, 5> choices = {};  // by value
};
constexpr Words kWords[] = {
    {"noise_before", "noise before rounding"},
    {"spilling_storage",
     "what is cut off",
     {"the reading alone", "the last storage", "the first of two storages"}},
    {"first_storage_brim", "u that just fills the first storage"},
    {"spill_share", "share that spills over"},
    {"storage_start", "content at the start"},
    {"lag_follows_gain",
     "where it bends",
     {"behind the process", "in the outflow of the storages",
      "in tanks that drain by their own head", "in the outflow of the last storage",
      "in a last tank that drains by its own head"}},
    {"through_process",
     "where the load acts",
     {"on the output at once", "through the process"}},
    {"passing", "what the load does", {"it stays", "it goes again"}},
    {"end", "time at which the load goes"},
    {"by_flow", "where u is low or high", {"the same", "as the flow is"}},
    {"flow_ratio", "flow at the upper u over that at the lower"},
    {"flow_from", "lower u"},
    {"flow_to", "upper u"},
    {"held", "between stored points", {"straight lines", "the last value is held"}},
    {"stored_share", "share of samples that were stored"},
    {"held_share", "share of readings that hold"},
    {"shortest_freeze", "shortest time frozen"},
    {"free_shape", "shape of the curve", {"bent one way", "free"}},
    {"two_pieces", "in two straight pieces", {"no", "yes"}},
    {"parted_at", "u between the two pieces"},
    {"dead_width", "range of u in which nothing changes"},
    {"falling_over_rising", "lag on the way down over that on the way up"},
    {"tail_share", "share of the answer that comes later"},
    {"tail_lag", "lag of what comes later"},
    {"keeps_sliding",
     "once free the stem moves on",
     {"until u rests or turns", "until u turns"}},
    {"slide_time", "time that a slip takes"},
    {"time", "time from the start of the recording"},
    {"bend_1", "bend at 1/6 of the range"},
    {"bend_2", "bend at 2/6 of the range"},
    {"bend_3", "bend at 3/6 of the range"},
    {"bend_4", "bend at 4/6 of the range"},
    {"bend_5", "bend at 5/6 of the range"},
};

const Words* words_of(std::string_view parameter) {
  const auto* const found =
      std::find_if(std::begin(kWords), std::end(kWords),
                   [&](const Words& words) { return words.parameter == parameter; });
  return found == std::end(kWords) ? nullptr : found;
}

}  // namespace

std::string name_in_words(std::string_view parameter) {
  const Words* const words = words_of(parameter);
  std::string name(words != nullptr ? words->name : parameter);
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::string choice_in_words(const Parameter& parameter) {
  const Words* const words = words_of(parameter.name);
  if (words == nullptr) return {};
  for (std::size_t value = 0; value < words->choices.size(); ++value) {
    if (std::abs(parameter.value - static_cast<double>(value)) < 0.5) {
      return std::string(words->choices[value]);
    }
  }
  return {};
}

std::string unit_in_words(const Parameter& parameter, const Recording& recording,
                          Column output) {
  if (parameter.unit == "1") return {};
  std::string out;
  for (const char letter : parameter.unit) {
    if (letter != 'u' && letter != 'y') {
      out += letter;
      continue;
    }
    const Column column = letter == 'u' ? Column::u : output;
    const std::string& known = recording.unit(column);
    const bool is_part =
        parameter.unit.size() > 1 && known.find('/') != std::string::npos;
    out += known.empty() ? std::string(name_of(column))
           : is_part     ? '(' + known + ')'
                         : known;
  }
  return out;
}

}  // namespace workbench
