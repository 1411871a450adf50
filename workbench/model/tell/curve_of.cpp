#include "workbench/model/tell/curve_of.hpp"

#include <algorithm>

namespace workbench {

std::optional<NamedCurve> curve_of(const std::string& effect,
                                   const std::vector<Parameter>& parameters) {
  const Effect* const known = standard_catalogue().find(effect);
  if (known == nullptr) return std::nullopt;
  std::vector<double> values;
  for (const Parameter& p : parameters) {
    if (!p.derived) values.push_back(p.value);
  }
  return known->named_curve(values);
}

bool is_idle(const EffectTerm& term, std::string_view name) {
  const Effect* const known = standard_catalogue().find(term.effect);
  if (known == nullptr) return false;
  const OptionalForm form = known->optional_form();
  return std::ranges::find(form.parameters, name) != form.parameters.end() &&
         std::ranges::any_of(term.parameters, [&form](const Parameter& p) {
           return p.name == form.constant && p.value < 0.5;
         });
}

std::vector<Parameter> told_parameters(const EffectTerm& term) {
  std::vector<Parameter> out = term.parameters;
  std::erase_if(out, [&term](const Parameter& p) { return is_idle(term, p.name); });
  const std::optional<NamedCurve> curve = curve_of(term.effect, term.parameters);
  if (!curve) return out;
  std::erase_if(out, [&curve](const Parameter& p) {
    return std::ranges::find(curve->inside, p.name) != curve->inside.end();
  });
  return out;
}

}  // namespace workbench
