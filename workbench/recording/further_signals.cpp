#include "workbench/recording/further_signals.hpp"

#include <algorithm>

#include "workbench/recording/column_name.hpp"
#include "workbench/recording/column_words.hpp"

namespace workbench {

std::vector<std::string> names_of_moving(const std::vector<Load>& loads) {
  std::vector<std::string> out;
  for (const Load& load : loads) {
    const auto [low, high] = std::minmax_element(load.values.begin(), load.values.end());
    const bool moves = low != high && *low < *high;
    const bool wanted = part_hinted(column_name(load.name).pieces) == Part::kSp;
    if (moves && !wanted) out.push_back(load.name);
  }
  return out;
}

std::string first_three(const std::vector<std::string>& names) {
  constexpr std::size_t kNamed = 3;
  std::string out;
  for (std::size_t i = 0; i < std::min(kNamed, names.size()); ++i) {
    out += (i > 0 ? ", " : "") + names[i];
  }
  if (names.size() > kNamed)
    out += " and " + std::to_string(names.size() - kNamed) + " more";
  return out;
}

}  // namespace workbench
