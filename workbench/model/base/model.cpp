#include "workbench/model/base/model.hpp"

#include <algorithm>

namespace workbench {

bool Model::has(std::string_view effect) const {
  return std::any_of(effects.begin(), effects.end(),
                     [effect](const EffectTerm& term) { return term.effect == effect; });
}

std::vector<std::string> Model::effect_codes() const {
  std::vector<std::string> codes;
  for (const EffectTerm& term : effects) codes.push_back(term.effect);
  return codes;
}

std::string state_name(std::string_view name, std::size_t piece) {
  std::string out(name);
  if (piece > 0) out += '_' + std::to_string(piece + 1);
  return out;
}

}  // namespace workbench
