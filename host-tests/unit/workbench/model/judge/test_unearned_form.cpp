// Whether a form of an effect stays in a fit.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/judge/merit.hpp"
#include "workbench/model/judge/unearned_form.hpp"

namespace workbench {
namespace {

enum : std::size_t { kTime, kByFlow, kRatio };

// A dead time as through a pipe whose flow follows u.
Fit by_flow(const Fitter& fitter, const Fit& plain, double ratio) {
  const Effect& delay = effects::process_dead_time();
  Fit fit = plain;
  const auto at = [&](std::size_t which) -> double& {
    for (std::size_t i = 0; i < fit.slots.size(); ++i) {
      if (fit.slots[i].effect == &delay) return fit.p[i + which];
    }
    return fit.p.front();
  };
  at(kByFlow) = 1;
  at(kRatio) = ratio;
  return fitter.refine(fitter.at(fit, fit.p));
}

TEST(UnearnedForm, ADeadTimeThatIsTheSameEverywhereFollowsNoFlow) {
  test::SetpointLoop loop;
  loop.delay = 8;
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Effect& delay = effects::process_dead_time();
  const Fit plain = fitter.extend(fitter.start({}), delay, Effort::kThorough).value();
  const Fit form = by_flow(fitter, plain, 1.3);
  ASSERT_GT(form.searched_of(delay)[kByFlow], 0.5);
  const Fit kept = without_unearned_forms(fitter, form);
  EXPECT_LT(kept.searched_of(delay)[kByFlow], 0.5);
  EXPECT_NEAR(kept.searched_of(delay)[kTime], 8, 0.3);
}

TEST(UnearnedForm, AFlowThatFollowsUStays) {
  Recording recording = test::simulated({});
  // Content of 300 u·s between u and the process.
  std::vector<double> late(recording.size());
  for (std::size_t k = 0; k < recording.size(); ++k) {
    double content = 300;
    std::size_t at = k;
    while (at > 0 && content > recording.u[at]) content -= recording.u[at--];
    late[k] = recording.u[at];
  }
  double y = 50;
  for (std::size_t k = 0; k < recording.size(); ++k) {
    recording.y[k] = y;
    y += (2 * (late[k] - 50) + 50 - y) / 5;
  }
  const Fitter fitter(recording, Column::y);
  const Effect& delay = effects::process_dead_time();
  const Fit plain = fitter.extend(fitter.start({}), delay, Effort::kThorough).value();
  const double start =
      plain.searched_of(delay)[kByFlow] > 0.5 ? plain.searched_of(delay)[kRatio] : 1.5;
  const Fit form = by_flow(fitter, plain, start);
  const Fit kept = without_unearned_forms(fitter, form);
  EXPECT_GT(kept.searched_of(delay)[kByFlow], 0.5);
}

// What is slow may lower the error of a free run; it is in the past of the residual, so
// that it foretells nothing.
TEST(UnearnedForm, WhatIsNotSeenOneSampleAheadIsNoForm) {
  test::SetpointLoop loop;
  loop.delay = 8;
  loop.load = [](std::size_t k) { return 10 * std::sin(0.02 * static_cast<double>(k)); };
  const Recording recording = test::simulated(loop);
  const Fitter fitter(recording, Column::y);
  const Effect& delay = effects::process_dead_time();
  const Fit plain = fitter.extend(fitter.start({}), delay, Effort::kThorough).value();
  Fit form = by_flow(fitter, plain, 1.3);
  form.residual = plain.residual;
  for (double& left : form.residual) left *= 0.5;
  form.error = 0.25 * plain.error;
  ASSERT_TRUE(lowers_error(fitter, plain, form));
  const Fit kept = without_unearned_forms(fitter, form);
  EXPECT_LT(kept.searched_of(delay)[kByFlow], 0.5);
}

}  // namespace
}  // namespace workbench
