// What the workbench's ladder makes of a recording, reduced to what is scored. The only
// place that knows the engine; it is handed the sealed recording and nothing else.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/recording.hpp"

namespace hidden {

/// One effect that the ladder added.
struct AddedEffect {
  std::string effect;
  std::vector<std::string> indistinguishable_from;

  /// The effect itself or one of its group.
  [[nodiscard]] bool names(std::string_view wanted) const;
};

struct FoundParameter {
  std::string effect;
  std::string name;
  double value = 0;
  double low = 0;
  double high = 0;
};

/// Last word on an effect that is not in the model.
struct Judged {
  std::string effect;
  std::string status;  ///< of the contract: "not_excited"
};

struct Named {
  std::vector<AddedEffect> first;  ///< what the ladder added first: one or none
  std::vector<AddedEffect> added;  ///< what is left in the final model
  std::vector<Judged> others;
  std::vector<FoundParameter> parameters;
  bool explained = false;
  bool left_to_controller = false;  ///< little else moves u
  double rmse_validation = 0;
  std::string error;  ///< message of what it threw; empty for none

  [[nodiscard]] bool said_not_excited(std::string_view effect) const;
};

[[nodiscard]] Named name_effects(const workbench::Recording& recording);

/// Validation error of the engine's model with exactly these effects.
[[nodiscard]] double refit_error(const workbench::Recording& recording,
                                 const std::vector<std::string>& effects);

}  // namespace hidden
