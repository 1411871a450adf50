// A stem that slides for a while, or play in front of a dead time?
#include <gtest/gtest.h>

#include <vector>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/play_instead.hpp"

namespace workbench {
namespace {

using test::SetpointLoop;
using test::simulated;

// Stiction, accepted, as it is found in the recording.
std::vector<Trial> stuck_in(const Fitter& fitter, const Fit& base) {
  std::vector<Trial> trials(1);
  trials[0].effect = &effects::valve_stiction();
  trials[0].fit = fitter.extend(base, effects::valve_stiction(), Effort::kThorough);
  trials[0].candidate.status = CandidateStatus::kAccepted;
  return trials;
}

TEST(PlayInstead, OfAStemThatSlidesInPlaceOfADeadTime) {
  SetpointLoop loop;
  loop.samples = 2000;
  loop.noise_std = 0.05;
  loop.delay = 2;
  loop.valve = test::backlash(6);
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit base = fitter.start({});
  const std::vector<Trial> trials = stuck_in(fitter, base);
  const std::vector<Trial> found = play_instead(fitter, base, trials);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(members_of(found[0]),
            (std::vector<const Effect*>{&effects::valve_backlash(),
                                        &effects::process_dead_time()}));
  EXPECT_NEAR(found[0].fit->searched_of(effects::valve_backlash())[0], 6, 0.2);
  EXPECT_LT(found[0].fit->parameters(), trials[0].fit->parameters());
}

TEST(PlayInstead, NotOfAStemThatSlips) {
  SetpointLoop loop;
  loop.samples = 2000;
  loop.noise_std = 0.05;
  loop.delay = 2;
  loop.valve = test::slipping();
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit base = fitter.start({});
  EXPECT_TRUE(play_instead(fitter, base, stuck_in(fitter, base)).empty());
  EXPECT_TRUE(play_instead(fitter, base, {}).empty());
}

}  // namespace
}  // namespace workbench
