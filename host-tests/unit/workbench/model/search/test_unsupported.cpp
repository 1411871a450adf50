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
