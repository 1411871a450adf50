#include <gtest/gtest.h>

#include "ident/valve/valve_form.hpp"

namespace ident {
namespace {

TEST(ValveForm, ListsEveryFormSimplestFirst) {
  EXPECT_EQ(kValveForms, 6);
  EXPECT_EQ(static_cast<int>(ValveForm::kLinear), 0);
  EXPECT_EQ(static_cast<int>(ValveForm::kMixed), kValveForms - 1);
  for (int k = 1; k < kValveForms; ++k) {
    EXPECT_GE(free_parameters(static_cast<ValveForm>(k)),
              free_parameters(static_cast<ValveForm>(k - 1)));
  }
}

// Of deadband and two slips: none; deadband; one slip; one slip; deadband and the slip
// that both strokes share; all three.
TEST(ValveForm, CountsWhatIsFree) {
  EXPECT_EQ(free_parameters(ValveForm::kLinear), 0);
  EXPECT_EQ(free_parameters(ValveForm::kBacklash), 1);
  EXPECT_EQ(free_parameters(ValveForm::kAscending), 1);
  EXPECT_EQ(free_parameters(ValveForm::kDescending), 1);
  EXPECT_EQ(free_parameters(ValveForm::kSymmetric), 2);
  EXPECT_EQ(free_parameters(ValveForm::kMixed), 3);
}

}  // namespace
}  // namespace ident
