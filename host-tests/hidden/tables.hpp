// The figures of the hidden-effect benchmark as Markdown.
#pragma once

#include <string>
#include <vector>

#include "hidden/outcome.hpp"

namespace hidden {

/// Everything that was run, by kind of question.
struct Results {
  std::vector<Outcome> one_effect;
  std::vector<Outcome> two_effects;
  std::vector<Outcome> clean;
  std::vector<Outcome> not_excited;
};

[[nodiscard]] std::string tables_of(const Results& results);

}  // namespace hidden
