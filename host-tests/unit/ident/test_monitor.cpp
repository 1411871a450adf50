#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "ident/monitor.hpp"
#include "support/ident/monitored_plant.hpp"

namespace ident {
namespace {

using Small = test::SmallMonitor;
using Plant = test::MonitoredPlant;
using test::Events;
using test::kSecond;

struct Pair {
  float u;
  float y;
};
Pair constant(int) {
  return {50, 20};
}
Pair limit_cycle_wave(int k) {
  const float phase = 0.3f * static_cast<float>(k);
  return {50 + 5 * std::sin(phase), 20 + std::cos(phase)};
}
Pair frozen_y(int k) {
  return {limit_cycle_wave(k).u, 20};
}

TEST(Monitor, GoesOnAfterARestart) {
  Plant plant;
  while (plant.t_us < 1500 * kSecond && !plant.report().stiction_raised) {
    plant.run(1);
  }
  const MonitorReport<float> before = plant.monitor->report();
  ASSERT_TRUE(before.stiction_raised);
  const MonitorMemory memory = plant.monitor->memory();

  Small at_once({});
  at_once.restore(memory, 0);
  EXPECT_TRUE(at_once.report().stiction_raised);
  EXPECT_TRUE(at_once.report().confirmed);
  EXPECT_FALSE(at_once.report().evaluated) << "the window itself is gone";
  EXPECT_EQ(at_once.memory().pool.finding(100.0F).nats, memory.pool.finding(100.0F).nats);

  Small later({});
  later.restore(memory, 6.58F);  // 0.9 to this power is a half
  EXPECT_NEAR(later.memory().pool.windows(), memory.pool.windows() / 2, 0.01);
  EXPECT_TRUE(later.report().stiction_raised) << "until windows say otherwise";

  MonitorSettings<float> settings;
  settings.memory_pct = 0;
  Small forgetful(settings);
  forgetful.restore(memory, 0.1F);
  EXPECT_EQ(forgetful.memory().pool.windows(), 0);
}

TEST(Monitor, TellsWhatTheWindowsBeforeSayTogether) {
  constexpr std::size_t kRung = 30;
  Ladder<float> ladder{};
  ladder[kRung] = 40;
  MonitorMemory memory;
  memory.pool.add(ladder, 500);

  Small later({});
  later.restore(memory, 6.58F);  // 0.9 to this power is a half
  EXPECT_NEAR(later.memory().pool.windows(), 0.5, 0.01);

  Plant plant;
  plant.monitor->restore(memory, 0);
  plant.feed(100, constant);
  plant.monitor->evaluate_now();
  ASSERT_EQ(plant.report().reason, Reason::kConstant);
  EXPECT_GT(plant.report().pooled.nats, 25);
  EXPECT_FLOAT_EQ(plant.report().pooled.band, rung_band<float>(kRung, 100));
}

TEST(Monitor, LooksAgainOnceHalfAsManySamplesAreNew) {
  Plant plant;
  int before = 0;
  for (int window = 0; window < 4; ++window) {
    while (!plant.monitor->due()) plant.feed(1, limit_cycle_wave);
    if (before > 0) {
      EXPECT_EQ(plant.count - before, std::max(before / 2, 60));
    }
    before = plant.count;
    while (plant.monitor->step(1000)) {
    }
  }
  EXPECT_GT(before / 2, 60);
}

TEST(Monitor, GoesOnWithTheSamplesOfBefore) {
  const auto fill = [](Small& monitor) {
    for (int k = 0; k < 600; ++k) {
      const float swing = k / 20 % 2 == 0 ? 5.0F : -5.0F;
      monitor.push({k * kSecond, 50 + swing, 50 - swing});
    }
  };
  Small known({});
  fill(known);
  ASSERT_TRUE(known.due());
  known.resume(40);
  EXPECT_EQ(known.unjudged(), 40U);
  EXPECT_FALSE(known.due()) << "the others were judged before";
  EXPECT_FALSE(known.poll()) << "what began then was told then";
  EXPECT_EQ(known.report().counters.skipped_windows, 0U);
  EXPECT_EQ(known.window().size(), Small::kCapacity);

  Small unknown({});
  fill(unknown);
  unknown.resume(Small::kCapacity);
  EXPECT_EQ(unknown.unjudged(), Small::kCapacity);
  EXPECT_TRUE(unknown.due());
}

TEST(Monitor, TheSameSamplesGiveTheSameAnswerWhateverTheBudgets) {
  Plant first({}, {1000});
  Plant second({}, {7, 1, 30, -4});
  for (Plant* plant : {&first, &second}) {
    plant->run(650);
  }
  EXPECT_GE(first.report().counters.evaluations, 2U);
  EXPECT_EQ(first.report().counters.evaluations, second.report().counters.evaluations);
  ASSERT_EQ(first.events.size(), second.events.size());
  for (std::size_t k = 0; k < first.events.size(); ++k) {
    EXPECT_EQ(first.events[k].t_us, second.events[k].t_us);
    EXPECT_EQ(first.events[k].kind, second.events[k].kind);
    EXPECT_EQ(first.events[k].verdict, second.events[k].verdict);
    EXPECT_EQ(first.events[k].stick_band.ascending.value,
              second.events[k].stick_band.ascending.value);
    EXPECT_EQ(first.events[k].stick_band.descending.high,
              second.events[k].stick_band.descending.high);
  }
  EXPECT_EQ(first.report().fit_percent, second.report().fit_percent);
  EXPECT_EQ(first.report().fit_valve_percent, second.report().fit_valve_percent);
  EXPECT_EQ(first.report().window_end_us, second.report().window_end_us);
}

TEST(Monitor, TheNextSamplesDoNotDisturbAnEvaluation) {
  Plant waits({}, {1000});
  Plant overlaps({}, {1000});
  int count = 0;
  while (!overlaps.monitor->busy()) {
    overlaps.t_us += kSecond;
    overlaps.monitor->push(overlaps.loop.next(overlaps.t_us));
    ++count;
  }
  // One slice for each of the next samples: they are in the window, not in the copy.
  int more = 0;
  while (overlaps.monitor->step(300)) {
    overlaps.t_us += kSecond;
    overlaps.monitor->push(overlaps.loop.next(overlaps.t_us));
    ++more;
  }
  EXPECT_GT(more, 5);
  waits.run(count);
  EXPECT_EQ(overlaps.report().verdict, waits.report().verdict);
  EXPECT_EQ(overlaps.report().fit_valve_percent, waits.report().fit_valve_percent);
  EXPECT_EQ(overlaps.report().window_end_us, count * kSecond);
  EXPECT_EQ(overlaps.report().window_samples, waits.report().window_samples);
}

TEST(Monitor, AnswersAtTheEndOfARecordingThatIsTooShort) {
  Plant plant;
  plant.monitor->evaluate_now();
  EXPECT_FALSE(plant.report().evaluated);
  plant.run(20);
  EXPECT_FALSE(plant.report().evaluated);
  plant.monitor->evaluate_now();
  EXPECT_TRUE(plant.report().evaluated);
  EXPECT_EQ(plant.report().verdict, Verdict::kUndecided);
  EXPECT_EQ(plant.report().reason, Reason::kTooShort);
  EXPECT_EQ(plant.report().window_samples, 20U);
  // Nothing new to look at.
  plant.monitor->evaluate_now();
  EXPECT_EQ(plant.report().counters.evaluations, 1U);
}

TEST(Monitor, AsksOnceForMoreDataNotForEveryWindow) {
  Plant plant;
  for (int k = 0; k < 30; ++k) {
    plant.feed(100, constant);
    plant.monitor->evaluate_now();
    plant.drain();
  }
  EXPECT_GE(plant.report().counters.evaluations, 30U);
  ASSERT_EQ(plant.events.size(), 1U);
  EXPECT_EQ(plant.events[0].kind, EventKind::kUndecided);
  EXPECT_EQ(plant.events[0].reason, Reason::kConstant);
}

TEST(Monitor, EvaluationsOnDemandDoNotHurryTheAlarm) {
  MonitorSettings<float> settings;
  settings.alarm.on_delay_windows = 3;
  Plant plant(settings);
  while (plant.report().counters.evaluations == 0) {
    plant.run(1);
  }
  ASSERT_EQ(plant.report().verdict, Verdict::kStiction);
  for (int k = 0; k < 3; ++k) {
    plant.run(1);
    plant.monitor->evaluate_now();
    EXPECT_EQ(plant.report().verdict, Verdict::kStiction);
    EXPECT_EQ(plant.report().window_end_us, plant.t_us);
  }
  EXPECT_FALSE(plant.report().stiction_raised);
}

TEST(Monitor, FitsTheTwoPathModelWhereAWindowIsAskedFor) {
  Plant plant;
  while (plant.t_us < 1500 * kSecond && !plant.report().stiction_raised) {
    plant.run(1);
  }
  EXPECT_GT(plant.report().fit_valve_percent, 50);
  EXPECT_EQ(plant.report().fit_percent, 0);
  plant.run(1);
  plant.monitor->request_evaluation();
  while (plant.monitor->step(1000)) {
  }
  ASSERT_TRUE(plant.report().asked);
  EXPECT_GT(plant.report().fit_percent, 50);
}

TEST(Monitor, AWindowThatComesDueDuringARequestFollowsIt) {
  Plant plant;
  plant.feed(600, limit_cycle_wave);
  while (!plant.monitor->due()) plant.feed(1, limit_cycle_wave);
  while (plant.monitor->step(1000)) {
  }
  while (!plant.monitor->due()) plant.feed(1, limit_cycle_wave);
  while (plant.monitor->step(1000)) {
  }
  const MonitorCounters before = plant.report().counters;
  plant.feed(120, limit_cycle_wave);
  ASSERT_FALSE(plant.monitor->due());
  plant.monitor->request_evaluation();
  EXPECT_TRUE(plant.monitor->step(1));
  plant.feed(10, limit_cycle_wave);
  EXPECT_TRUE(plant.monitor->due());
  while (plant.monitor->step(1000)) {
  }
  EXPECT_EQ(plant.report().counters.evaluations, before.evaluations + 2);
  EXPECT_EQ(plant.report().counters.skipped_windows, before.skipped_windows);
  EXPECT_FALSE(plant.report().asked) << "the window that was due came last";
}

TEST(Monitor, DropsAnEvaluationThatWasAskedForBeforeAFault) {
  Plant plant;
  plant.run(600);
  const MonitorReport<float> before = plant.report();
  ASSERT_EQ(before.verdict, Verdict::kStiction);
  plant.feed(1, constant);
  plant.monitor->request_evaluation();
  plant.monitor->advance(plant.t_us + 100 * kSecond);
  ASSERT_EQ(plant.report().fault, InputFault::kStale);
  EXPECT_FALSE(plant.monitor->busy()) << "no sample is left to look at";
  while (plant.monitor->step(1000)) {
  }
  EXPECT_EQ(plant.report().verdict, Verdict::kStiction);
  EXPECT_EQ(plant.report().counters.evaluations, before.counters.evaluations);
}

TEST(Monitor, ForgetsInWindowsThatSayNothing) {
  Plant plant;
  plant.run(1024);
  const auto rest = [&](int windows) {
    plant.feed(windows * static_cast<int>(Small::kCapacity), [&](int k) {
      while (plant.monitor->step(1000)) {
      }
      const float drift = 0.001F * static_cast<float>(k);
      return Pair{50 + drift, 20 + drift};
    });
    return plant.monitor->memory().pool.windows();
  };
  const float windows = rest(2);  // the first one has samples of before
  ASSERT_EQ(plant.report().verdict, Verdict::kUndecided);
  EXPECT_NEAR(rest(3), 0.729F * windows, 0.02F * windows);
}

TEST(Monitor, ForgetsWhatItWasToldHoweverOftenItEvaluates) {
  for (const int memory_pct : {0, 50, 100}) {
    for (const int every_pct : {100, 25, 1}) {
      MonitorSettings<float> settings;
      settings.memory_pct = memory_pct;
      settings.evaluate_every_pct = every_pct;
      MonitorMemory memory;
      memory.pool = EvidencePool({.windows = 8});
      Plant plant(settings);
      plant.monitor->restore(memory, 0);
      for (std::size_t k = 0; k < 2 * Small::kCapacity; ++k) {
        plant.feed(1, constant);
        while (plant.monitor->step(1000)) {
        }
      }
      const float share = 0.01F * static_cast<float>(memory_pct);
      EXPECT_NEAR(plant.monitor->memory().pool.windows(), 8 * share * share, 0.3)
          << memory_pct << " % every " << every_pct << " %";
    }
  }
}

TEST(Monitor, WaitsForAFullWindowWhereNothingOscillates) {
  Plant plant;
  plant.feed(511, constant);
  EXPECT_FALSE(plant.monitor->busy());
  EXPECT_FALSE(plant.monitor->step(1));
  plant.feed(1, constant);
  EXPECT_TRUE(plant.monitor->busy());
}

TEST(Monitor, CountsWindowsThatComeTooSoon) {
  Plant plant;
  plant.feed(512 + 3 * 128, constant);
  EXPECT_EQ(plant.report().counters.skipped_windows, 3U);
  while (plant.monitor->step(1000)) {
  }
  EXPECT_EQ(plant.report().counters.evaluations, 1U);
  EXPECT_EQ(plant.report().window_end_us, plant.t_us);
}

TEST(Monitor, TellsWhenTheOscillationStartsAndEnds) {
  Plant plant;
  plant.feed(300, limit_cycle_wave);
  ASSERT_EQ(plant.events.size(), 1U);
  EXPECT_EQ(plant.events[0].kind, EventKind::kOscillationStarted);
  EXPECT_NEAR(plant.events[0].period_samples, 20.9f, 0.5f);
  plant.feed(1500, constant);
  ASSERT_EQ(plant.events.size(), 2U);
  EXPECT_EQ(plant.events[1].kind, EventKind::kOscillationEnded);
  EXPECT_FALSE(plant.report().oscillating);
}

TEST(Monitor, AFrozenInputIsAFaultAndNotUsed) {
  Plant plant;
  plant.feed(1000, frozen_y);
  ASSERT_EQ(plant.of(EventKind::kInputFault).size(), 1U);
  EXPECT_EQ(plant.events.back().fault, InputFault::kFrozenY);
  EXPECT_EQ(plant.report().fault, InputFault::kFrozenY);
  EXPECT_EQ(plant.report().counters.input_faults, 1U);
  EXPECT_FALSE(plant.monitor->busy());
  plant.monitor->request_evaluation();
  EXPECT_FALSE(plant.monitor->busy());

  plant.feed(64, limit_cycle_wave);
  ASSERT_EQ(plant.of(EventKind::kInputRestored).size(), 1U);
  EXPECT_EQ(plant.events.back().fault, InputFault::kFrozenY);
  EXPECT_EQ(plant.report().fault, InputFault::kNone);
  plant.monitor->evaluate_now();
  EXPECT_EQ(plant.report().window_samples, 60U);
}

TEST(Monitor, AnOutageIsAFaultAndBeginsTheWindowAnew) {
  Plant plant;
  plant.feed(90, limit_cycle_wave);
  plant.t_us += 100 * kSecond;
  plant.monitor->advance(plant.t_us);
  plant.drain();
  ASSERT_EQ(plant.of(EventKind::kInputFault).size(), 1U);
  EXPECT_EQ(plant.events.back().fault, InputFault::kStale);
  EXPECT_EQ(plant.events.back().t_s(), 95);
  plant.feed(30, limit_cycle_wave);
  EXPECT_EQ(plant.of(EventKind::kInputFault).size(), 1U);
  ASSERT_EQ(plant.of(EventKind::kInputRestored).size(), 1U);
  EXPECT_EQ(plant.report().samples.restarts, 1U);
  plant.monitor->evaluate_now();
  EXPECT_LE(plant.report().window_samples, 30U);
}

TEST(Monitor, SmallGapsAreFilledAndRefusedSamplesCounted) {
  Plant plant;
  plant.feed(60, limit_cycle_wave);
  plant.t_us += 2 * kSecond;
  plant.feed(1, limit_cycle_wave);
  EXPECT_EQ(plant.report().samples.filled, 2U);
  EXPECT_EQ(plant.monitor->window().size(), 63U);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(plant.monitor->push({plant.t_us + kSecond, nan, 0}), PushResult::kNonFinite);
  EXPECT_EQ(plant.monitor->push({plant.t_us, 1, 1}), PushResult::kRepeat);
  EXPECT_EQ(plant.monitor->push({0, 1, 1}), PushResult::kTimeBack);
  EXPECT_EQ(plant.report().samples.non_finite, 1U);
  EXPECT_EQ(plant.report().samples.repeats, 1U);
  EXPECT_EQ(plant.report().samples.time_back, 1U);
  plant.monitor->evaluate_now();
  EXPECT_EQ(plant.report().window_samples, 63U);
  EXPECT_TRUE(plant.of(EventKind::kInputFault).empty());
}

TEST(Monitor, AFullQueueDropsTheOldestAndCounts) {
  MonitorSettings<float> settings;
  settings.input.restore_after_samples = 1;
  Small monitor(settings);
  std::int64_t t_us = 0;
  constexpr int kFaults = 10;
  monitor.push({t_us, 0, 0});
  for (int k = 0; k < kFaults; ++k) {
    monitor.push({t_us += 100 * kSecond, 0, 0});
    monitor.push({t_us += kSecond, 0, 0});
  }
  EXPECT_EQ(monitor.report().counters.events_lost, 2 * kFaults - Small::kEvents);
  std::int64_t newest = 0;
  std::size_t count = 0;
  while (const auto event = monitor.poll()) {
    EXPECT_GT(event->t_us, newest);
    newest = event->t_us;
    ++count;
  }
  EXPECT_EQ(count, Small::kEvents);
  EXPECT_EQ(newest, t_us);
}

TEST(Monitor, SettingsOutsideTheirRangesAreMovedToTheBound) {
  MonitorSettings<float> settings;
  settings.longest_hold = -1;
  settings.span_low = std::numeric_limits<float>::infinity();
  settings.evaluate_every_pct = 100000;
  settings.first_cycles = -7;
  settings.gain_sign = 99;
  Plant plant(settings);
  plant.feed(1500, limit_cycle_wave);
  plant.monitor->evaluate_now();
  EXPECT_TRUE(plant.report().evaluated);
}

TEST(Monitor, EveryEventHasTheContractsName) {
  const std::vector<std::string_view> names = {
      "oscillation_started", "oscillation_ended", "stiction_raised", "stiction_cleared",
      "undecided",           "input_fault",       "input_restored"};
  for (int k = 0; k < kEventKinds; ++k) {
    EXPECT_EQ(name(static_cast<EventKind>(k)), names[static_cast<std::size_t>(k)]);
  }
}

}  // namespace
}  // namespace ident
