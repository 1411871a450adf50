#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include "c/stickband.h"
#include "examples/cortex-m4f/plant.h"
#include "ident/monitor.hpp"

namespace {

// Of the example's loop, whose valve sticks.
const std::vector<stickband_sample>& samples() {
  static const std::vector<stickband_sample> all = [] {
    std::vector<stickband_sample> out(900);
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k].t_us = static_cast<std::int64_t>(k) * 1'000'000;
      plant_sample(&out[k].u, &out[k].y);
    }
    return out;
  }();
  return all;
}

struct OneLoop {
  std::unique_ptr<stickband_storage_512> storage =
      std::make_unique<stickband_storage_512>();
  stickband_settings settings;
  stickband* loop = nullptr;

  explicit OneLoop(float span_high = 100) {
    stickband_default_settings(&settings);
    settings.span_high = span_high;
    loop = stickband_init_512(storage.get(), &settings);
  }
  void play(std::size_t most) {
    for (std::size_t k = 0; k < most; ++k) {
      EXPECT_EQ(stickband_push(loop, &samples()[k]), 1);
      while (stickband_step(loop, 1000) == 1) {
      }
    }
  }
  [[nodiscard]] stickband_report report() const {
    stickband_report out;
    stickband_get_report(loop, &out);
    return out;
  }
  [[nodiscard]] std::vector<unsigned char> saved() const {
    std::vector<unsigned char> out(STICKBAND_MEMORY_BYTES);
    out.resize(stickband_save(loop, out.data(), out.size()));
    return out;
  }
};

TEST(StickbandC, SaysWhatTheMonitorSays) {
  OneLoop one;
  one.play(samples().size());
  const auto monitor = std::make_unique<ident::Monitor<float, ident::kSmallWindow>>(
      ident::MonitorSettings<float>{});
  for (const stickband_sample& s : samples()) {
    monitor->push({s.t_us, s.u, s.y});
    while (monitor->step(1000)) {
    }
  }
  const auto expected = monitor->report();
  const stickband_report found = one.report();
  EXPECT_EQ(found.verdict, STICKBAND_STICTION);
  EXPECT_EQ(expected.verdict, ident::Verdict::kStiction);
  EXPECT_EQ(found.raised, 1);
  EXPECT_EQ(found.valve.band_ascending.known, 1);
  EXPECT_EQ(found.valve.band_ascending.low, expected.stick_band.ascending.low);
  EXPECT_EQ(found.valve.band_ascending.high, expected.stick_band.ascending.high);
  EXPECT_EQ(found.valve.jump_descending.value, expected.slip_jump.descending.value);
  EXPECT_LE(found.valve.band_ascending.low, PLANT_STICK_BAND);
  EXPECT_GE(found.valve.band_ascending.high, PLANT_STICK_BAND);
  EXPECT_EQ(found.evaluations, expected.counters.evaluations);
  EXPECT_EQ(found.samples_accepted, samples().size());
  EXPECT_EQ(found.period_s, expected.oscillation.period_samples);
  EXPECT_STREQ(stickband_reason_text(found.reason), sentence(expected.reason).data());
}

TEST(StickbandC, HasNoNumberBeforeAWindowWasJudged) {
  OneLoop one;
  one.play(30);
  const stickband_report report = one.report();
  EXPECT_EQ(report.verdict, STICKBAND_NOT_EVALUATED);
  EXPECT_EQ(report.valve.band_ascending.known, 0);
  EXPECT_EQ(report.valve.band_ascending.value, 0);
  EXPECT_EQ(report.samples_accepted, 30U);
}

TEST(StickbandC, SamplesThatWaitedChangeNothing) {
  OneLoop each;
  each.play(600);
  OneLoop late;
  for (std::size_t k = 0; k < 600; ++k) {
    stickband_push(late.loop, &samples()[k]);
    if (stickband_pending(late.loop) < STICKBAND_QUEUE && k + 1 < 600) continue;
    while (stickband_step(late.loop, 1) == 1) {
    }
  }
  const stickband_report a = each.report();
  const stickband_report b = late.report();
  EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
}

TEST(StickbandC, RefusesAndCountsWhatTheQueueCannotHold) {
  OneLoop one;
  for (unsigned k = 0; k < STICKBAND_QUEUE; ++k) {
    EXPECT_EQ(stickband_push(one.loop, &samples()[k]), 1);
  }
  EXPECT_EQ(stickband_pending(one.loop), STICKBAND_QUEUE);
  EXPECT_EQ(stickband_push(one.loop, &samples()[STICKBAND_QUEUE]), 0);
  stickband_step(one.loop, 1);
  EXPECT_EQ(stickband_pending(one.loop), 0U);
  EXPECT_EQ(one.report().queue_refused, 1U);
  EXPECT_EQ(one.report().samples_accepted, STICKBAND_QUEUE);
}

