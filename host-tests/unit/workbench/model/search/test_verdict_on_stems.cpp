// A stem that the identification would have seen, and did not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/verdict_on_stems.hpp"

namespace workbench {
namespace {

using test::SetpointLoop;
using test::simulated;

// A loop whose valve has play of 6 in u.
Recording with_play() {
  SetpointLoop loop;
  loop.samples = 2400;
  loop.valve = test::backlash(6);
  return simulated(loop);
}

// Play as wide as `band`, in a model that gains from it.
Trial trial_of_play(const Fitter& fitter, double band) {
  Trial trial;
  trial.effect = &effects::valve_backlash();
  trial.fit = fitter.extend(fitter.start({}), effects::valve_backlash(), Effort::kScreen);
  for (std::size_t i = 0; i < trial.fit->p.size(); ++i) {
    if (trial.fit->slots[i].parameter.name == "deadband") trial.fit->p[i] = band;
  }
  trial.candidate.status = CandidateStatus::kAccepted;
  return trial;
}

TEST(VerdictOnStems, RefutesABandThatWouldHaveShown) {
  SetpointLoop loop;
  loop.samples = 2400;
  loop.load = [](std::size_t k) { return 3 * std::sin(double(k) / 4); };
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  const VerdictOnStems verdict(fitter, identified);
  const auto excluded = verdict.excluded_from();
  ASSERT_TRUE(excluded);
  Trial wide = trial_of_play(fitter, 1.2 * *excluded);
  verdict.refute(wide);
  EXPECT_FALSE(wide.unconfirmed) << "it is known not to be there";
  EXPECT_EQ(wide.candidate.status, CandidateStatus::kUndecided);
  EXPECT_NE(wide.candidate.evidence.find("would have shown"), std::string::npos);
  Trial narrow = trial_of_play(fitter, 0.8 * *excluded);
  verdict.refute(narrow);
  EXPECT_EQ(narrow.candidate.status, CandidateStatus::kAccepted);
}

// Too short to say how narrow a band would have shown, long enough to try stems.
TEST(VerdictOnStems, RefutesEveryBandWhereTheClosestStemForetellsNothing) {
  SetpointLoop loop;
  loop.load = [](std::size_t k) { return 3 * std::sin(double(k) / 4); };
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  ASSERT_EQ(identified.result({}).verdict, ident::Verdict::kUndecided);
  ASSERT_TRUE(identified.result({}).evidence.stem_weighed);
  Trial narrow = trial_of_play(fitter, 0.5);
  VerdictOnStems(fitter, identified).refute(narrow);
  EXPECT_TRUE(narrow.unconfirmed);
  EXPECT_EQ(narrow.candidate.status, CandidateStatus::kUndecided);
  EXPECT_NE(narrow.candidate.evidence.find("does not foretell"), std::string::npos);
}

TEST(VerdictOnStems, RefutesAStemWhereNoneIsCloserThanALinearProcess) {
  const Recording recording = simulated({});
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  ASSERT_EQ(identified.result({}).verdict, ident::Verdict::kUndecided);
  ASSERT_EQ(identified.result({}).evidence.form, ident::ValveForm::kLinear);
  Trial play = trial_of_play(fitter, 2);
  VerdictOnStems(fitter, identified).refute(play);
  EXPECT_EQ(play.candidate.status, CandidateStatus::kUndecided);
  EXPECT_NE(play.candidate.evidence.find("no sticking valve"), std::string::npos);
}

// The load drowns the stem: no band is excluded, with the load in the model or without.
TEST(VerdictOnStems, RefutesNoStemThatALoadDrowns) {
  SetpointLoop loop;
  loop.samples = 1500;
  loop.noise_std = 0.05;
  loop.setpoint_moves = false;
  loop.valve = test::backlash(4);
  std::vector<double> feed;
  std::vector<double> arrived = {0};
  for (std::size_t k = 0; k < loop.samples; ++k) {
    feed.push_back(k / 97 % 4 == 0   ? 0
                   : k / 97 % 4 == 1 ? 30
                   : k / 97 % 4 == 2 ? -20
                                     : 10);
    arrived.push_back(arrived.back() + (feed.back() - arrived.back()) / 20);
  }
  loop.load = [&arrived](std::size_t k) { return arrived[k]; };
  Recording recording = simulated(loop);
  recording.loads = {{"feed", "t/h", feed}};
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  const VerdictOnStems verdict(fitter, identified);
  const auto excluded = verdict.excluded_from();
  EXPECT_TRUE(!excluded || *excluded > 4);
  Trial unaware = trial_of_play(fitter, 4);
  verdict.refute(unaware);
  EXPECT_EQ(unaware.candidate.status, CandidateStatus::kAccepted);
  Trial aware = unaware;
  aware.fit = fitter.extend(*unaware.fit, effects::disturbance_measured("feed"),
                            Effort::kThorough);
  verdict.refute(aware);
  EXPECT_EQ(aware.candidate.status, CandidateStatus::kAccepted);
}

// What is known to move the output hides no stem: a load step, of which the model knows.
TEST(VerdictOnStems, AsksOfTheOutputLessTheLoadsOfTheModel) {
  const std::vector<double> levels = {50, 56, 47, 55, 50, 58, 49};
  Recording recording = test::stepped(levels, test::backlash(3));
  const std::size_t middle = recording.y.size() / 2;
  for (std::size_t k = middle; k < recording.y.size(); ++k) {
    recording.y[k] += 15 * (1 - std::exp(-double(k - middle) / 20));
  }
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  const VerdictOnStems verdict(fitter, identified);
  Trial unaware = trial_of_play(fitter, 3);
  verdict.refute(unaware);
  EXPECT_EQ(unaware.candidate.status, CandidateStatus::kUndecided);
  Trial aware = trial_of_play(fitter, 3);
  aware.fit = fitter.extend(*aware.fit, effects::disturbance_step(), Effort::kThorough);
  verdict.refute(aware);
  EXPECT_EQ(aware.candidate.status, CandidateStatus::kAccepted);
}

// Tuned so that a valve of limited speed keeps it swinging.
TEST(VerdictOnStems, RefutesPlayWhereASlowValveForetellsMore) {
  SetpointLoop loop;
  loop.samples = 2400;
  loop.setpoint_moves = false;
  loop.delay = 20;
  loop.valve = [x = 50.0](double u) mutable { return x += std::clamp(u - x, -0.4, 0.4); };
  loop.load = [](std::size_t k) { return k < 60 ? 15 : k / 397 % 2 == 0 ? 2.0 : -2.0; };
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  ASSERT_EQ(identified.result({}).reason, ident::Reason::kStemBounded);
  Trial play = trial_of_play(fitter, 4);
  VerdictOnStems(fitter, identified).refute(play);
  EXPECT_EQ(play.candidate.status, CandidateStatus::kUndecided);
  EXPECT_NE(play.candidate.evidence.find("moves slowly"), std::string::npos);
}

TEST(VerdictOnStems, LeavesAloneWhatIsNoStem) {
  const Recording recording = simulated({});
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  const VerdictOnStems verdict(fitter, identified);
  Trial trial = trial_of_play(fitter, 40);
  trial.effect = &effects::process_dead_time();
  verdict.refute(trial);
  EXPECT_EQ(trial.candidate.status, CandidateStatus::kAccepted);
}

TEST(VerdictOnStems, KnowsNoBandWhereTheValveIsAtFault) {
  const Recording recording = with_play();
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  EXPECT_FALSE(VerdictOnStems(fitter, identified).excluded_from());
}

// A gain that chance may be, of a stem that the identification found.
TEST(VerdictOnStems, ConfirmsTheStemThatItFoundAndNoOtherWidth) {
  const Recording recording = with_play();
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  const VerdictOnStems verdict(fitter, identified);
  const auto doubtful = [&fitter](double band) {
    Trial trial = trial_of_play(fitter, band);
    trial.candidate.status = CandidateStatus::kRejected;
    trial.candidate.error_reduction_percent = 5;
    trial.candidate.p_value = trial.test.p_value = 0.4;
    return trial;
  };
  std::vector<Trial> trials = {doubtful(6)};
  verdict.confirm(trials);
  EXPECT_EQ(trials[0].candidate.status, CandidateStatus::kAccepted);
  EXPECT_LT(trials[0].candidate.p_value, 1e-15);
  EXPECT_FALSE(trials[0].candidate.parameters.empty());

  trials = {doubtful(15)};
  verdict.confirm(trials);
  EXPECT_EQ(trials[0].candidate.status, CandidateStatus::kRejected) << "another width";

  trials = {doubtful(6)};
  trials[0].candidate.error_reduction_percent = -1;
  verdict.confirm(trials);
  EXPECT_EQ(trials[0].candidate.status, CandidateStatus::kRejected) << "a larger error";

  trials = {doubtful(6), trial_of_play(fitter, 6)};
  verdict.confirm(trials);
  EXPECT_EQ(trials[0].candidate.status, CandidateStatus::kRejected) << "nothing in doubt";
}

// Only where a load that steps at will would come before it.
TEST(VerdictOnStems, MarksTheStemThatItFoundAndNoOtherWidth) {
  const Recording recording = with_play();
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  const VerdictOnStems verdict(fitter, identified);
  const auto marked = [&](double band, const Effect& other) {
    std::vector<Trial> trials = {trial_of_play(fitter, band)};
    trials.emplace_back().effect = &other;
    verdict.mark(trials);
    EXPECT_FALSE(trials[1].identified);
    return trials[0].identified;
  };
  EXPECT_TRUE(marked(6, effects::disturbance_step()));
  EXPECT_FALSE(marked(15, effects::disturbance_step())) << "another width";
  EXPECT_FALSE(marked(6, effects::process_dead_time())) << "no load";
  EXPECT_FALSE(marked(6, effects::disturbance_sinusoid())) << "not at will";
}

TEST(VerdictOnStems, ConfirmsNothingWhereTheValveFollows) {
  const Recording recording = simulated({});
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  std::vector<Trial> trials = {trial_of_play(fitter, 1)};
  trials[0].candidate.status = CandidateStatus::kRejected;
  trials[0].candidate.error_reduction_percent = 5;
  VerdictOnStems(fitter, identified).confirm(trials);
  EXPECT_EQ(trials[0].candidate.status, CandidateStatus::kRejected);
}

}  // namespace
}  // namespace workbench
