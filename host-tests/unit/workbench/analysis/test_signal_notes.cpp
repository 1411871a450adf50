#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
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
  for (int k = 0; k < 50; ++k) recording.u[static_cast<std::size_t>(k)] = k % 9;
  EXPECT_TRUE(signal_notes(recording).empty());
  recording.y.assign(50, 3.5);
  notes = signal_notes(recording);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0], "y stays at 3.5");
}

// Of a column that is the controller output once more, in other units and rounded.
TEST(SignalNotes, SayThatBothAreTheSameSignal) {
  Recording recording;
  recording.period_s = 1;
  for (int k = 0; k < 400; ++k) {
    recording.t.push_back(k);
    recording.u.push_back(50 + 20 * std::sin(0.1 * k));
    recording.y.push_back(0.01 * std::round(100 * (10 + 0.5 * recording.u.back())));
  }
  const std::vector<std::string> notes = signal_notes(recording);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("the same signal twice"), std::string::npos);
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

TEST(SignalNotes, SayThatYIsCutOff) {
  Recording recording;
  recording.period_s = 1;
  for (int k = 0; k < 400; ++k) {
    recording.t.push_back(k);
    recording.u.push_back(k % 9);
    recording.y.push_back(std::clamp(12 + 10 * std::sin(0.1 * k), 4.0, 20.0));
  }
  const std::vector<std::string> notes = signal_notes(recording);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_NE(notes[0].find("cut off at 4, its lowest reading, 6 times and 19 %"),
            std::string::npos)
      << notes[0];
  EXPECT_NE(notes[1].find("cut off at 20, its highest reading"), std::string::npos);
}

TEST(SignalNotes, KnowOneSignalOnTwoScales) {
  std::vector<double> y;
  for (int k = 0; k < 400; ++k) y.push_back(50 + k * 37 % 101 % 13);
  std::vector<double> u;
  for (const double value : y) u.push_back(70 - 0.8 * value);
  EXPECT_TRUE(is_one_signal(u, y));
  // What the controller read was stored one sample late.
  std::vector<double> late = y;
  late.insert(late.begin(), y.front());
  late.pop_back();
  EXPECT_TRUE(is_one_signal(u, late));
  EXPECT_FALSE(is_one_signal(late, u)) << "the other way round it is a process";
  u[200] += 5;
  EXPECT_FALSE(is_one_signal(u, y));
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

// Two days of a loop as one file, of which the second runs elsewhere.
TEST(SignalNotes, TellOfWhatAModelTakesAsOne) {
  Recording recording;
  recording.period_s = 2;
  std::mt19937 random(4);
  std::normal_distribution<> noise;
  double y = 0;
  for (int k = 0; k < 600; ++k) {
    const double above = k < 250 ? 0 : 60;
    const double u = std::sin(0.1 * k);
    y += 0.2 * (u - y) + 0.01 * noise(random);
    recording.t.push_back(2.0 * k);
    recording.u.push_back(u + above);
    recording.y.push_back(y + above);
  }
  const std::vector<std::string> notes = notes_for_model(recording);
  ASSERT_FALSE(notes.empty());
  EXPECT_NE(notes[0].find("jump at 500 s, as where two"), std::string::npos);
  for (double& u : recording.u) u = u < 30 ? 0 : 60;
  for (const std::string& note : notes_for_model(recording)) {
    EXPECT_EQ(note.find("as where two"), std::string::npos) << "one step by hand";
  }
}

}  // namespace
}  // namespace workbench