TEST(StickbandC, TellsEvents) {
  OneLoop one;
  one.play(samples().size());
  std::vector<std::string> names;
  for (stickband_event event; stickband_poll(one.loop, &event) == 1;) {
    names.emplace_back(stickband_event_name(event.kind));
    if (event.kind == STICKBAND_STICTION_RAISED) {
      EXPECT_EQ(event.verdict, STICKBAND_STICTION);
      EXPECT_EQ(event.valve.band_descending.known, 1);
    }
  }
  EXPECT_EQ(names, (std::vector<std::string>{"oscillation_started", "stiction_raised"}));
}

TEST(StickbandC, SilenceIsAFaultWhereAClockTells) {
  OneLoop one;
  one.play(20);
  stickband_advance(one.loop, samples()[19].t_us + 60'000'000);
  EXPECT_EQ(one.report().fault, STICKBAND_FAULT_STALE);
  EXPECT_STREQ(stickband_fault_name(one.report().fault), "stale");
}

TEST(StickbandC, WhatWaitsIsNoSilence) {
  OneLoop one;
  one.play(20);
  EXPECT_EQ(stickband_push(one.loop, &samples()[20]), 1);
  stickband_advance(one.loop, samples()[20].t_us + 1);
  EXPECT_EQ(stickband_pending(one.loop), 0U);
  EXPECT_EQ(one.report().fault, STICKBAND_FAULT_NONE);
}

TEST(StickbandC, CountsWindowsForWhichItIsTooSlow) {
  OneLoop one;
  for (std::size_t k = 0; k < 8 * STICKBAND_QUEUE * 20; ++k) {
    stickband_sample sample = samples()[k % samples().size()];
    sample.t_us =
        samples()[0].t_us + static_cast<std::int64_t>(k) * one.settings.sample_period_us;
    stickband_push(one.loop, &sample);
    stickband_step(one.loop, 1);
  }
  EXPECT_GT(one.report().overruns, 0U);
}

TEST(StickbandC, CountsWhatTheMonitorCounts) {
  OneLoop one;
  std::int64_t t_us = 0;
  const auto wait = [&](int periods) {
    t_us += periods * one.settings.sample_period_us;
    const stickband_sample sample = {t_us, 1.0F, 2.0F, 0.0F, 0};
    EXPECT_EQ(stickband_push(one.loop, &sample), 1);
    stickband_step(one.loop, 1);
  };
  wait(1);
  wait(1 + one.settings.longest_hold);
  EXPECT_EQ(one.report().samples_filled, 3U);
  EXPECT_EQ(one.report().restarts, 0U);
  wait(2 + one.settings.longest_hold);
  EXPECT_EQ(one.report().restarts, 1U);
  for (unsigned faults = 1; faults <= 10; ++faults) {
    wait(100);
    for (int k = 0; k < 5; ++k) wait(1);
    EXPECT_EQ(one.report().input_faults, faults);
  }
  using Monitor = ident::Monitor<float, ident::kSmallWindow>;
  EXPECT_EQ(one.report().events_lost, 20U - Monitor::kEvents)
      << "a fault and its end each";
}

TEST(StickbandC, AClockThatStandsIsAFault) {
  OneLoop one;
  one.play(20);
  for (int k = 0; k < 40; ++k) {
    EXPECT_EQ(stickband_push(one.loop, &samples()[19]), 1);
    stickband_step(one.loop, 1);
  }
  EXPECT_EQ(one.report().samples_refused, 40U);
  EXPECT_EQ(one.report().fault, STICKBAND_FAULT_STALE);
}

TEST(StickbandC, MemorySurvivesARestart) {
  OneLoop before;
  before.play(samples().size());
  const auto bytes = before.saved();
  ASSERT_GT(bytes.size(), 100U);
  OneLoop after;
  EXPECT_EQ(stickband_restore(after.loop, bytes.data(), bytes.size(), 0),
            STICKBAND_RESTORED);
  EXPECT_EQ(after.report().raised, 1);
  EXPECT_EQ(after.saved(), bytes);
  OneLoop later;
  EXPECT_EQ(stickband_restore(later.loop, bytes.data(), bytes.size(), 1e6F),
            STICKBAND_RESTORED);
  EXPECT_NE(later.saved(), bytes) << "the evidence has faded";
}

TEST(StickbandC, RefusesMemoryOnceASampleHasCome) {
  OneLoop before;
  before.play(samples().size());
  const auto bytes = before.saved();
  OneLoop after;
  EXPECT_EQ(stickband_push(after.loop, samples().data()), 1);
  for (int waits = 1; waits >= 0; --waits) {
    EXPECT_EQ(stickband_restore(after.loop, bytes.data(), bytes.size(), 0),
              STICKBAND_TOO_LATE);
    EXPECT_EQ(after.report().raised, 0);
    stickband_step(after.loop, 1);
  }
}

