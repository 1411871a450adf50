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
  const auto leave_out_without = [&out](std::string_view form,
                                        std::initializer_list<std::string_view> names) {
    const bool taken = std::ranges::none_of(
        out, [&](const Parameter& p) { return p.name == form && p.value < 0.5; });
    if (taken) return;
    std::erase_if(
        out, [&](const Parameter& p) { return std::ranges::count(names, p.name) > 0; });
  };
  leave_out_without("passing", {"end"});
  leave_out_without("by_flow", {"by_flow", "flow_ratio", "flow_from", "flow_to"});
  const std::optional<NamedCurve> curve = curve_of(term.effect, term.parameters);
  if (!curve) return out;
  std::erase_if(out, [&curve](const Parameter& p) {
    return std::find(curve->inside.begin(), curve->inside.end(), p.name) !=
           curve->inside.end();
  });
  return out;
}

}  // namespace workbench
