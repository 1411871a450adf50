#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "workbench/analysis/signal_notes.hpp"

namespace workbench {
namespace {

TEST(SignalNotes, SayWhichSignalNeverMoves) {
  Recording recording;
  recording.period_s = 1;
  for (int k = 0; k < 50; ++k) {
    recording.t.push_back(k);
    recording.u.push_back(50);
    recording.y.push_back(k);
  }
  std::vector<std::string> notes = signal_notes(recording);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("u stays at 50"), std::string::npos);
  recording.u = recording.y;
  EXPECT_TRUE(signal_notes(recording).empty());
  recording.y.assign(50, 3.5);
  notes = signal_notes(recording);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0], "y stays at 3.5");
}

TEST(SignalNotes, SayThatUIsDrivenIntoItsLimit) {
  Recording recording;
  recording.period_s = 1;
  for (int k = 0; k < 400; ++k) {
    recording.t.push_back(k);
    recording.u.push_back(std::min(80.0, 60.0 + k % 100));
    recording.y.push_back(k % 7);
  }
  EXPECT_EQ(signal_notes(recording).size(), 1U);
}

TEST(SignalNotes, SayThatTheSignalsMoveInTheSameSample) {
  Recording recording;
  recording.period_s = 1;
  for (int k = 0; k < 400; ++k) {
    recording.t.push_back(k);
    recording.u.push_back(50 + k * 37 % 101 % 13);
    recording.y.push_back(2 * recording.u.back() + 0.5 * (k % 3));
  }
  EXPECT_NE(same_sample_note(recording).find("in the same sample"), std::string::npos);
  // One sample later is what a sampled process does.
  recording.y.insert(recording.y.begin(), recording.y.front());
  recording.y.pop_back();
  EXPECT_EQ(same_sample_note(recording), "");
}

}  // namespace
}  // namespace workbench
