#include <gtest/gtest.h>

#include <cmath>

#include "workbench/analysis/analysis.hpp"
#include "workbench/recording/stopped.hpp"
#include "workbench/screen/screen_loop.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace workbench {
namespace {

Recording simulated(const char* scenario, std::uint64_t seed, const char* start = "") {
  const auto loop = simulate(scenario, seed);
  Recording out;
  out.period_s = loop->period_s;
  out.t = loop->t;
  out.u = loop->u;
  out.y = loop->y;
  out.sp = loop->sp;
  out.start = start;
  return out;
}

TEST(ScreenLoop, SaysWhatIdentifySays) {
  for (const char* scenario : {"stiction", "setpoint", "tight-tuning", "random-load"}) {
    const Recording recording = simulated(scenario, 3);
    const ScreenedLoop loop = screen_loop({recording}, {""}, {});
    const Analysis wanted(recording);
    EXPECT_EQ(loop.verdict, ident::name(wanted.result().verdict)) << scenario;
    EXPECT_EQ(loop.stick_band.ascending.value,
              wanted.result().stick_band.ascending.value);
    EXPECT_EQ(loop.detectable_band, wanted.result().detectable_band);
    if (wanted.pooled().predicted > 0) {
      EXPECT_EQ(loop.nats, wanted.pooled().nats);
    }
  }
}

// y swings about a u that rests, or that climbs in even steps.
TEST(ScreenLoop, OscillatesOnlyWhereUTurnsBack) {
  for (const double rise : {0.0, 1.0}) {
    Recording recording;
    recording.period_s = 1;
    for (int t = 0; t < 1000; ++t) {
      recording.t.push_back(t);
      recording.u.push_back(40 + rise * (t / 100));
      recording.y.push_back(50 + std::sin(0.0628 * t));
    }
    const ScreenedLoop loop = screen_loop({recording}, {""}, {});
    EXPECT_EQ(loop.period_s, 0) << rise;
    EXPECT_EQ(loop.oscillating_share, 0) << rise;
  }
}

TEST(ScreenLoop, CountsSamplesThatAreGivenTwiceOnce) {
  const Recording recording = simulated("stiction", 3);
  const ScreenedLoop loop =
      screen_loop({recording, recording, recording}, {"", "", ""}, {});
  EXPECT_EQ(loop.samples, static_cast<double>(recording.size()));
}

TEST(ScreenLoop, MonthsMakeATrend) {
  const ScreenedLoop loop = screen_loop({simulated("stiction", 3, "2026-03-10T00:00:00"),
                                         simulated("stiction", 4, "2026-05-10T00:00:00")},
                                        {"", ""}, {});
  ASSERT_EQ(loop.trend.size(), 2U);
  EXPECT_EQ(loop.trend[0].name, "2026-03");
  EXPECT_EQ(loop.trend[1].name, "2026-05");
  EXPECT_EQ(loop.trend[1].verdict, "stiction");
  EXPECT_GT(loop.trend[0].stick_band, 0);
  EXPECT_FALSE(loop.picture_u.empty());
  EXPECT_GT(loop.oscillating_share, 0.8);
}

TEST(ScreenLoop, StopsWhenToldTo) {
  EXPECT_THROW((void)screen_loop({simulated("stiction", 3)}, {""}, [] { return true; }),
               Stopped);
}

TEST(Rate, TheVerdictCountsFirstThenEvidence) {
  ScreenedLoop sticks;
  sticks.verdict = "stiction";
  sticks.nats = 10;
  sticks.stem_nats = NAN;
  ScreenedLoop undecided = sticks;
  undecided.verdict = "undecided";
  undecided.nats = 200;
  ScreenedLoop fine = sticks;
  fine.verdict = "no_stiction";
  ScreenedLoop broken;
  broken.error = "none";
  for (ScreenedLoop* loop : {&sticks, &undecided, &fine, &broken}) rate(*loop);
  EXPECT_GT(sticks.suspicion, undecided.suspicion);
  EXPECT_GT(undecided.suspicion, fine.suspicion);
  EXPECT_EQ(broken.cost, 0);
  ScreenedLoop always = sticks;
  always.oscillating_share = 1;
  rate(always);
  EXPECT_GT(always.cost, sticks.cost);
}

}  // namespace
}  // namespace workbench
