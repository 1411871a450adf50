// What has shown beyond doubt was excited.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/model/search/trial.hpp"
#include "workbench/model/tell/curve_of.hpp"

namespace workbench {
namespace {

ExplainResult explained(const Recording& recording) {
  return explain(recording, start_model(recording, Column::y).model);
}

CandidateStatus status_of(const ExplainResult& result, std::string_view effect) {
  for (const Candidate& candidate : result.candidates) {
    if (candidate.effect == effect) return candidate.status;
  }
  return CandidateStatus::kRejected;
}

// After the first move no other one is wider than the gap: none of its events is counted.
TEST(Trial, PlayWiderThanAnyReversalShowsAllTheSame) {
  constexpr double kLevels[] = {50, 60, 53, 59, 55, 61, 54, 58};
  const ExplainResult result = explained(test::stepped(kLevels, test::backlash(9)));
  ASSERT_NE(result.best(), nullptr);
  EXPECT_EQ(result.best()->effect, "valve.backlash");
}

TEST(Trial, WhatDidNotShowIsNotExcited) {
  constexpr double kLevels[] = {50, 52, 54, 56, 58, 60};
  const ExplainResult result = explained(test::stepped(kLevels, test::backlash(1)));
  EXPECT_EQ(status_of(result, "valve.backlash"), CandidateStatus::kNotExcited);
}

// That its own values leave it few events says that they are not sure, no more.
TEST(Trial, WhatShowsInFewEventsIsInDoubt) {
  constexpr double kLevels[] = {50, 60, 53, 59, 55, 61, 54, 58};
  const Recording recording = test::stepped(kLevels, test::backlash(9));
  const Fitter fitter(recording, Column::y);
  const Fit base = fitter.start({});
  Trial trial;
  trial.effect = &effects::valve_backlash();
  trial.fit = fitter.extend(base, *trial.effect, Effort::kThorough);
  trial.visible = true;
  trial.p_family = 0.01;
  trial.excitation = {1, "reversals", 2};
  conclude(fitter, base, trial);
  EXPECT_EQ(trial.candidate.status, CandidateStatus::kUndecided);
  EXPECT_NE(trial.candidate.evidence.find("too few reversals"), std::string::npos);
  trial.excitation.events = 0;
  conclude(fitter, base, trial);
  EXPECT_EQ(trial.candidate.status, CandidateStatus::kNotExcited);
}

// Which way is the wrong one, where u has no part in y?
TEST(Trial, AWrongWayNeedsTheSignOfTheGain) {
  Recording recording = test::simulated({});
  std::rotate(recording.y.begin(), recording.y.begin() + 517, recording.y.end());
  const Fitter fitter(recording, Column::y);
  Trial trial;
  trial.effect = &effects::process_inverse_response();
  trial.fit = fitter.extend(fitter.start({}), *trial.effect, Effort::kScreen);
  ASSERT_TRUE(trial.fit);
  trial.p_family = 1e-3;
  check_intervals(fitter, trial);
  EXPECT_NE(trial.objection.find("which is the wrong one"), std::string::npos)
      << trial.objection;
}

// A valve opened by hand in small steps: each level comes once.
TEST(Trial, ASweepInSmallStepsShowsTheCurveOfTheValve) {
  struct Case {
    const char* kind;
    std::function<double(double)> flow;  // of the share of the stroke
  };
  const Case cases[] = {
      {"equal_percentage", [](double x) { return (std::pow(30, x) - 1) / 29; }},
      {"quick_opening", [](double x) { return std::sqrt(x); }},
      {"s_shaped", [](double x) { return x * x * (3 - 2 * x); }}};
  std::vector<double> levels;
  for (int level = 0; level <= 100; level += 5) levels.push_back(level);
  for (const auto& [kind, flow] : cases) {
    const ExplainResult result = explained(
        test::stepped(levels, [&flow = flow](double u) { return 100 * flow(u / 100); }));
    ASSERT_NE(result.best(), nullptr) << kind;
    EXPECT_EQ(result.best()->effect, "valve.characteristic") << kind;
    const auto curve = curve_of(result.best()->effect, result.best()->parameters);
    ASSERT_TRUE(curve) << kind;
    EXPECT_EQ(curve->kind, kind);
  }
}

}  // namespace
}  // namespace workbench
