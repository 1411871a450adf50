// A stem that slides for a while, or play in front of a dead time?
#include <gtest/gtest.h>

#include <cmath>
#include <random>
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
  EXPECT_LE(found[0].fit->parameters(), trials[0].fit->parameters());
  EXPECT_LT(found[0].fit->error, 0.5 * trials[0].fit->error);
}

// A level that follows u through play: 6 u of each move are lost.
Recording level_behind_play() {
  const std::vector<double> levels = {58, 44, 55, 41, 60, 46, 57, 39};
  constexpr std::size_t kHeld = 100;
  Recording recording = test::stepped(levels, test::backlash(6));
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.05);
  double content = 50;
  const auto valve = test::backlash(6);
  for (std::size_t k = 0; k < recording.u.size(); ++k) {
    const double swing = levels[k / kHeld % levels.size()] - 50;
    recording.u[k] = 50 + swing * std::sin(0.06 * static_cast<double>(k));
    recording.y[k] = content + noise(random);
    content += 0.02 * (valve(recording.u[k]) - 50);
  }
  return recording;
}

TEST(PlayInstead, OfAStemInFrontOfALevel) {
  const Recording recording = level_behind_play();
  const Fitter fitter(recording, Column::y);
  const Fit base = fitter.start({});
  const std::vector<Trial> found = play_instead(fitter, base, stuck_in(fitter, base));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(members_of(found[0]),
            (std::vector<const Effect*>{&effects::valve_backlash(),
                                        &effects::process_integrating()}));
  EXPECT_NEAR(found[0].fit->searched_of(effects::valve_backlash())[0], 6, 0.2);
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
