// A stem that the identification would have seen, and did not.
#include <gtest/gtest.h>

#include <cmath>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/verdict_against.hpp"

namespace workbench {
namespace {

using test::SetpointLoop;
using test::simulated;

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

TEST(VerdictAgainst, RefutesABandThatWouldHaveShown) {
  SetpointLoop loop;
  loop.load = [](std::size_t k) { return 3 * std::sin(double(k) / 4); };
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  const VerdictAgainst verdict(fitter, identified);
  const auto excluded = verdict.excluded_from();
  ASSERT_TRUE(excluded);
  Trial wide = trial_of_play(fitter, 1.2 * *excluded);
  verdict.refute(wide);
  EXPECT_EQ(wide.candidate.status, CandidateStatus::kUndecided);
  EXPECT_NE(wide.candidate.evidence.find("would have shown"), std::string::npos);
  Trial narrow = trial_of_play(fitter, 0.8 * *excluded);
  verdict.refute(narrow);
  EXPECT_EQ(narrow.candidate.status, CandidateStatus::kAccepted);
}

TEST(VerdictAgainst, LeavesAloneWhatIsNoStem) {
  const Recording recording = simulated({});
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  const VerdictAgainst verdict(fitter, identified);
  Trial trial = trial_of_play(fitter, 40);
  trial.effect = &effects::process_dead_time();
  verdict.refute(trial);
  EXPECT_EQ(trial.candidate.status, CandidateStatus::kAccepted);
}

TEST(VerdictAgainst, KnowsNoBandWhereTheValveIsAtFault) {
  SetpointLoop loop;
  loop.samples = 2400;
  loop.valve = test::backlash(6);
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  EXPECT_FALSE(VerdictAgainst(fitter, identified).excluded_from());
}

}  // namespace
}  // namespace workbench
