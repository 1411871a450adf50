#include <gtest/gtest.h>

#include "workbench/analysis/contradiction.hpp"

namespace workbench {
namespace {

using Kind = Contradiction::Kind;
using ident::Verdict;

WindowFinding window_sticking(std::size_t recording, double band,
                              double half_width = 0.3) {
  WindowFinding window{.recording = recording, .to_s = 60, .verdict = Verdict::kStiction};
  const ident::Estimate<double> estimate{true, band, band - half_width,
                                         band + half_width};
  window.stick_band = {estimate, estimate};
  return window;
}

WindowFinding window_says(std::size_t recording, Verdict verdict) {
  return {.recording = recording, .to_s = 60, .verdict = verdict};
}

TEST(Contradiction, NoneWhereBandsMayBeTheSame) {
  const Contradiction found =
      contradiction_of({window_sticking(0, 4), window_sticking(1, 4.5)});
  EXPECT_EQ(found.kind, Kind::kNone);
  EXPECT_EQ(found.note, "");
}

TEST(Contradiction, NoneOfOneRecordingOrOfThoseThatCannotTell) {
  EXPECT_EQ(contradiction_of({window_sticking(0, 4), window_sticking(0, 8)}).kind,
            Kind::kNone);
  EXPECT_EQ(
      contradiction_of({window_sticking(0, 4), window_says(1, Verdict::kUndecided)}).kind,
      Kind::kNone);
  EXPECT_EQ(contradiction_of({window_says(0, Verdict::kNoStiction),
                              window_says(1, Verdict::kNoStiction)})
                .kind,
            Kind::kNone);
}

TEST(Contradiction, BandsThatExcludeEachOtherAreNamedWithTheirRecordings) {
  const Contradiction found =
      contradiction_of({window_sticking(0, 4), window_sticking(1, 8)});
  EXPECT_EQ(found.kind, Kind::kBands);
  EXPECT_NE(found.note.find("4.00 ascending and 4.00 descending in recording 1"),
            std::string::npos)
      << found.note;
  EXPECT_NE(found.note.find("8.00 ascending and 8.00 descending in recording 2"),
            std::string::npos)
      << found.note;
}

// One stroke may stick alone on one day.
TEST(Contradiction, OneStrokeThatAgreesIsEnough) {
  WindowFinding other = window_sticking(1, 8);
  other.stick_band.descending = window_sticking(1, 4).stick_band.descending;
  EXPECT_EQ(contradiction_of({window_sticking(0, 4), other}).kind, Kind::kNone);
}

TEST(Contradiction, AProcessTurnedRoundIsAnotherLoop) {
  WindowFinding turned = window_sticking(1, 4);
  turned.gain_sign = -1;
  EXPECT_EQ(contradiction_of({window_sticking(0, 4), turned}).kind, Kind::kGains);
}

TEST(Contradiction, TellsWhetherMostRecordingsStick) {
  const Contradiction repaired =
      contradiction_of({window_sticking(0, 4), window_says(1, Verdict::kNoStiction)});
  EXPECT_EQ(repaired.kind, Kind::kRepaired);
  EXPECT_FALSE(repaired.mostly_sticks);
  EXPECT_NE(repaired.note.find("none in recording 2"), std::string::npos)
      << repaired.note;
  const Contradiction began =
      contradiction_of({window_says(0, Verdict::kNoStiction), window_sticking(1, 4),
                        window_sticking(2, 4)});
  EXPECT_TRUE(began.mostly_sticks);
}

// Of a recording of several windows the majority speaks.
TEST(Contradiction, TakesARecordingByTheMajorityOfItsWindows) {
  EXPECT_EQ(contradiction_of({window_sticking(0, 4), window_sticking(0, 4),
                              window_sticking(0, 9), window_sticking(1, 8),
                              window_says(1, Verdict::kUndecided)})
                .kind,
            Kind::kBands);
  EXPECT_EQ(contradiction_of({window_sticking(0, 4), window_says(1, Verdict::kNoStiction),
                              window_says(1, Verdict::kStiction)})
                .kind,
            Kind::kNone);
}

// A window from `from` to `from` + 10 s.
WindowFinding at(double from, WindowFinding window, double nats) {
  window.from_s = from;
  window.to_s = from + 10;
  window.nats = nats;
  return window;
}

TEST(EndedNote, TellsSinceWhenNothingIsSeen) {
  const WindowFinding open = window_says(0, Verdict::kUndecided);
  std::vector<WindowFinding> findings{at(0, window_sticking(0, 4), 90),
                                      at(10, window_sticking(0, 4), 80), at(20, open, -9),
                                      at(30, open, -12)};
  EXPECT_EQ(ended_note(findings).find("no window after 20 s"), 0U)
      << ended_note(findings);
  findings.back().nats = 5;
  EXPECT_EQ(ended_note(findings), "");
  findings.back() = at(30, window_sticking(0, 4), 70);
  EXPECT_EQ(ended_note(findings), "");
}

TEST(EndedNote, OneWindowOnEitherSideIsNoEnd) {
  const WindowFinding open = at(30, window_says(0, Verdict::kUndecided), -9);
  EXPECT_EQ(ended_note({at(0, window_sticking(0, 4), 90),
                        at(10, window_sticking(0, 4), 80), open}),
            "");
  EXPECT_EQ(ended_note({at(0, window_sticking(0, 4), 90), open, open}), "");
  EXPECT_EQ(ended_note({}), "");
}

}  // namespace
}  // namespace workbench
