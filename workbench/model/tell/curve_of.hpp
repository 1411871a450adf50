// The curve that an effect of a model bends the signal of the valve along.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/base/model.hpp"

namespace workbench {

/// Of `effect` with `parameters` as the fit left them; nothing where it has none, or
/// where parameters are missing, as in a file that somebody edited.
[[nodiscard]] std::optional<NamedCurve> curve_of(
    const std::string& effect, const std::vector<Parameter>& parameters);

/// Whether the parameter of that name goes with a form that its effect has not taken, as
/// the end of a load that stays.
[[nodiscard]] bool is_idle(const EffectTerm& term, std::string_view name);

/// Those of `term` for people: less what its curve tells better, and less what is_idle().
[[nodiscard]] std::vector<Parameter> told_parameters(const EffectTerm& term);

}  // namespace workbench
