// A fit as it is told.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/judge/fitted_model.hpp"

namespace workbench {
namespace {

TEST(FittedModel, TheIntervalsOfTwoLimitsDoNotCross) {
  test::SetpointLoop loop;
  loop.valve = [](double u) { return std::clamp(u, 46.0, 53.0); };
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const ToldFit told = told_of(fitter, fitter.start({&effects::valve_saturation()}));
  const Model model = model_of(fitter, told);
  ASSERT_EQ(model.effects.size(), 1u);
  const Parameter* lower = find(model.effects[0].parameters, "lower_limit");
  const Parameter* upper = find(model.effects[0].parameters, "upper_limit");
  ASSERT_TRUE(lower != nullptr && upper != nullptr);
  EXPECT_LE(lower->high, upper->low);
  EXPECT_LE(lower->value, lower->high);
  EXPECT_LE(upper->low, upper->value);
}

}  // namespace
}  // namespace workbench
