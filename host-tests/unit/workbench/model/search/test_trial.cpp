// What has shown beyond doubt was excited.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/model/search/trial.hpp"

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

}  // namespace
}  // namespace workbench
