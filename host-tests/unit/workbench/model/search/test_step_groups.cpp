#include <gtest/gtest.h>

#include <vector>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/step_groups.hpp"

namespace workbench {
namespace {

Candidate left_over(std::string effect, CandidateStatus status) {
  Candidate out;
  out.effect = std::move(effect);
  out.status = status;
  out.evidence = "No more than chance.";
  return out;
}

TEST(StepGroups, AreLookedForAgainBesideASecondEffect) {
  test::SetpointLoop loop;
  loop.delay = 8;
  loop.load = [](std::size_t k) { return k >= 600 ? 3.0 : 0.0; };
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit fit =
      fitter.start({&effects::process_dead_time(), &effects::disturbance_step()});
  std::vector<LadderStep> steps(2);
  steps[0].effect = "process.dead_time";
  steps[0].indistinguishable_from = {"valve.backlash"};
  steps[1].effect = "disturbance.step";
  group_anew(fitter, fit, {&effects::process_dead_time()}, standard_catalogue(), steps);
  EXPECT_EQ(steps[0].indistinguishable_from, std::vector<std::string>{"valve.backlash"});
  group_anew(fitter, fit, {}, standard_catalogue(), steps);
  EXPECT_TRUE(steps[0].indistinguishable_from.empty());
}

// What adds nothing beside its rival was not rejected for that.
TEST(StepGroups, RivalsOfWhatIsInTheModelAreNotRejected) {
  Model model;
  model.effects = {{"process.second_lag", {}}};
  std::vector<LadderStep> steps(3);
  steps[0].effect = "process";
  steps[1].effect = "process.second_lag";
  steps[1].indistinguishable_from = {"sensor.lag", "valve.positioner_lag"};
  steps[2].effect = "valve.backlash";  // no longer in the model
  steps[2].indistinguishable_from = {"valve.stiction"};
  std::vector<Candidate> left = {
      left_over("sensor.lag", CandidateStatus::kRejected),
      left_over("valve.positioner_lag", CandidateStatus::kNotExcited),
      left_over("valve.stiction", CandidateStatus::kRejected)};
  leave_rivals_open(steps, model, standard_catalogue(), left);
  EXPECT_EQ(left[0].status, CandidateStatus::kUndecided);
  EXPECT_EQ(left[0].indistinguishable_from,
            std::vector<std::string>{"process.second_lag"});
  EXPECT_TRUE(left[0].would_split.has_value());
  EXPECT_NE(left[0].evidence.find("in the place of process.second_lag"),
            std::string::npos);
  EXPECT_EQ(left[1].status, CandidateStatus::kNotExcited);
  EXPECT_EQ(left[1].evidence, "No more than chance.");
  EXPECT_EQ(left[2].status, CandidateStatus::kRejected);
  EXPECT_TRUE(left[2].indistinguishable_from.empty());
}

}  // namespace
}  // namespace workbench
