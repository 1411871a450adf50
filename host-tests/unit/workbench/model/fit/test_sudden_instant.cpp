// Load steps whose instant no fitted sample tells.
#include <gtest/gtest.h>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/fit/fit.hpp"
#include "workbench/model/fit/sudden_instant.hpp"
#include "workbench/model/judge/intervals.hpp"

namespace workbench {
namespace {

const Effect& load_step() {
  return effects::disturbance_step();
}

Recording stepping_at(std::size_t sample) {
  test::SetpointLoop loop;
  loop.load = [sample](std::size_t k) { return k < sample ? 0.0 : 5.0; };
  return simulated(loop);
}

// Sample of a block of either kind that is `share` behind its beginning, in the middle of
// the recording.
std::size_t sample_in(const Blocks& blocks, bool estimation, double share) {
  const auto& all = blocks.blocks();
  const std::size_t middle = all.size() / 2;
  const Block& block = all[all[middle].estimation == estimation ? middle : middle + 1];
  return block.first +
         static_cast<std::size_t>(share * static_cast<double>(block.last - block.first));
}

TEST(SuddenInstant, IsFoundAllOverAStretchThatIsNotFitted) {
  int seen_by_none = 0;
  for (const double share : {0.1, 0.5, 0.9}) {
    std::size_t at = 0;
    {
      const Recording before = stepping_at(0);
      at = sample_in(Fitter(before, Column::y).blocks(), false, share);
    }
    const Recording recording = stepping_at(at);
    const Fitter fitter(recording, Column::y);
    const auto fit = fitter.extend(fitter.start({}), load_step(), Effort::kThorough);
    ASSERT_TRUE(fit);
    const double truth = (static_cast<double>(at) - 0.5) * recording.period_s;
    EXPECT_NEAR(fit->searched_of(load_step())[0], truth, 2 * recording.period_s);
    const FitIntervals intervals = intervals_of(fitter, *fit);
    for (std::size_t i = 0; i < fit->slots.size(); ++i) {
      if (!fit->slots[i].parameter.sudden) continue;
      if (!FreeRun::is_searched(fit->slots, fit->p, i)) continue;
      EXPECT_LE(intervals.searched[i].low, truth);
      EXPECT_GE(intervals.searched[i].high, truth);
      EXPECT_LT(intervals.searched[i].high - intervals.searched[i].low, 20);
    }
    const bool unseen = fitter.blocks().estimation()[at] == 0;
    seen_by_none += unseen;
    EXPECT_EQ(sudden_instants(fit->slots, fit->p, fitter.situation(*fit)).size(),
              unseen ? 1U : 0U);
    const auto judging = [&](const std::vector<const Effect*>& among) {
      return fitter.judging(*fit, among).estimation_samples();
    };
    EXPECT_EQ(judging({}), fitter.blocks().estimation_samples());
    if (unseen) {
      EXPECT_GT(judging({&load_step()}), fitter.blocks().estimation_samples());
    }
  }
  EXPECT_GE(seen_by_none, 2);
}

TEST(SuddenInstant, IsLeftToTheFitWhereFittedSamplesTellIt) {
  const Recording recording = stepping_at(700);
  const Fitter fitter(recording, Column::y);
  Situation here = fitter.situation(fitter.start({}));
  const std::vector<unsigned char> all(recording.size(), 1);
  here.estimation = all;
  FreeRun run(here, fitter.blocks(), {&load_step()});
  std::vector<double> p;
  for (const FreeRun::Slot& slot : run.slots()) p.push_back(slot.parameter.low);
  EXPECT_TRUE(sudden_instants(run.slots(), p, here).empty());
}

TEST(SuddenInstant, StaysInAFittedSampleBesideAStretch) {
  std::size_t begin = 0;
  {
    const Recording before = stepping_at(0);
    begin = sample_in(Fitter(before, Column::y).blocks(), false, 0);
  }
  for (const std::size_t at : {begin - 2, begin - 1, begin}) {
    const Recording recording = stepping_at(at);
    const Fitter fitter(recording, Column::y);
    const auto fit = fitter.extend(fitter.start({}), load_step(), Effort::kThorough);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->searched_of(load_step())[0] / recording.period_s,
                static_cast<double>(at) - 0.5, 0.51);
  }
}

}  // namespace
}  // namespace workbench
