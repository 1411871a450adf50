#include "ident/verdict/evidence.hpp"

#include <algorithm>
#include <cmath>

#include "ident/base/elementary.hpp"

namespace ident {
namespace {

// Below this share of the variance of y an error is nothing but rounding.
constexpr double kLeastError = 1e-9;

template <class Real>
Real error_of(const ValveSearch<Real>& search, ValveForm form) {
  return std::max(search.best(form).fit.error,
                  static_cast<Real>(search.window().y.size()) * Real(kLeastError));
}

// Equation (E2).
template <class Real>
ValveForm choose_form(const ValveSearch<Real>& search, Real observations) {
  const Real cost =
      Real(0.5) * elementary::log(std::max(observations, Real(3))) + Real(2);
  ValveForm chosen = ValveForm::kLinear;
  Real lowest = 0;
  for (int k = 0; k < kValveForms; ++k) {
    const ValveForm form = static_cast<ValveForm>(k);
    if (!search.best(form).known) {
      continue;
    }
    const Real total =
        Real(0.5) * observations * elementary::log(error_of(search, form)) +
        cost * static_cast<Real>(free_parameters(form));
    if (k == 0 || total < lowest) {
      lowest = total;
      chosen = form;
    }
  }
  return chosen;
}

}  // namespace

template <class Real>
void weigh_forms(const ValveSearch<Real>& search, Evidence<Real>& evidence) {
  evidence.form = choose_form(search, evidence.observations);
  const ValveModel<Real>& chosen = search.best(evidence.form);
  const Real linear = error_of(search, ValveForm::kLinear);
  const Real error = error_of(search, evidence.form);
  evidence.error_ratio = linear / error;
  const Real jumpless = search.best(ValveForm::kBacklash).known
                            ? std::min(error_of(search, ValveForm::kBacklash), linear)
                            : linear;
  evidence.jump_ratio = jumpless / error;
  // Equation (E3).
  const Real cost = Real(0.5) * elementary::log(std::max(evidence.observations, Real(3)));
  evidence.score =
      Real(0.5) * evidence.observations * elementary::log(evidence.error_ratio) -
      cost * static_cast<Real>(free_parameters(evidence.form));
  const ValveFriction<Real>& friction = chosen.friction;
  const Real swing = search.window().swing;
  evidence.band_over_swing =
      std::max(friction.stick_ascending(), friction.stick_descending()) / swing;
  const Real band = evidence.band_over_swing * swing;
  evidence.slip_over_band =
      band > Real(0) ? std::max(friction.slip_ascending, friction.slip_descending) / band
                     : Real(0);
  const Real samples = static_cast<Real>(search.window().y.size());
  evidence.fit_percent = Real(100) * (Real(1) - std::sqrt(chosen.fit.error / samples));
  evidence.fit_linear_percent = Real(100) * (Real(1) - std::sqrt(linear / samples));
  const Real slow = chosen.poles.slow;
  evidence.time_constant =
      slow > Real(0) && slow < Real(1)
          ? Real(-1) / (elementary::log(slow) * search.window().period)
          : (slow < Real(1) ? Real(0) : Real(100));
}

template void weigh_forms<float>(const ValveSearch<float>&, Evidence<float>&);
template void weigh_forms<double>(const ValveSearch<double>&, Evidence<double>&);

}  // namespace ident
