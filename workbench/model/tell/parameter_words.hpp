// Parameters for people, where the keys of a model file say too little.
#pragma once

#include <string>
#include <string_view>

#include "workbench/model/base/model.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// "noise before rounding" for noise_before; "first lag" for first_lag.
[[nodiscard]] std::string name_in_words(std::string_view parameter);

/// What a number that stands for a choice means: "the last storage" for 1 in
/// spilling_storage. Empty where it is a number.
[[nodiscard]] std::string choice_in_words(const Parameter& parameter);

/// The unit of a parameter, which names u and y, in the units that the recording names:
/// degC/% for y/u. `output`: what y stands for. Empty for "1".
[[nodiscard]] std::string unit_in_words(const Parameter& parameter,
                                        const Recording& recording, Column output);

}  // namespace workbench
