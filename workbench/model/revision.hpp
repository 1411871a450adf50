// Second thoughts: what was added one at a time may stand for what was not there yet.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/fit.hpp"

namespace workbench {

/// What became of a set of effects.
struct Revision {
  const Effect* removed = nullptr;  ///< null: the same effects, other values
  std::optional<Fit> between{};     ///< less `removed`, where something takes its place
  std::vector<const Effect*> added{};  ///< in its place, in this order; often none
  std::vector<std::string> indistinguishable_from{};  ///< of a single one added
  Fit fit;
};

/// Looks at two effects or more again. Tries
/// 1. the same effects, searched from scratch;
/// 2. `fit` less one effect, the others searched from scratch, too: taken where the
///    validation samples do not miss it, or hardly (kLeastMissed, merit.hpp);
/// 3. what explore() finds instead of one effect, alone or as a pair: taken where
///    Schwarz's criterion over all samples prefers it, in the error as it is and
///    whitened.
/// The effects of `given` stay. Nothing where `fit` stands. Cost: for each effect one
/// explore() and one start.
[[nodiscard]] std::optional<Revision> revised(const Fitter& fitter, const Fit& fit,
                                              const std::vector<const Effect*>& given,
                                              const Catalogue& catalogue);

}  // namespace workbench
