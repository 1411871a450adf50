// Two fits of one recording, held against each other.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/judge/merit.hpp"

namespace workbench {
namespace {

class Merit : public testing::Test {
 protected:
  static Recording late() {
    test::SetpointLoop loop;
    loop.delay = 6;
    return test::simulated(loop);
  }
  Recording recording_ = late();
  Fitter fitter_{recording_, Column::y};
  Fit plain_ = fitter_.start({});
  Fit right_ = fitter_.start({&effects::process_dead_time()});
};

TEST_F(Merit, TheRightEffectLowersTheError) {
  EXPECT_TRUE(lowers_error(fitter_, plain_, right_));
  EXPECT_LT(total_error(right_), total_error(plain_));
  EXPECT_LT(score_of(right_, {}), score_of(plain_, {}));
}

TEST_F(Merit, OneSampleAheadTheErrorIsThatOfTheNoise) {
  EXPECT_NEAR(rmse_ahead(fitter_, right_), fitter_.rmse_on(right_, false),
              0.1 * fitter_.rmse_on(right_, false));
  EXPECT_LT(rmse_ahead(fitter_, plain_), fitter_.rmse_on(plain_, false));
}

TEST_F(Merit, AnOutputFollowsUByWhatItsLoadsLeave) {
  EXPECT_TRUE(follows_u(fitter_, right_));
  test::SetpointLoop loop;
  loop.setpoint_moves = false;
  loop.load = [](std::size_t k) { return k < 600 ? 0.0 : 30.0; };
  Recording still = test::simulated(loop);
  for (std::size_t k = 0; k < still.size(); ++k) {
    still.u[k] = 50 + 0.01 * static_cast<double>(k % 7);
    still.y[k] = 50 + loop.load(k) + 0.1 * static_cast<double>(k % 5);
  }
  const Fitter fitter(still, Column::y);
  EXPECT_FALSE(follows_u(fitter, fitter.start({&effects::disturbance_step()})));
}

TEST_F(Merit, WhatHelpsOnlyWhereNothingWasFittedDoesNotEarnItsParameters) {
  EXPECT_TRUE(earns_parameters(fitter_, plain_, right_));
  Fit lucky = right_;
  lucky.columns.push_back({.name = "luck", .unit = ""});
  for (const Block& block : fitter_.blocks().blocks()) {
    for (std::size_t k = block.first; k < block.last; ++k) {
      if (!block.estimation) lucky.residual[k] *= 0.9;
    }
  }
  EXPECT_LT(fitter_.rmse_on(lucky, false), fitter_.rmse_on(right_, false));
  EXPECT_FALSE(earns_parameters(fitter_, right_, lucky));
  EXPECT_FALSE(lowers_error(fitter_, right_, lucky));
}

TEST_F(Merit, WhatIsPushedToItsEdgeOnlyStandsForWhatIsNotThere) {
  const auto both = fitter_.extend(right_, effects::sensor_lag(), Effort::kScreen);
  ASSERT_TRUE(both);
  Fit pushed = *both;
  for (std::size_t i = 0; i < pushed.p.size(); ++i) {
    if (pushed.slots[i].effect != &effects::process_dead_time()) continue;
    pushed.p[i] = pushed.slots[i].parameter.high;
  }
  EXPECT_TRUE(stands_in(fitter_, pushed, right_));
  EXPECT_FALSE(stands_in(fitter_, *both, right_)) << "inside its range";
  EXPECT_FALSE(stands_in(fitter_, right_, pushed));
  for (double& e : pushed.residual) e *= 0.5;
  EXPECT_FALSE(stands_in(fitter_, pushed, right_)) << "better";
}

TEST_F(Merit, UIsSeenWhereItMovesTheOutput) {
  EXPECT_TRUE(u_is_seen(fitter_, right_));
  Fit blind = right_;
  blind.residual.assign(fitter_.y().begin(), fitter_.y().end());
  EXPECT_FALSE(u_is_seen(fitter_, blind));
}

TEST_F(Merit, NothingLowersItsOwnError) {
  EXPECT_FALSE(lowers_error(fitter_, right_, right_));
  EXPECT_FALSE(lowers_error(fitter_, right_, plain_));
}

TEST_F(Merit, LagsBeforeAndBehindTheProcessAreAsGood) {
  const Fit second = fitter_.start({&effects::process_second_lag()});
  const Fit sensor = fitter_.start({&effects::sensor_lag()});
  EXPECT_TRUE(as_good(fitter_, second, sensor));
  EXPECT_TRUE(as_good(fitter_, sensor, second));
  EXPECT_FALSE(as_good(fitter_, second, right_));
  EXPECT_TRUE(as_good(fitter_, right_, right_));
}

TEST_F(Merit, ASuperfluousEffectIsNotMissed) {
  const auto more =
      fitter_.extend(right_, effects::disturbance_ramp(), Effort::kThorough);
  ASSERT_TRUE(more);
  EXPECT_FALSE(lowers_error(fitter_, right_, *more));
  EXPECT_LT(score_of(right_, {}), score_of(*more, {}));
}

TEST_F(Merit, WhatHasShownBeyondDoubtWasExcitedHoweverFewItsEvents) {
  Excitation few;
  few.events = few.least - 1;
  const Effect& play = effects::valve_backlash();
  EXPECT_FALSE(is_excited(play, few, 1e-5));
  EXPECT_TRUE(is_excited(play, few, 1e-7));
  EXPECT_FALSE(is_excited(effects::disturbance_step(), few, 1e-7)) << "comes once";
  few.acted = false;
  EXPECT_FALSE(is_excited(play, few, 1e-7)) << "u never turned";
  Excitation enough;
  enough.events = enough.least;
  EXPECT_TRUE(is_excited(effects::disturbance_step(), enough, 1));
}

TEST_F(Merit, ADeadTimeThatShowsIsPossible) {
  EXPECT_TRUE(is_possible(fitter_, right_, effects::process_dead_time()));
}

TEST(ShowsItself, AFrozenReadingDoesWhateverTheErrorSaysAndADeadTimeDoesNot) {
  test::SetpointLoop loop;
  loop.sensor = [k = 0, reading = 0.0](double y) mutable {
    if (++k < 300 || k >= 360) reading = y;
    return reading;
  };
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Fit plain = fitter.start({});
  const Effect& frozen = effects::sensor_sticking();
  const auto fit = fitter.extend(plain, frozen, Effort::kThorough);
  ASSERT_TRUE(fit);
  EXPECT_TRUE(shows_itself(fitter, *fit, plain, frozen));
  const Effect& late = effects::process_dead_time();
  const auto other = fitter.extend(plain, late, Effort::kThorough);
  ASSERT_TRUE(other);
  EXPECT_FALSE(shows_itself(fitter, *other, plain, late));
}

}  // namespace
}  // namespace workbench
