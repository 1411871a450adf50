// Second thoughts about effects that were added one at a time.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/revision.hpp"

namespace workbench {
namespace {

using test::SetpointLoop;
using test::simulated;

SetpointLoop late_and_shaken() {
  SetpointLoop loop;
  loop.delay = 6;
  loop.load = [](std::size_t k) {
    return 2 * std::sin(2 * std::numbers::pi * static_cast<double>(k) / 37);
  };
  return loop;
}

TEST(Revision, LeavesASingleEffectAndARightPairAlone) {
  const Recording recording = simulated(late_and_shaken());
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  const Fit one = fitter.start({&effects::process_dead_time()});
  EXPECT_FALSE(revised(fitter, one, {}, standard_catalogue(), identified));
  const Fit both =
      fitter.start({&effects::process_dead_time(), &effects::disturbance_sinusoid()});
  EXPECT_FALSE(revised(fitter, both, {}, standard_catalogue(), identified));
}

TEST(Revision, TakesOutWhatNobodyMissesUnlessItWasGiven) {
  SetpointLoop loop;
  loop.delay = 6;
  const Recording recording = simulated(loop);
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  const Effect& needless = effects::disturbance_ramp();
  const Fit fit = fitter.start({&needless, &effects::process_dead_time()});
  const auto revision = revised(fitter, fit, {}, standard_catalogue(), identified);
  ASSERT_TRUE(revision);
  EXPECT_EQ(revision->removed, std::vector<const Effect*>{&needless});
  EXPECT_TRUE(revision->added.empty());
  EXPECT_EQ(revision->fit.effects.size(), 1u);
  EXPECT_FALSE(revised(fitter, fit, {&needless}, standard_catalogue(), identified));
}

TEST(Revision, PutsTheRightEffectInThePlaceOfAWrongOne) {
  const Recording recording = simulated(late_and_shaken());
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  const Effect& wrong = effects::process_second_lag();
  const Fit fit = fitter.start({&wrong, &effects::disturbance_sinusoid()});
  const auto revision = revised(fitter, fit, {}, standard_catalogue(), identified);
  ASSERT_TRUE(revision);
  EXPECT_EQ(revision->removed, std::vector<const Effect*>{&wrong});
  ASSERT_EQ(revision->added.size(), 1u);
  EXPECT_EQ(revision->added[0], &effects::process_dead_time());
  EXPECT_LT(fitter.rmse(revision->fit), fitter.rmse(fit));
  ASSERT_TRUE(revision->between);
  EXPECT_EQ(revision->between->effects.size(), 1u);
}

TEST(Revision, PutsOneEffectInThePlaceOfTwo) {
  const Recording recording = simulated(late_and_shaken());
  const Fitter fitter(recording, Column::y);
  Identified identified({recording});
  const Effect& shaken = effects::disturbance_sinusoid();
  const Effect& one = effects::process_second_lag();
  const Effect& other = effects::sensor_lag();
  const Fit fit = fitter.start({&one, &shaken, &other});
  const auto revision = revised(fitter, fit, {}, standard_catalogue(), identified);
  ASSERT_TRUE(revision);
  EXPECT_EQ(revision->removed.size(), 2u);
  ASSERT_EQ(revision->added.size(), 1u);
  EXPECT_EQ(revision->added[0], &effects::process_dead_time());
  EXPECT_EQ(revision->fit.effects,
            (std::vector<const Effect*>{&shaken, &effects::process_dead_time()}));
  EXPECT_LT(fitter.rmse(revision->fit), 1.02 * fitter.rmse(fit));
}

}  // namespace
}  // namespace workbench
