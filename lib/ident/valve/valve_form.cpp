#include "ident/valve/valve_form.hpp"

namespace ident {

int free_parameters(ValveForm form) {
  switch (form) {
    case ValveForm::kLinear:
      return 0;
    case ValveForm::kBacklash:
    case ValveForm::kAscending:
    case ValveForm::kDescending:
      return 1;
    case ValveForm::kSymmetric:
      return 2;
    case ValveForm::kMixed:
      return 3;
  }
  return 0;
}

}  // namespace ident
