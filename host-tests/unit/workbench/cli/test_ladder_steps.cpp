#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/cli/ladder_steps.hpp"

namespace workbench::cli {
namespace {

LadderStep step(std::string effect, double validation) {
  LadderStep out;
  out.effect = std::move(effect);
  out.rmse = validation;
  out.rmse_validation = validation;
  return out;
}

LadderStep without(std::string effect, double validation, bool on_the_way) {
  LadderStep out = step(std::move(effect), validation);
  out.removed = true;
  out.on_the_way = on_the_way;
  return out;
}

TEST(LadderSteps, EachHasARowAndWhatItMayAsWellBe) {
  std::vector<LadderStep> steps = {step("process", 4), step("sensor.lag", 2),
                                   without("sensor.lag", 3, false)};
  steps[1].indistinguishable_from = {"process.second_lag"};
  steps.insert(steps.begin() + 2, step("valve.backlash", 1));
  const std::string text = steps_text(steps);
  EXPECT_NE(text.find("\n      or process.second_lag: this recording cannot tell\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("  without sensor.lag "), std::string::npos) << text;
  EXPECT_NE(text.find("the simpler model: what it loses may be chance"),
            std::string::npos)
      << text;
}

TEST(LadderSteps, TwoThatOnlyHelpTogetherAreOneRow) {
  std::vector<LadderStep> steps = {step("process", 4), step("valve.rate_limit", 5),
                                   step("disturbance.step", 2)};
  steps[1].on_the_way = true;
  const std::string text = steps_text(steps);
  EXPECT_NE(text.find("  valve.rate_limit, disturbance.step\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("down 50.0 %"), std::string::npos) << text;
  EXPECT_EQ(text.find("up "), std::string::npos) << text;
}

// That it is worse without what goes is no step of its own.
TEST(LadderSteps, AnExchangeIsOneRow) {
  std::vector<LadderStep> steps = {step("process", 4), step("valve.stiction", 2),
                                   without("valve.stiction", 4.5, true),
                                   step("valve.backlash", 1)};
  steps.back().indistinguishable_from = {"sensor.lag"};
  std::string text = steps_text(steps);
  EXPECT_NE(text.find("  valve.backlash instead of valve.stiction\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("\n      or sensor.lag: "), std::string::npos) << text;
  EXPECT_EQ(text.find("4.5"), std::string::npos) << text;
  EXPECT_EQ(text.find("without"), std::string::npos) << text;
  EXPECT_EQ(text.find("takes no error away"), std::string::npos) << text;
  EXPECT_NE(text.find("1           down 50.0 %"), std::string::npos) << text;
  steps.back().on_the_way = true;
  steps.push_back(step("process.dead_time", 0.5));
  text = steps_text(steps);
  EXPECT_NE(text.find("valve.backlash, process.dead_time instead of valve.stiction"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("      valve.backlash or sensor.lag: "), std::string::npos) << text;
}

TEST(LadderSteps, WhatCameAndWentHasNoErrors) {
  const std::string text = steps_text(
      {step("process", 4), step("sensor.lag", 3.5), without("sensor.lag", 4, false)});
  EXPECT_NE(text.find("      sensor.lag is seen, but takes no error away\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("3.5"), std::string::npos) << text;
}

TEST(LadderSteps, WhatCameAndWentAgainIsToldOnce) {
  const std::string text =
      steps_text({step("process", 4), step("sensor.lag", 3.5),
                  without("sensor.lag", 4, false), step("valve.backlash", 2),
                  step("sensor.lag", 1.9), without("sensor.lag", 2, false)});
  const std::string told = "sensor.lag is seen, but takes no error away";
  EXPECT_NE(text.find(told), std::string::npos) << text;
  EXPECT_EQ(text.find(told), text.rfind(told)) << text;
}

}  // namespace
}  // namespace workbench::cli
