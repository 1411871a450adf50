// A loop that nothing but its controller moves.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/explain.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/model/search/left_to_controller.hpp"
#include "workbench/model/tell/explanation_json.hpp"

namespace workbench {
namespace {

using test::SetpointLoop;
using test::simulated;

// A load that is switched on and off every 70 samples.
SetpointLoop under_a_load() {
  SetpointLoop loop;
  loop.setpoint_moves = false;
  loop.load = [](std::size_t k) { return k / 70 % 2 == 0 ? 0.0 : 6.0; };
  return loop;
}

Told told_by(const Recording& recording, const std::vector<const Effect*>& effects = {}) {
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  return told_between(fitter, fitter.start(effects), identified);
}

// Its valve keeps it cycling once it was pushed.
SetpointLoop with_a_sticking_valve() {
  SetpointLoop loop;
  loop.setpoint_moves = false;
  loop.samples = 2400;
  loop.load = [](std::size_t k) { return k < 60 ? 8.0 : 0.0; };
  loop.valve = test::slipping();
  return loop;
}

TEST(LeftToController, ALoadAloneTellsNothingOfTheProcess) {
  const Told told = told_by(simulated(under_a_load()));
  EXPECT_TRUE(told == Told::kNothing || told == Told::kLoads);
}

TEST(LeftToController, SetpointsAndAHandTell) {
  EXPECT_EQ(told_by(simulated(SetpointLoop{})), Told::kAll);
  const std::vector<double> levels = {40, 55, 45, 60, 50};
  EXPECT_EQ(told_by(test::stepped(levels, [](double u) { return u; })), Told::kAll);
}

// The verdict on the valve is asked for where u follows the law.
TEST(LeftToController, WhereTheTimeIsUpNothingIsTriedAndAllIsSaidToBeOpen) {
  const Recording recording = simulated(with_a_sticking_valve());
  const Work work({.seconds = 1e-6});
  const Model model = [&] {
    const Work::WritingDown whatever_it_takes(work);
    return start_model(recording, Column::y, {}, standard_catalogue(), work).model;
  }();
  const ExplainResult result = explain(recording, model, {}, standard_catalogue(), work);
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(result.best(), nullptr);
  EXPECT_EQ(result.candidates.size(), standard_catalogue().effects().size());
}

TEST(LeftToController, AValveThatMakesTheLoopCycleComesFirst) {
  const Recording recording = simulated(with_a_sticking_valve());
  EXPECT_EQ(told_by(recording), Told::kStemsFirst);
  EXPECT_EQ(told_by(recording, {&effects::valve_stiction()}), Told::kAll);
}

TEST(LeftToController, WithoutAStemWhatLiesBetweenIsLeftOpen) {
  std::vector<Trial> trials(4);
  trials[0].effect = &effects::process_dead_time();
  trials[1].effect = &effects::process_dead_time();
  trials[1].partner = &effects::valve_stiction();
  trials[2].effect = &effects::disturbance_ramp();
  trials[3].effect = &effects::valve_backlash();
  for (Trial& trial : trials) trial.candidate.status = CandidateStatus::kAccepted;
  leave_untold(Told::kStemsFirst, trials);
  EXPECT_FALSE(accepted(trials[0]));
  EXPECT_NE(trials[0].candidate.evidence.find("finds a stem"), std::string::npos);
  EXPECT_TRUE(accepted(trials[1]));
  EXPECT_TRUE(accepted(trials[2])) << "a load is not between u and y";
  EXPECT_TRUE(accepted(trials[3]));
}

TEST(LeftToController, WhatSwingsMayBeTheLoopItself) {
  std::vector<Trial> trials(2);
  trials[0].effect = &effects::disturbance_sinusoid();
  trials[1].effect = &effects::disturbance_step();
  for (Trial& trial : trials) trial.candidate.status = CandidateStatus::kAccepted;
  leave_untold(Told::kAll, trials);
  EXPECT_TRUE(accepted(trials[0]));
  leave_untold(Told::kNothing, trials);
  EXPECT_FALSE(accepted(trials[0]));
  EXPECT_TRUE(accepted(trials[1]));
}

// What is left of a dead time that was accepted, u moved by the setpoint and the load by
// so much.
Candidate accepted_beside(double load) {
  SetpointLoop loop = under_a_load();
  loop.setpoint_moves = true;
  loop.load = [load](std::size_t k) { return k / 70 % 2 == 0 ? 0.0 : load; };
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  std::vector<Trial> trials(2);
  for (Trial& trial : trials) trial.candidate.status = CandidateStatus::kAccepted;
  trials[0].effect = &effects::process_dead_time();
  trials[0].fit = fitter.start({trials[0].effect});
  trials[1].effect = &effects::valve_backlash();
  trials[1].fit = fitter.start({trials[1].effect});
  leave_under_loads(fitter, trials);
  EXPECT_TRUE(accepted(trials[1])) << "the identification judges stems";
  return trials[0].candidate;
}

TEST(LeftToController, ALoadThatMovesMoreThanUDoesLeavesTheProcessOpen) {
  EXPECT_EQ(accepted_beside(2).status, CandidateStatus::kAccepted);
  const Candidate left = accepted_beside(30);
  EXPECT_EQ(left.status, CandidateStatus::kUndecided);
  EXPECT_NE(left.evidence.find("record the load"), std::string::npos);
}

TEST(LeftToController, ARecordedLoadTells) {
  Recording recording = simulated(under_a_load());
  Load load{.name = "FI-1"};
  for (std::size_t k = 0; k < recording.size(); ++k) {
    load.values.push_back(under_a_load().load(k));
  }
  recording.loads.push_back(load);
  const Catalogue catalogue = standard_catalogue().with(recording.loads);
  const auto found = std::ranges::find_if(catalogue.effects(), [](const Effect* effect) {
    return effect->description().recorded;
  });
  ASSERT_NE(found, catalogue.effects().end());
  EXPECT_EQ(told_by(recording, {*found}), Told::kAll);
}

TEST(LeftToController, NothingBetweenUAndYIsNamed) {
  const Recording recording = simulated(under_a_load());
  const Model model = start_model(recording, Column::y).model;
  const ExplainResult result = explain(recording, model);
  EXPECT_TRUE(result.left_to_controller);
  EXPECT_EQ(explanation_json(result)["left_to_controller"], true);
  EXPECT_FALSE(result.explained) << "the model may be that of the controller";
  for (const Candidate& candidate : result.candidates) {
    const Effect* effect = standard_catalogue().find(candidate.effect);
    if (!effect->description().needs_u) continue;
    EXPECT_EQ(candidate.status, CandidateStatus::kNotExcited) << candidate.effect;
    EXPECT_NE(candidate.evidence.find("little but the controller"), std::string::npos);
  }
}

}  // namespace
}  // namespace workbench
