#include "workbench/model/tell/harm.hpp"

#include <algorithm>

namespace workbench {

const HistoryStep* harm_of(const Model& model, std::string_view effect) {
  constexpr double kMore = 1.005;
  const auto step =
      std::find_if(model.history.rbegin(), model.history.rend(),
                   [effect](const HistoryStep& s) { return s.effect == effect; });
  const bool harmed = step != model.history.rend() && !step->ahead &&
                      step->rmse_validation_after > kMore * step->rmse_validation_before;
  return harmed ? &*step : nullptr;
}

bool is_in_doubt(const HistoryStep& harm) {
  return harm.rmse_after < harm.rmse_before;
}

}  // namespace workbench
