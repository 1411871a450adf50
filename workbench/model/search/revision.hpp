// Second thoughts: what was added one at a time may stand for what was not there yet.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workbench/effects/catalogue.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/search/identified.hpp"

namespace workbench {

/// What became of a set of effects.
struct Revision {
  std::vector<const Effect*> removed{};  ///< none: the same effects, other values
  std::optional<Fit> between{};  ///< less `removed`, where something takes their place
  std::vector<const Effect*> added{};  ///< in their place, in this order; often none
  std::vector<std::string> indistinguishable_from{};  ///< of a single one added
  Fit fit;
};

/// Looks at two effects or more again. Tries
/// 1. the same effects, searched from scratch;
/// 2. `fit` less one effect, the others searched from scratch, too: taken where the
///    validation samples do not miss it, or hardly (kLeastMissed, merit.hpp), or where
///    its values beside the others are out of range or cannot be told from none;
/// 3. from three effects on, one instead of two, with the rest as they are or one of them
///    replaced by a look-alike: taken where the validation samples do not miss what goes,
///    or hardly;
/// 4. what explore() finds instead of one effect, alone or as a pair: taken where
///    Schwarz's criterion over all samples prefers it, in the error as it is and
///    whitened. Not asked where `fit` leaves white noise.
/// The effects of `given` stay. Nothing where `fit` stands. Cost: for each effect one
/// explore() and two starts, for each two of three or more a trial of each other effect.
[[nodiscard]] std::optional<Revision> revised(const Fitter& fitter, const Fit& fit,
                                              const std::vector<const Effect*>& given,
                                              const Catalogue& catalogue,
                                              Identified& identified);

}  // namespace workbench