TEST(StickbandC, TakesMemoryBackOutOfAWholeBuffer) {
  OneLoop before;
  before.play(600);
  auto bytes = before.saved();
  bytes.resize(STICKBAND_MEMORY_BYTES + 40);
  OneLoop after;
  EXPECT_EQ(stickband_restore(after.loop, bytes.data(), bytes.size(), 0),
            STICKBAND_RESTORED);
  EXPECT_EQ(after.saved(), before.saved());
}

TEST(StickbandC, ForgetsNothingForEverWhereNothingIsForgotten) {
  OneLoop before;
  before.play(600);
  const auto bytes = before.saved();
  OneLoop after;
  after.settings.memory_pct = 100;
  after.loop = stickband_init_512(after.storage.get(), &after.settings);
  EXPECT_EQ(stickband_restore(after.loop, bytes.data(), bytes.size(), INFINITY),
            STICKBAND_RESTORED);
  EXPECT_EQ(after.saved(), bytes);
}

TEST(StickbandC, RefusesMemoryThatIsNotItsOwn) {
  OneLoop before;
  before.play(600);
  const auto bytes = before.saved();
  OneLoop after;
  const auto restore = [&](const std::vector<unsigned char>& what) {
    return stickband_restore(after.loop, what.data(), what.size(), 0);
  };
  for (std::size_t at = 5; at < bytes.size(); at += 3) {
    auto bad = bytes;
    bad[at] ^= 0x10;
    EXPECT_EQ(restore(bad), STICKBAND_DAMAGED) << at;
  }
  auto other = bytes;
  other[4] = 9;
  EXPECT_EQ(restore(other), STICKBAND_NO_MEMORY) << "version";
  EXPECT_EQ(restore({bytes.begin(), bytes.end() - 1}), STICKBAND_NO_MEMORY) << "cut off";
  OneLoop wide(200);
  EXPECT_EQ(stickband_restore(wide.loop, bytes.data(), bytes.size(), 0),
            STICKBAND_OTHER_SETTINGS);
  EXPECT_EQ(after.report().raised, 0) << "nothing has changed";
  std::array<unsigned char, 16> small{};
  EXPECT_EQ(stickband_save(before.loop, small.data(), small.size()), 0U);
}

TEST(StickbandC, NamesAreEmptyForNumbersThatAreNone) {
  EXPECT_STREQ(stickband_verdict_name(STICKBAND_NOT_EVALUATED), "not_evaluated");
  EXPECT_STREQ(stickband_verdict_name(STICKBAND_BAD_DATA), "bad_data");
  EXPECT_STREQ(stickband_effect_name(1), "valve.stiction");
  for (const int32_t none : {-1, 1000}) {
    EXPECT_STREQ(stickband_verdict_name(none), "");
    EXPECT_STREQ(stickband_event_name(none), "");
    EXPECT_STREQ(stickband_fault_name(none), "");
    EXPECT_STREQ(stickband_effect_name(none), "");
    EXPECT_STREQ(stickband_reason_text(none), "");
  }
}

TEST(StickbandC, LargerWindowsLiveInTheirStorage) {
  stickband_settings settings;
  stickband_default_settings(&settings);
  const auto standard = std::make_unique<stickband_storage_2048>();
  const auto large = std::make_unique<stickband_storage_4096>();
  for (stickband* loop : {stickband_init_2048(standard.get(), &settings),
                          stickband_init_4096(large.get(), &settings)}) {
    EXPECT_EQ(stickband_push(loop, samples().data()), 1);
    stickband_step(loop, 1);
    stickband_report report;
    stickband_get_report(loop, &report);
    EXPECT_EQ(report.samples_accepted, 1U);
  }
}

// What a program that was compiled against the header relies on.
TEST(StickbandC, LayoutStands) {
  EXPECT_EQ(sizeof(stickband_settings), 56U);
  EXPECT_EQ(sizeof(stickband_sample), 24U);
  EXPECT_EQ(sizeof(stickband_estimate), 16U);
  EXPECT_EQ(sizeof(stickband_valve), 64U);
  EXPECT_EQ(sizeof(stickband_report), 168U);
  EXPECT_EQ(sizeof(stickband_event), 88U);
  EXPECT_EQ(offsetof(stickband_report, valve), 24U);
  EXPECT_EQ(offsetof(stickband_report, window_end_us), 88U);
  EXPECT_EQ(offsetof(stickband_report, gaps), 144U);
  EXPECT_EQ(offsetof(stickband_report, overruns), 148U);
  EXPECT_EQ(offsetof(stickband_report, input_faults), 164U);
}

}  // namespace
