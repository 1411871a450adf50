// What explains far more, but moves too seldom to be told.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/outdone.hpp"

namespace workbench {
namespace {

class Outdone : public testing::Test {
 protected:
  Outdone() {
    add(effects::process_second_lag(), CandidateStatus::kAccepted, 75);
    add(effects::valve_rate_limit(), CandidateStatus::kNotExcited, 97);
    trials[1].too_few = true;
    trials[1].fit->error *= 0.5;
  }
  void add(const Effect& effect, CandidateStatus status, double reduction) {
    Trial trial;
    trial.effect = &effect;
    trial.fit = base;
    trial.candidate.status = status;
    trial.candidate.error_reduction_percent = reduction;
    trials.push_back(std::move(trial));
  }
  CandidateStatus status() {
    leave_outdone_open(trials);
    return trials[0].candidate.status;
  }

  test::SetpointLoop loop;
  const Recording recording = test::simulated(loop);
  const Fitter fitter{recording, Column::y};
  const Fit base = fitter.start({});
  std::vector<Trial> trials;
};

TEST_F(Outdone, ByWhatLeavesFarLess) {
  EXPECT_EQ(status(), CandidateStatus::kUndecided);
  EXPECT_NE(trials[0].candidate.evidence.find("valve.rate_limit"), std::string::npos);
}

TEST_F(Outdone, NotByWhatLeavesALittleLess) {
  trials[1].candidate.error_reduction_percent = 90;
  EXPECT_EQ(status(), CandidateStatus::kAccepted);
}

TEST_F(Outdone, NotByWhatCannotBe) {
  trials[1].edge = true;
  EXPECT_EQ(status(), CandidateStatus::kAccepted);
}

TEST_F(Outdone, NotByWhatWasRejectedForAnotherReason) {
  trials[1].too_few = false;
  EXPECT_EQ(status(), CandidateStatus::kAccepted);
}

TEST_F(Outdone, NotWhereItsOwnTestShowsIt) {
  trials[0].own = true;
  EXPECT_EQ(status(), CandidateStatus::kAccepted);
}

}  // namespace
}  // namespace workbench
