// The verdict on the valve beside the model of the loop.
#include <gtest/gtest.h>

#include "support/setpoint_loop.hpp"
#include "workbench/report/valve_parts.hpp"

namespace workbench {
namespace {

using ident::Verdict;

class ValveParts : public ::testing::Test {
 protected:
  // A model with `effects`, of which explain() says that `missing` is missing.
  std::string said(Verdict verdict, const std::vector<std::string>& effects,
                   const std::string& missing) {
    model_.effects.clear();
    for (const std::string& effect : effects) model_.effects.push_back({effect, {}});
    ModelReport report{recording_, model_, {}, {}};
    if (!missing.empty()) {
      Candidate candidate;
      candidate.effect = missing;
      candidate.status = CandidateStatus::kAccepted;
      report.explanation.candidates.push_back(candidate);
    }
    return reconciled(verdict, report);
  }

  Recording recording_;
  Model model_;
};

TEST_F(ValveParts, SayNothingWhereVerdictAndModelAgree) {
  for (const Verdict fault : {Verdict::kStiction, Verdict::kBacklash}) {
    EXPECT_EQ(said(fault, {}, "valve.stiction"), "");
    EXPECT_EQ(said(fault, {"valve.backlash"}, ""), "");
    EXPECT_EQ(said(fault, {"valve.stiction"}, "process.dead_time"), "");
  }
  for (const Verdict none : {Verdict::kNoStiction, Verdict::kUndecided}) {
    EXPECT_EQ(said(none, {}, "process.dead_time"), "");
    EXPECT_EQ(said(none, {"sensor.lag"}, ""), "");
  }
}

TEST_F(ValveParts, SayHowBothAreMeantWhereTheyDisagree) {
  const std::vector<std::string> all = {
      said(Verdict::kStiction, {}, ""), said(Verdict::kStiction, {}, "process.dead_time"),
      said(Verdict::kNoStiction, {}, "valve.stiction"),
      said(Verdict::kUndecided, {"valve.stiction"}, "")};
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_FALSE(all[i].empty());
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(all[i], all[k]);
  }
  EXPECT_EQ(said(Verdict::kNoStiction, {"valve.backlash"}, ""), all[2]);
}

TEST_F(ValveParts, NameVerdictNumbersAndCure) {
  const Recording recording = test::simulated(test::SetpointLoop{});
  Analysis analysis(recording);
  const ReportData data{recording, analysis, analysis.simulate(), std::nullopt};
  EXPECT_NE(valve_verdict(data).find("<h1>"), std::string::npos);
  EXPECT_NE(valve_tiles(data).find("class=\"tile\""), std::string::npos);
}

}  // namespace
}  // namespace workbench
