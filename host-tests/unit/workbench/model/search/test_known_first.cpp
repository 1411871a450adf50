// Which known cause is told in place of a load that nobody measured.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/catalogue.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/known_first.hpp"

namespace workbench {
namespace {

Trial accepted_trial(const Fitter& fitter, const Effect& effect) {
  Trial trial;
  trial.effect = &effect;
  trial.fit = fitter.extend(fitter.start({}), effect, Effort::kThorough).value();
  trial.candidate.effect = effect.code();
  trial.candidate.status = CandidateStatus::kAccepted;
  trial.score = trial.fit->error;
  return trial;
}

// A load begun and ended at will leaves less than the valve that the identification
// found.
TEST(KnownFirst, TheValveThatIsIdentifiedBeforeALoadStepThatNobodyMeasured) {
  test::SetpointLoop loop;
  loop.valve = test::backlash(4);
  loop.load = [](std::size_t k) { return k >= 600 ? 30.0 : 0.0; };
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  std::vector<Trial> trials;
  trials.push_back(accepted_trial(fitter, effects::valve_backlash()));
  trials.push_back(accepted_trial(fitter, effects::disturbance_step()));
  ASSERT_LT(trials[1].score, trials[0].score);
  EXPECT_EQ(known_first(fitter, trials, &trials[1]), &trials[1]);
  trials[0].identified = true;
  EXPECT_EQ(known_first(fitter, trials, &trials[1]), &trials[0]);
  EXPECT_LT(trials[0].score, trials[1].score);
}

// The output steps at 650 s; the recorded feed did at `feed_at`.
const Effect* told_beside(std::size_t feed_at) {
  test::SetpointLoop loop;
  loop.noise_std = 0.5;
  loop.load = [](std::size_t k) { return k >= 650 ? 10.0 : 0.0; };
  Recording recording = test::simulated(loop);
  std::vector<double> feed(recording.size());
  for (std::size_t k = feed_at; k < feed.size(); ++k) feed[k] = 3;
  recording.loads = {{"feed", "t/h", feed}};
  const Fitter fitter(recording, Column::y);
  std::vector<Trial> trials;
  trials.push_back(accepted_trial(fitter, effects::disturbance_measured("feed")));
  trials.push_back(accepted_trial(fitter, effects::disturbance_step()));
  EXPECT_LT(trials[1].score, trials[0].score);
  return known_first(fitter, trials, &trials[1])->effect;
}

TEST(KnownFirst, ARecordedLoadThatLeavesHardlyMoreBeforeOneThatNobodyMeasured) {
  EXPECT_EQ(told_beside(648), &effects::disturbance_measured("feed"));
  EXPECT_EQ(told_beside(300), &effects::disturbance_step()) << "it leaves far more";
}

TEST(KnownFirst, LoadsThatNobodyMeasuredHaveAnUnknownCause) {
  const Effect& feed = effects::disturbance_measured("feed");
  EXPECT_TRUE(
      has_unknown_cause({&effects::process_second_lag(), &effects::disturbance_ramp()}));
  EXPECT_FALSE(has_unknown_cause({&effects::disturbance_step(), &feed}));
  EXPECT_FALSE(has_unknown_cause({&effects::valve_backlash()}));
  EXPECT_TRUE(has_unknown_cause({&effects::disturbance_sinusoid()}));
  EXPECT_FALSE(is_slow_load(effects::disturbance_sinusoid()));
}

}  // namespace
}  // namespace workbench
