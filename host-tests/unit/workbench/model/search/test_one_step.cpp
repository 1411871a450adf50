// A model from the start, and with one effect more or less.
#include <gtest/gtest.h>

#include <stdexcept>

#include "support/workbench/serve_session.hpp"
#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/search/one_step.hpp"

namespace workbench {
namespace {

TEST(OneStep, RefusesUnknownAndRepeatedEffects) {
  const Recording recording = test::simulated({});
  EXPECT_THROW((void)start_model(recording, Column::y, {"no.such"}),
               std::invalid_argument);
  EXPECT_THROW((void)start_model(recording, Column::y, {"sensor.lag", "sensor.lag"}),
               std::invalid_argument);
  const Model model = start_model(recording, Column::y, {"process.dead_time"}).model;
  EXPECT_THROW((void)add_effect(recording, model, "process.dead_time"),
               std::invalid_argument);
  EXPECT_THROW((void)remove_effect(recording, model, "sensor.lag"),
               std::invalid_argument);
}

TEST(OneStep, TakesAnEffectOutAgain) {
  const Recording recording = test::late_recording();
  const FittedModel before = start_model(recording, Column::y);
  const FittedModel with = add_effect(recording, before.model, "process.dead_time");
  const FittedModel after = remove_effect(recording, with.model, "process.dead_time");
  EXPECT_TRUE(after.model.effects.empty());
  EXPECT_NEAR(after.quality.rmse, before.quality.rmse, 0.01 * before.quality.rmse);
  const HistoryStep& step = after.model.history.back();
  EXPECT_EQ(step.effect, "-process.dead_time");
  EXPECT_NEAR(step.rmse_before, with.quality.rmse, 1e-6);
  EXPECT_GT(step.rmse_validation_after, step.rmse_validation_before);
}

}  // namespace
}  // namespace workbench
