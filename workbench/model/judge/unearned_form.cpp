#include "workbench/model/judge/unearned_form.hpp"

#include <span>
#include <utility>
#include <vector>

#include "ident/signal/signal_shape.hpp"
#include "workbench/model/base/noise.hpp"
#include "workbench/model/base/work.hpp"
#include "workbench/model/judge/merit.hpp"

namespace workbench {
namespace {

// A form bends what u does: nothing linear that the plain one lacks may look like it.
bool is_earned(const Fitter& fitter, const Fit& plain, const Fit& form) {
  if (!lowers_error(fitter, plain, form)) return false;
  const std::span<const double> u = fitter.situation(form).u;
  if (ident::moves_rarely<double>(u)) return true;
  return is_seen(test_given_past(plain.residual, form.residual, u, fitter.blocks()));
}

}  // namespace

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
    if (!is_earned(fitter, plain, fit)) fit = std::move(plain);
  }
  return fit;
}

}  // namespace workbench
