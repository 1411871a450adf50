#include "workbench/model/tell/cautions.hpp"

#include <algorithm>

#include "workbench/effects/catalogue.hpp"
#include "workbench/recording/filled.hpp"

namespace workbench {

bool says_hardly_anything(double fit_percent) {
  constexpr double kLeast = 5;  // %, a tenth of the squared error
  return fit_percent < kLeast;
}

bool is_beside_the_point(const Candidate& best) {
  constexpr double kHardlyAnyPercent = 5;
  const Effect* effect = standard_catalogue().find(best.effect);
  return best.with.empty() && effect->description().place == Place::kRecord &&
         best.error_reduction_percent < kHardlyAnyPercent;
}

std::vector<std::string> cautions(const Model& model, double fit_percent) {
  constexpr double kAtBound = 0.99;
  if (says_hardly_anything(fit_percent)) {
    return {
        "From u alone the model says hardly more about the output than a constant would: "
        "it lacks something large, or u is not the column that moves the output."};
  }
  const auto lag = std::find_if(model.process.begin(), model.process.end(),
                                [](const Parameter& p) { return p.name == "first_lag"; });
  if (lag == model.process.end() || lag->value < kAtBound * lag->bound_high) return {};
  return {filled(
      "The first lag is as long as the recording, and the process may be slower still "
      "or never settle: try {0}.",
      {"process.integrating"})};
}

}  // namespace workbench
