// The recordings of docs/worked-examples.md that the laboratory gave: what was named
// stays named. Skips where they are absent.
#include <gtest/gtest.h>

#include <filesystem>

#include "support/base/recordings.hpp"
#include "workbench/model/search/ladder.hpp"
#include "workbench/recording/source.hpp"

namespace workbench {
namespace {

std::filesystem::path recording_file(const char* name) {
  return std::filesystem::path(STICKBAND_RECORDINGS) / name;
}

TEST(WorkedExamples, TheLaboratoryValveHasACharacteristic) {
  const auto file = recording_file("lab-valve/up-and-down.csv");
  if (const auto why = test::why_unusable(file); !why.empty()) GTEST_SKIP() << why;
  RecordingSource source;
  source.path = file.string();
  const Recording recording = read_recording(source);
  const ExplainResult result =
      explain(recording, start_model(recording, Column::y).model);
  ASSERT_NE(result.best(), nullptr);
  EXPECT_EQ(result.best()->effect, "valve.characteristic");
  EXPECT_LT(result.best()->rmse_after, 0.1);
}

TEST(WorkedExamples, TheHeaterIsMovedByTheSecondHeater) {
  const auto file = recording_file("step-test/heater.csv");
  if (const auto why = test::why_unusable(file); !why.empty()) GTEST_SKIP() << why;
  RecordingSource source;
  source.path = file.string();
  source.names.loads = {"q2"};
  const Recording recording = read_recording(source);
  const ExplainResult lag = explain(recording, start_model(recording, Column::y).model);
  ASSERT_NE(lag.best(), nullptr);
  const bool a_lag = lag.best()->effect == "sensor.lag" ||
                     lag.best()->effect == "process.second_lag" ||
                     lag.best()->effect == "valve.positioner_lag";
  EXPECT_TRUE(a_lag) << lag.best()->effect;
  const ExplainResult load =
      explain(recording, start_model(recording, Column::y, {"sensor.lag"}).model);
  ASSERT_NE(load.best(), nullptr);
  EXPECT_EQ(load.best()->effect, "disturbance.measured:q2");
  EXPECT_LT(load.best()->rmse_after, 0.12);
}

}  // namespace
}  // namespace workbench
