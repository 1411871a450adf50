// Three effects of which no two explain a loop.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/workbench/setpoint_loop.hpp"
#include "workbench/effects/effects.hpp"
#include "workbench/model/search/triples.hpp"

namespace workbench {
namespace {

using test::SetpointLoop;
using test::simulated;

// A stem that stays until u is 3 ahead and slips to 1 behind it, dead time, and a load
// that comes and stays.
Recording stuck_delayed_and_loaded() {
  SetpointLoop loop;
  loop.samples = 900;
  loop.noise_std = 0.1;
  loop.delay = 6;
  loop.valve = test::slipping();
  loop.load = [](std::size_t k) {
    return k < 300 ? 0.0 : 6 * (1 - std::exp((300 - double(k)) / 20));
  };
  return simulated(loop);
}

TEST(Triples, GiveAClosePairTheThirdThatItLacks) {
  const Recording recording = stuck_delayed_and_loaded();
  const Fitter fitter(recording, Column::y);
  const Fit base = fitter.start({});
  Trial pair;
  pair.effect = &effects::valve_stiction();
  pair.partner = &effects::disturbance_step();
  pair.fit = fitter.start({pair.effect, pair.partner});
  std::vector<Trial> trials;
  for (const Effect* third :
       {&effects::process_dead_time(), &effects::process_gain_drift()}) {
    trials.emplace_back();
    trials.back().effect = third;
    trials.back().fit = fitter.extend(base, *third, Effort::kScreen);
  }
  const std::vector<Trial> found = triples_of(fitter, base, trials, {pair});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(members_of(found[0]),
            (std::vector<const Effect*>{&effects::valve_stiction(),
                                        &effects::process_dead_time(),
                                        &effects::disturbance_step()}));
  EXPECT_LT(found[0].fit->error, 0.5 * pair.fit->error);
  EXPECT_LT(found[0].p_ahead, 1e-6);
}

TEST(Triples, AreNotAskedForWhereNoPairIsClose) {
  const Recording recording = simulated({});
  const Fitter fitter(recording, Column::y);
  const Fit base = fitter.start({});
  EXPECT_TRUE(triples_of(fitter, base, {}, {}).empty());
  Trial pair;
  pair.effect = &effects::valve_backlash();
  pair.partner = &effects::process_dead_time();
  pair.fit = base;
  EXPECT_TRUE(triples_of(fitter, base, {}, {pair}).empty());
}

}  // namespace
}  // namespace workbench
