// Which of several accepted trials is the best, and what becomes of the others.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/choice.hpp"

namespace workbench {
namespace {

Trial accepted_trial(const Effect& effect, const Effect* partner, Fit fit) {
  Trial trial;
  trial.effect = &effect;
  trial.partner = partner;
  trial.fit = std::move(fit);
  trial.candidate.effect = effect.code();
  trial.candidate.status = CandidateStatus::kAccepted;
  trial.candidate.error_reduction_percent = 30;
  return trial;
}

// Each of the two passes alone; none is rejected because of itself.
TEST(Choice, TheTwoOfTheBestPairAreToldThatTheyAreOne) {
  test::SetpointLoop loop;
  loop.delay = 8;
  loop.load = [](std::size_t k) { return k >= 600 ? 3.0 : 0.0; };
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit base = fitter.start({});
  const Effect& delay = effects::process_dead_time();
  const Effect& step = effects::disturbance_step();
  const auto with = [&](const Fit& fit, const Effect& effect) {
    return fitter.extend(fit, effect, Effort::kThorough).value();
  };
  std::vector<Trial> trials;
  trials.push_back(accepted_trial(delay, nullptr, with(base, delay)));
  trials.push_back(accepted_trial(step, nullptr, with(base, step)));
  trials.push_back(accepted_trial(step, &delay, with(with(base, step), delay)));
  const Trial* best = choose(fitter, trials);
  ASSERT_EQ(best, &trials[2]);
  for (std::size_t i = 0; i < 2; ++i) {
    const Candidate& c = trials[i].candidate;
    EXPECT_EQ(c.status, CandidateStatus::kUndecided) << c.effect;
    EXPECT_EQ(c.evidence,
              "Alone it would take away 30 % of the squared error; the pair "
              "disturbance.step with process.dead_time explains more.");
  }
}

// The recording showed them in the pair: it exercised both.
TEST(Choice, AMemberOfTheBestPairThatDoesNotShowAloneSaysWithWhat) {
  test::SetpointLoop loop;
  loop.delay = 8;
  loop.load = [](std::size_t k) { return k >= 600 ? 3.0 : 0.0; };
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Effect& delay = effects::process_dead_time();
  const Effect& step = effects::disturbance_step();
  const Effect& limit = effects::valve_saturation();
  const Fit one = fitter.extend(fitter.start({}), delay, Effort::kThorough).value();
  const Fit both = fitter.extend(one, step, Effort::kThorough).value();
  std::vector<Trial> trials;
  for (const Effect* effect : {&delay, &step, &limit}) {
    trials.push_back(accepted_trial(*effect, nullptr, both));
    trials.back().candidate.evidence = "It would not show.";
  }
  trials[0].candidate.status = CandidateStatus::kRejected;
  trials[1].candidate.status = CandidateStatus::kNotExcited;
  trials[2].candidate.status = CandidateStatus::kNotExcited;
  trials.push_back(accepted_trial(step, &delay, both));
  ASSERT_EQ(choose(fitter, trials), &trials[3]);
  EXPECT_EQ(trials[0].candidate.status, CandidateStatus::kUndecided);
  EXPECT_EQ(trials[0].candidate.evidence,
            "It shows only together with disturbance.step.");
  EXPECT_EQ(trials[1].candidate.status, CandidateStatus::kUndecided);
  EXPECT_EQ(trials[1].candidate.evidence,
            "It shows only together with process.dead_time.");
  EXPECT_EQ(trials[2].candidate.status, CandidateStatus::kNotExcited);
  EXPECT_EQ(trials[2].candidate.evidence, "It would not show.");
}

// What the readings themselves show comes first, but not before what explains nearly all.
TEST(Choice, AFactMakesRoomForWhatExplainsNearlyAll) {
  test::SetpointLoop loop;
  loop.delay = 8;
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit base = fitter.start({});
  const Effect& delay = effects::process_dead_time();
  const Fit closer = fitter.extend(base, delay, Effort::kThorough).value();
  ASSERT_LT(fitter.rmse_on(closer, false), 0.3 * fitter.rmse_on(base, false));
  const auto first = [&](const Fit& of_the_delay) {
    std::vector<Trial> trials;
    trials.push_back(accepted_trial(effects::sensor_sticking(), nullptr, base));
    trials.back().own = true;
    trials.push_back(accepted_trial(delay, nullptr, of_the_delay));
    return choose(fitter, trials)->candidate.effect;
  };
  EXPECT_EQ(first(closer), "process.dead_time");
  Fit hardly = base;
  for (double& value : hardly.residual) value *= 0.9;
  EXPECT_EQ(first(hardly), "sensor.sticking");
}

TEST(Choice, FewerParametersAndLessErrorComeFirst) {
  test::SetpointLoop loop;
  loop.delay = 8;
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Effect& rate = effects::valve_rate_limit();
  const Effect& delay = effects::process_dead_time();
  std::vector<Trial> trials;
  const Fit simple = fitter.start({&delay});
  Fit rich = fitter.start({&rate});
  rich.residual = simple.residual;
  // A little more in all, and less whitened.
  for (std::size_t k = 0; k < rich.residual.size(); ++k) {
    rich.residual[k] += 0.02 * (1 + std::sin(static_cast<double>(k) / 100));
  }
  trials.push_back(accepted_trial(rate, nullptr, rich));
  trials.push_back(accepted_trial(delay, nullptr, simple));
  EXPECT_EQ(choose(fitter, trials), &trials[1]);
}

// That y comes later is told by either; a dead time that leaves less is not ruled out.
TEST(Choice, ALagIsNotToldFromADeadTimeThatLeavesLess) {
  test::SetpointLoop loop;
  loop.delay = 8;
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Effect& lag = effects::process_second_lag();
  const Effect& delay = effects::process_dead_time();
  const auto rivals = [&](const Effect& named, const Effect& other) {
    std::vector<Trial> trials;
    for (const Effect* effect : {&named, &other}) {
      trials.push_back(accepted_trial(*effect, nullptr, fitter.start({effect})));
    }
    trials[1].candidate.status = CandidateStatus::kRejected;
    trials[1].excitation.events = 99;
    EXPECT_EQ(choose(fitter, trials), trials.data());
    return trials[0].candidate.indistinguishable_from;
  };
  EXPECT_EQ(rivals(lag, delay), std::vector<std::string>{"process.dead_time"});
  EXPECT_TRUE(rivals(delay, lag).empty());
}

// Play that leaves less than a gain that drifts is open where u turned too seldom.
TEST(Choice, WhatLeavesLessButMovesTooSeldomMayBeItAsWell) {
  const std::vector<double> levels = {50, 58, 50, 58, 50};
  const Recording recording = test::stepped(levels, test::backlash(3));
  const Fitter fitter(recording, Column::y);
  const auto rivals = [&](bool too_few) {
    std::vector<Trial> trials;
    for (const Effect* effect :
         {&effects::process_gain_drift(), &effects::valve_backlash()}) {
      trials.push_back(accepted_trial(*effect, nullptr, fitter.start({effect})));
    }
    trials[1].candidate.status = CandidateStatus::kUndecided;
    trials[1].too_few = too_few;
    EXPECT_EQ(choose(fitter, trials), trials.data());
    return trials[0].candidate.indistinguishable_from;
  };
  EXPECT_EQ(rivals(true), std::vector<std::string>{"valve.backlash"});
  EXPECT_TRUE(rivals(false).empty());
}

// What one may be as well is not turned down in the same answer.
TEST(Choice, WhatIsNamedAsARivalNamesItInTurnAndIsNotRejected) {
  Candidate other;
  other.effect = "valve.stiction";
  other.status = CandidateStatus::kRejected;
  name_back(other, effects::process_second_lag());
  EXPECT_EQ(other.status, CandidateStatus::kUndecided);
  EXPECT_EQ(other.indistinguishable_from, std::vector<std::string>{"process.second_lag"});
  EXPECT_EQ(other.would_split, effects::process_second_lag().description().split);
  other.status = CandidateStatus::kNotExcited;
  name_back(other, effects::sensor_lag());
  EXPECT_EQ(other.status, CandidateStatus::kNotExcited);
}

}  // namespace
}  // namespace workbench
