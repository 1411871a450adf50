#include "workbench/model/judge/unearned_form.hpp"

#include <utility>
#include <vector>

#include "workbench/model/base/work.hpp"
#include "workbench/model/judge/merit.hpp"

namespace workbench {

Fit without_unearned_forms(const Fitter& fitter, Fit fit) {
  const Work::WritingDown whatever_it_takes(fitter.work());
  for (std::size_t i = 0; i < fit.slots.size(); ++i) {
    const FreeRun::Slot& slot = fit.slots[i];
    const bool is_form = slot.effect != nullptr &&
                         !slot.effect->description().is_load() &&
                         slot.parameter.name == slot.effect->optional_form().constant;
    if (!is_form || fit.p[i] < 0.5) continue;
    std::vector<double> p = fit.p;
    p[i] = 0;
    Fit plain = fitter.refine(fitter.at(fit, std::move(p)));
    if (!lowers_error(fitter, plain, fit)) fit = std::move(plain);
  }
  return fit;
}

}  // namespace workbench
