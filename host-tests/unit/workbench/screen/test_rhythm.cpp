#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "workbench/screen/rhythm.hpp"

namespace workbench {
namespace {

Recording rhythm(double period, std::size_t samples, std::size_t from = 0) {
  Recording out;
  out.period_s = 2;
  for (std::size_t i = 0; i < samples; ++i) {
    out.t.push_back(2.0 * static_cast<double>(i));
    const double at = 2 * std::numbers::pi * static_cast<double>(i) / period;
    out.u.push_back(i < from ? 0 : std::sin(at));
    out.y.push_back(std::cos(at));
  }
  return out;
}

TEST(ClockSeconds, ZonesAreTakenOff) {
  double seconds = 0;
  ASSERT_TRUE(clock_seconds("1970-01-02T00:00:01", seconds));
  EXPECT_EQ(seconds, 86401);
  ASSERT_TRUE(clock_seconds("2026-05-03T14:30:00.250+02:00", seconds));
  EXPECT_DOUBLE_EQ(seconds, 1777811400.25);
  EXPECT_FALSE(clock_seconds("", seconds));
}

TEST(Rhythm, PeriodShareAndTheLatestStretch) {
  const RhythmOfRecording heard = rhythm_of(rhythm(100, 4000), "file");
  EXPECT_NEAR(heard.rhythm.period_s, 200, 4);
  EXPECT_GT(heard.time.share(), 0.95);
  EXPECT_EQ(heard.rhythm.clock, "file");
  EXPECT_LE(heard.rhythm.y.size(), Rhythm::kMostValues);
  const double end = heard.rhythm.start_s +
                     static_cast<double>(heard.rhythm.y.size()) * heard.rhythm.step_s;
  EXPECT_NEAR(end, 8000, 1e-6);
}

TEST(Rhythm, OnlyTheTimeThatItOscillatesCounts) {
  EXPECT_NEAR(rhythm_of(rhythm(50, 4000, 2000), "").time.share(), 0.5, 0.1);
}

TEST(Rhythm, DatesMakeOneClockOfAll) {
  Recording recording = rhythm(60, 1000);
  recording.start = "1970-01-01T01:00:00";
  const RhythmOfRecording heard = rhythm_of(recording, "file");
  EXPECT_EQ(heard.rhythm.clock, "");
  EXPECT_GT(heard.rhythm.start_s, 3600 - 1e-6);
}

TEST(Rhythm, ItsZoneSaysWithWhichOthersItIsComparable) {
  Recording recording = rhythm(60, 1000);
  recording.start = "1970-01-01T01:00:00-06:00";
  recording.zone = "CST";
  const Rhythm open = rhythm_of(recording, "file").rhythm;
  recording.zone = "+08:00";
  const Rhythm sure = rhythm_of(recording, "file").rhythm;
  EXPECT_TRUE(of_one_clock(open, open));
  EXPECT_FALSE(of_one_clock(open, sure));
  Rhythm undated = open;
  undated.clock = "file";
  EXPECT_FALSE(of_one_clock(open, undated));
  Rhythm beside = sure;
  beside.clock = "file";
  EXPECT_TRUE(of_one_clock(undated, beside));
}

TEST(Rhythm, WhatStandsStillHasNone) {
  Recording recording = rhythm(60, 1000);
  for (auto* signal : {&recording.u, &recording.y}) signal->assign(1000, 3.0);
  const RhythmOfRecording heard = rhythm_of(recording, "");
  EXPECT_EQ(heard.rhythm.period_s, 0);
  EXPECT_EQ(heard.time.share(), 0);
}

}  // namespace
}  // namespace workbench
