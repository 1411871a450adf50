// What is said of a trial that the recording does not support.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/unsupported.hpp"

namespace workbench {
namespace {

struct Said {
  CandidateStatus status;
  std::string evidence;
};

// Of a trial that takes away `share`, by chance in `p_family` of cases.
Said said(const Effect& effect, double share, double p_family, bool own = false) {
  test::SetpointLoop loop;
  loop.sensor = [](double y) { return std::round(2 * y) / 2; };
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  Trial trial;
  trial.effect = &effect;
  trial.fit = fitter.extend(fitter.start({}), effect, Effort::kScreen).value();
  trial.visible = true;
  trial.excitation = {100, "moves", 2, true};
  trial.own = own;
  trial.p_family = p_family;
  conclude_unsupported(fitter, share, trial);
  return {trial.candidate.status, trial.candidate.evidence};
}

TEST(Unsupported, ALimitThatTakesMuchAwayWasPassedThoughItMayBeChance) {
  const Effect& limit = effects::valve_saturation();
  EXPECT_EQ(said(limit, 0.8, 0.9).status, CandidateStatus::kUndecided);
  EXPECT_EQ(said(limit, 0.05, 0.9).status, CandidateStatus::kNotExcited);
  EXPECT_EQ(said(effects::process_second_lag(), 0.8, 0.9).status,
            CandidateStatus::kRejected);
}

TEST(Unsupported, WhatTheReadingsShowIsSaidThoughItTakesNothingAway) {
  const Said levels = said(effects::sensor_quantisation(), -0.01, 1e-9, true);
  EXPECT_EQ(levels.status, CandidateStatus::kRejected);
  EXPECT_NE(levels.evidence.find("0.5 y apart"), std::string::npos) << levels.evidence;
  EXPECT_NE(levels.evidence.find("hardly any of the error"), std::string::npos);
}

Said of_chance(double p_value, double p_family) {
  test::SetpointLoop loop;
  loop.delay = 6;
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  Trial trial;
  trial.effect = &effects::process_second_lag();
  trial.fit = fitter.extend(fitter.start({}), *trial.effect, Effort::kScreen).value();
  trial.visible = true;
  trial.excitation = {100, "moves", 2, true};
  trial.test.p_value = p_value;
  trial.p_family = p_family;
  trial.ratio.high = 2;
  conclude_unsupported(fitter, 0.4, trial);
  return {trial.candidate.status, trial.candidate.evidence};
}

// A score of 2.33 has to be 3.54, which takes 2.3 times as much.
TEST(Unsupported, WhatMayBeChanceIsToldHowMuchMoreItTakes) {
  const Said close = of_chance(0.01, 0.25);
  EXPECT_EQ(close.status, CandidateStatus::kUndecided);
  EXPECT_NE(close.evidence.find("may be chance; 2.5 times as long"), std::string::npos)
      << close.evidence;
  const Said many = of_chance(0.001, 0.025);
  EXPECT_NE(many.evidence.find("among so many candidates could do, too; 1.5 times"),
            std::string::npos)
      << many.evidence;
  const Said never = of_chance(0.3, 0.29);
  EXPECT_NE(never.evidence.find("What would: log the stem position"), std::string::npos)
      << never.evidence;
  const Said seldom = of_chance(1e-5, 0.001);
  EXPECT_NE(seldom.evidence.find("Record until the same happens again"),
            std::string::npos)
      << seldom.evidence;
}

TEST(Unsupported, AThousandthIsNoFigure) {
  EXPECT_EQ(percent(5.68e-8), "less than 0.1 %");
  EXPECT_EQ(percent(0.25), "25 %");
}

TEST(Unsupported, ALoadIsNeverBeyondDoubt) {
  Trial trial;
  trial.p_family = 1e-12;
  trial.effect = &effects::process_second_lag();
  EXPECT_TRUE(beyond_doubt(trial));
  trial.partner = &effects::disturbance_step();
  EXPECT_FALSE(beyond_doubt(trial));
}

}  // namespace
}  // namespace workbench
