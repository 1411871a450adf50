// The registry from which commands, fits, tests and texts derive what effects there are.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "workbench/effects/effect.hpp"

namespace workbench {

/// Effects in the order of the contract's table; codes are unique. The effects outlive
/// it.
class Catalogue {
 public:
  Catalogue() = default;
  explicit Catalogue(std::vector<const Effect*> effects) : effects_(std::move(effects)) {}

  /// Throws std::invalid_argument when the code is already there.
  void add(const Effect& effect);
  /// Null where no effect has this code. O(n). A measured load has its own for any
  /// column: disturbance.measured:COLUMN.
  [[nodiscard]] const Effect* find(std::string_view code) const;
  /// The same as a user writes it: a measured load by any name that fits one of the
  /// catalogue (best_fitting, named_signal.hpp).
  [[nodiscard]] const Effect* find_asked(std::string_view code) const;
  [[nodiscard]] const std::vector<const Effect*>& effects() const { return effects_; }
  /// With an effect for each load of a recording.
  [[nodiscard]] Catalogue with(const std::vector<Load>& loads) const;
  /// All but one.
  [[nodiscard]] Catalogue without(const Effect& effect) const;
  /// Codes, separated by ", ".
  [[nodiscard]] std::string codes() const;
  /// "no effect 'code'; known effects: …"
  [[nodiscard]] std::string no_effect(std::string_view code) const;

 private:
  std::vector<const Effect*> effects_;
};

/// Everything under effects/.
[[nodiscard]] const Catalogue& standard_catalogue();

}  // namespace workbench
