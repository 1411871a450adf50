// The numbers of an effect, for a terminal of 80 columns.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "workbench/model/base/model.hpp"

namespace workbench::cli {

/// Parameters as an indented table: name, value, interval, unit.
[[nodiscard]] std::string parameter_table(const std::vector<Parameter>& parameters,
                                          std::size_t indent);
/// What the intervals leave open: that it may be absent or something else, that a
/// parameter is not told. Lines of their own; "" for most effects.
[[nodiscard]] std::string notes_on(const EffectTerm& term, std::size_t indent);
/// The parameters of an effect and notes_on() it; of a characteristic its curve in words
/// before them.
[[nodiscard]] std::string effect_table(const EffectTerm& term, std::size_t indent);

}  // namespace workbench::cli
