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

bool is_idle(const std::vector<Parameter>& parameters, std::string_view name) {
  const auto not_taken = [&](std::string_view form) {
    return std::ranges::any_of(
        parameters, [&](const Parameter& p) { return p.name == form && p.value < 0.5; });
  };
  return (name == "end" && not_taken("passing")) ||
         ((name == "by_flow" || name.starts_with("flow_")) && not_taken("by_flow"));
}

std::vector<Parameter> told_parameters(const EffectTerm& term) {
  std::vector<Parameter> out = term.parameters;
  std::erase_if(out,
                [&](const Parameter& p) { return is_idle(term.parameters, p.name); });
  const std::optional<NamedCurve> curve = curve_of(term.effect, term.parameters);
  if (!curve) return out;
  std::erase_if(out, [&curve](const Parameter& p) {
    return std::find(curve->inside.begin(), curve->inside.end(), p.name) !=
           curve->inside.end();
  });
  return out;
}

}  // namespace workbench
