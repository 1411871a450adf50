#include "workbench/cli/unused_columns.hpp"

#include <algorithm>
#include <exception>

#include "workbench/cli/console.hpp"
#include "workbench/model/base/joined.hpp"
#include "workbench/recording/named_signal.hpp"

namespace workbench::cli {

std::string note_on_unused(const std::vector<Load>& further) {
  constexpr std::size_t kNamed = 3;
  std::vector<std::string> names;
  for (const Load& load : further) {
    const auto [low, high] = std::minmax_element(load.values.begin(), load.values.end());
    if (low != high && *low < *high) names.push_back(load.name);
  }
  if (names.empty()) return {};
  std::string listed;
  for (std::size_t i = 0; i < std::min(kNamed, names.size()); ++i) {
    listed += (i > 0 ? ", " : "") + names[i];
  }
  if (names.size() > kNamed) {
    listed += " and " + std::to_string(names.size() - kNamed) + " more";
  }
  const std::string option = "--load " + shell_word(cut_name(names[0]));
  return (names.size() == 1 ? "column not used: " + listed + "; " + option +
                                  " tries it as a load that moves the output"
                            : "columns not used: " + listed + "; " + option +
                                  " tries the first as a load that moves the output, "
                                  "--load all every one");
}

void complain_about_unused(ModelOptions options, Column output) {
  options.source.loads = {"all"};
  std::string note;
  try {
    note = note_on_unused(joined(recordings_for(options, output), {}).loads);
  } catch (const std::exception&) {
    return;
  }
  if (!note.empty()) complain(note);
}

}  // namespace workbench::cli
