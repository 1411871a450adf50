#include "workbench/model/tell/curve_of.hpp"

#include <algorithm>

namespace workbench {

std::optional<NamedCurve> curve_of(const std::string& effect,
                                   const std::vector<Parameter>& parameters,
                                   const Catalogue& catalogue) {
  const Effect* const known = catalogue.find(effect);
  if (known == nullptr) return std::nullopt;
  std::vector<double> values;
  for (const Parameter& p : parameters) {
    if (!p.derived) values.push_back(p.value);
  }
  return known->named_curve(values);
}

std::vector<Parameter> told_parameters(const EffectTerm& term) {
  std::vector<Parameter> out = term.parameters;
  const bool stays = std::ranges::any_of(
      out, [](const Parameter& p) { return p.name == "passing" && p.value < 0.5; });
  if (stays) std::erase_if(out, [](const Parameter& p) { return p.name == "end"; });
  const std::optional<NamedCurve> curve = curve_of(term.effect, term.parameters);
  if (!curve) return out;
  std::erase_if(out, [&curve](const Parameter& p) {
    return std::find(curve->inside.begin(), curve->inside.end(), p.name) !=
           curve->inside.end();
  });
  return out;
}

}  // namespace workbench
