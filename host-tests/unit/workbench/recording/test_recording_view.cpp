// A recording seen where its samples lie.
#include <gtest/gtest.h>

#include "workbench/recording/recording_view.hpp"

namespace workbench {
namespace {

Recording ten_samples() {
  Recording recording;
  recording.name = "loop.csv";
  recording.period_s = 0.5;
  for (int i = 0; i < 10; ++i) {
    recording.t.push_back(0.5 * i);
    recording.u.push_back(i);
    recording.y.push_back(-i);
  }
  recording.units[static_cast<std::size_t>(Column::y)] = "bar";
  recording.resampling.notes = {"one sample is missing"};
  return recording;
}

TEST(RecordingView, SharesTheSamplesOfARecording) {
  const Recording recording = ten_samples();
  const RecordingView view(recording);
  EXPECT_EQ(view.size(), 10u);
  EXPECT_EQ(view.u.data(), recording.u.data());
  EXPECT_EQ(view.values(Column::y).data(), recording.y.data());
  EXPECT_FALSE(view.has(Column::sp));
  EXPECT_EQ(view.name, "loop.csv");
  EXPECT_EQ(view.unit(Column::y), "bar");
  EXPECT_EQ(view.notes, recording.resampling.notes);
}

TEST(RecordingView, PartIsAStretchOfTheSameSamples) {
  const Recording recording = ten_samples();
  Recording gapped = recording;
  gapped.resampling.gaps = {{1, 5}, {8, 9}};
  const std::vector<SampleRange> gaps = RecordingView(gapped).part(3, 4).gaps;
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_EQ(gaps[0].last, 2u);
  const RecordingView part = RecordingView(recording).part(3, 4);
  EXPECT_EQ(part.size(), 4u);
  EXPECT_EQ(part.u.data(), recording.u.data() + 3);
  EXPECT_EQ(part.t.front(), 1.5);
  EXPECT_TRUE(part.x.empty());
  EXPECT_EQ(part.period_s, 0.5);
}

}  // namespace
}  // namespace workbench
