// Effects of a model whose addition did not lower the validation error.
#include <gtest/gtest.h>

#include "workbench/model/tell/harm.hpp"

namespace workbench {
namespace {

Model with_steps(std::vector<HistoryStep> steps) {
  Model out;
  out.history = std::move(steps);
  return out;
}

TEST(Harm, IsWhereTheValidationErrorRose) {
  const Model model = with_steps({{"valve.backlash", "a.csv", 2, 1, 2, 1},
                                  {"valve.stiction", "a.csv", 1, 0.9, 1, 1.02}});
  EXPECT_EQ(harm_of(model, "valve.backlash"), nullptr);
  EXPECT_EQ(harm_of(model, "process.dead_time"), nullptr);
  const HistoryStep* harm = harm_of(model, "valve.stiction");
  ASSERT_NE(harm, nullptr);
  EXPECT_EQ(harm->rmse_validation_after, 1.02);
  EXPECT_TRUE(is_in_doubt(*harm));
}

TEST(Harm, SpeaksForNothingWhereTheErrorOfAllSamplesRoseToo) {
  const Model model = with_steps({{"sensor.lag", "a.csv", 1, 1.1, 1, 1.2}});
  ASSERT_NE(harm_of(model, "sensor.lag"), nullptr);
  EXPECT_FALSE(is_in_doubt(*harm_of(model, "sensor.lag")));
}

TEST(Harm, IsThatOfTheLastAddition) {
  const Model model = with_steps({{"sensor.lag", "a.csv", 1, 0.9, 1, 1.2},
                                  {"-sensor.lag", "a.csv", 0.9, 1, 1.2, 1},
                                  {"sensor.lag", "a.csv", 1, 0.5, 1, 0.6}});
  EXPECT_EQ(harm_of(model, "sensor.lag"), nullptr);
}

}  // namespace
}  // namespace workbench
