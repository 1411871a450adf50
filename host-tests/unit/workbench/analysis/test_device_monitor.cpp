// The device's monitor on a desk: settings, samples and JSON.
#include <gtest/gtest.h>

#include "workbench/analysis/device_monitor.hpp"

namespace workbench {
namespace {

Recording three_samples() {
  Recording recording;
  recording.period_s = 0.5;
  recording.t = {10, 10.5, 11};
  recording.u = {40, 60, 50};
  recording.y = {1, 2, 3};
  return recording;
}

TEST(DeviceMonitor, TakesTheSpanFromTheRecordingOrAsGiven) {
  const Recording recording = three_samples();
  const auto found = device_settings(recording, {});
  EXPECT_EQ(found.sample_period_us, 500'000);
  EXPECT_EQ(found.span_low, 40);
  EXPECT_EQ(found.span_high, 60);
  const auto given = device_settings(recording, std::pair{0.0F, 100.0F});
  EXPECT_EQ(given.span_high, 100);
}

TEST(DeviceMonitor, SendsTheSetpointWhereThereIsOne) {
  Recording recording = three_samples();
  const auto without = device_sample(recording, 1);
  EXPECT_EQ(without.t_us, 10'500'000);
  EXPECT_EQ(without.u, 60);
  EXPECT_EQ(without.y, 2);
  EXPECT_FALSE(without.has_sp);
  recording.sp = {7, 8, 9};
  const auto with = device_sample(recording, 2);
  EXPECT_TRUE(with.has_sp);
  EXPECT_EQ(with.sp, 9);
}

TEST(DeviceMonitor, TellsOfAnEventWhatBelongsToItsKind) {
  ident::Event<float> event;
  event.t_us = 2'500'000;
  event.kind = ident::EventKind::kOscillationStarted;
  event.period_samples = 8;
  EXPECT_EQ(event_json(event, 0.5).dump(),
            R"({"t":2.5,"event":"oscillation_started","period_s":4.0})");
  event.kind = ident::EventKind::kStictionRaised;
  event.stick_band.ascending = {true, 5, 4, 6};
  const auto raised = event_json(event, 0.5);
  EXPECT_EQ(raised["stick_band"]["ascending"]["high"], 6.0);
  EXPECT_TRUE(raised["stick_band"]["descending"]["value"].is_null());
  EXPECT_FALSE(raised.contains("period_s"));
}

TEST(DeviceMonitor, SumsUpWithTheMemoryOfTheDevice) {
  const auto summary = summary_json(3, {}, 12.5);
  EXPECT_EQ(summary["event"], "summary");
  EXPECT_EQ(summary["samples"], 3);
  EXPECT_EQ(summary["ram_bytes"], DeviceMonitor::ram_bytes());
  EXPECT_EQ(summary["worst_step_us"], 12.5);
  EXPECT_TRUE(summary["model_gap"]["suspect"].is_null());
}

}  // namespace
}  // namespace workbench
