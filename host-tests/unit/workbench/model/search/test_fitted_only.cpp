// What only the fitted samples show.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/fitted_only.hpp"

namespace workbench {
namespace {

class FittedOnly : public testing::Test {
 protected:
  FittedOnly() {
    for (const double left : {0.4, 0.2}) {
      Trial trial;
      trial.effect = &effects::process_dead_time();
      trial.fit = base;
      trial.fit->error *= left;
      for (std::size_t k = 0; k < trial.fit->residual.size(); ++k) {
        if (fitter.blocks().estimation()[k]) trial.fit->residual[k] *= left;
      }
      trials.push_back(trial);
    }
  }

  test::SetpointLoop loop;
  const Recording recording = test::simulated(loop);
  const Fitter fitter{recording, Column::y};
  const Fit base = fitter.start({});
  std::vector<Trial> trials;
};

TEST_F(FittedOnly, TheOneThatExplainsMostIsLeftOpen) {
  leave_fitted_only_open(fitter, base, trials);
  EXPECT_EQ(trials[0].candidate.status, CandidateStatus::kRejected);
  EXPECT_EQ(trials[1].candidate.status, CandidateStatus::kUndecided);
  EXPECT_NE(trials[1].candidate.evidence.find("80 %"), std::string::npos);
}

TEST_F(FittedOnly, NotWhereAnotherEffectIsAccepted) {
  trials[0].candidate.status = CandidateStatus::kAccepted;
  leave_fitted_only_open(fitter, base, trials);
  EXPECT_EQ(trials[1].candidate.status, CandidateStatus::kRejected);
}

TEST_F(FittedOnly, NotWhereTheOthersSpeakAgainstIt) {
  for (std::size_t k = 0; k < recording.size(); ++k) {
    if (!fitter.blocks().estimation()[k]) trials[1].fit->residual[k] *= 1.2;
  }
  leave_fitted_only_open(fitter, base, trials);
  EXPECT_EQ(trials[1].candidate.status, CandidateStatus::kRejected);
}

TEST_F(FittedOnly, NotWhatTheOthersShowToo) {
  trials[1].candidate.error_reduction_percent = 60;
  leave_fitted_only_open(fitter, base, trials);
  EXPECT_EQ(trials[1].candidate.status, CandidateStatus::kRejected);
}

TEST_F(FittedOnly, NotWhereLessThanHalfOfTheErrorGoes) {
  trials.resize(1);
  trials[0].fit->error = 0.6 * base.error;
  leave_fitted_only_open(fitter, base, trials);
  EXPECT_EQ(trials[0].candidate.status, CandidateStatus::kRejected);
}

}  // namespace
}  // namespace workbench
