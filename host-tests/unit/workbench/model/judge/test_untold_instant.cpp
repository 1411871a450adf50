// Whether a recording tells when a sudden change came.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/judge/untold_instant.hpp"

namespace workbench {
namespace {

double untold_s(const std::function<double(std::size_t)>& load) {
  test::SetpointLoop loop;
  loop.load = load;
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Effect& step = effects::disturbance_step();
  const Fit fit = fitter.start({&step});
  return untold_instant_s(fitter, fit, step);
}

TEST(UntoldInstant, IsNoneOfAStep) {
  EXPECT_EQ(untold_s([](std::size_t k) { return k < 500 ? 0.0 : 6.0; }), 0);
}

TEST(UntoldInstant, IsAsWideAsTheIntervalOfNoStepAtAll) {
  EXPECT_GT(untold_s([](std::size_t) { return 0.0; }), 60);
}

TEST(UntoldInstant, IsNoneOfWhatHasNoInstant) {
  const Recording recording = test::simulated({});
  const Fitter fitter(recording, Column::y);
  const Effect& dead_time = effects::process_dead_time();
  const Fit fit = fitter.start({&dead_time});
  EXPECT_EQ(untold_instant_s(fitter, fit, dead_time), 0);
}

}  // namespace
}  // namespace workbench
