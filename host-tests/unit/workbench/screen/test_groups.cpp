#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "workbench/screen/groups.hpp"

namespace workbench {
namespace {

// A loop that swings with `period_s`, `late_s` behind others of that period.
ScreenedLoop swinging(const std::string& name, double period_s, double late_s) {
  ScreenedLoop loop;
  loop.loop = name;
  loop.verdict = "undecided";
  loop.nats = -5;
  loop.stem_nats = std::nan("");
  Rhythm& r = loop.rhythm;
  r.period_s = period_s * 1.01;  // the detector is no better
  r.step_s = period_s / 30;
  r.start_s = 1000;
  for (int i = 0; i < 900; ++i) {
    const double t = r.start_s + (i + 0.5) * r.step_s - late_s;
    const double wave = std::cos(2 * std::numbers::pi * t / period_s);
    const double noise = 0.3 * std::sin(1.7 * i * i + late_s);
    r.y.push_back(static_cast<float>(wave + noise));
    r.u.push_back(static_cast<float>(-wave + noise));
  }
  return loop;
}

TEST(Groups, LoopsWithOnePeriodAndPhaseBelongTogether) {
  std::vector<ScreenedLoop> loops{swinging("a", 100, 0), swinging("b", 100, 25),
                                  swinging("c", 107, 0), swinging("d", 240, 0)};
  loops[0].verdict = "stiction";
  loops[0].nats = 80;
  find_groups(loops);
  EXPECT_EQ(loops[0].group, 1);
  EXPECT_EQ(loops[1].group, 1);
  EXPECT_EQ(loops[2].group, 0);
  EXPECT_EQ(loops[3].group, 0);
  EXPECT_TRUE(loops[0].leads);
  EXPECT_EQ(loops[0].group_is, "valve");
  EXPECT_FALSE(loops[1].leads);
  EXPECT_NEAR(loops[1].lag_s, 25, 3);
}

TEST(Groups, WithoutAValveTheGroupSaysSo) {
  std::vector<ScreenedLoop> loops{swinging("a", 100, 0), swinging("b", 100, 25)};
  find_groups(loops);
  EXPECT_EQ(loops[0].group, 1);
  EXPECT_EQ((loops[0].leads ? loops[0] : loops[1]).group_is, "not_a_valve");
}

TEST(Groups, OtherClocksAndTimesAreNotCompared) {
  std::vector<ScreenedLoop> loops{swinging("a", 100, 0), swinging("b", 100, 0)};
  Rhythm& other = loops[1].rhythm;
  find_groups(loops);
  EXPECT_EQ(loops[1].group, 1);
  other.clock = "another.csv";
  loops[0].group = loops[1].group = 0;
  find_groups(loops);
  EXPECT_EQ(loops[1].group, 0);
  other.clock.clear();
  other.start_s += 2500;
  find_groups(loops);
  EXPECT_EQ(loops[1].group, 0);
}

TEST(Groups, ZonesThatMayBeHoursApartAreNotComparedAndSaySo) {
  std::vector<ScreenedLoop> loops{swinging("a", 100, 0), swinging("b", 100, 25),
                                  swinging("c", 100, 0), swinging("d", 100, 0)};
  loops[0].rhythm.zone = loops[1].rhythm.zone = "CST";
  loops[2].rhythm.zone = "+08:00";
  loops[3].rhythm.clock = "undated.csv";
  EXPECT_EQ(explained_by(loops[0].rhythm, loops[2].rhythm), 0);
  find_groups(loops);
  note_zones(loops);
  EXPECT_EQ(loops[0].group, 1);
  EXPECT_EQ(loops[1].group, 1);
  EXPECT_EQ(loops[2].group, 0);
  ASSERT_EQ(loops[0].notes.size(), 1U);
  EXPECT_NE(loops[0].notes[0].find("CST (-06:00 or +08:00), those of other loops +08:00"),
            std::string::npos)
      << loops[0].notes[0];
  EXPECT_EQ(loops[2].notes.size(), 1U);
  EXPECT_TRUE(loops[3].notes.empty());
}

TEST(Groups, WhatComesFirstForetells) {
  // A coloured signal, and the same five steps later.
  ScreenedLoop first = swinging("a", 100, 0);
  ScreenedLoop later = swinging("b", 100, 0);
  std::uint64_t state = 1;
  double value = 0;
  std::vector<float> noise;
  for (std::size_t i = 0; i < first.rhythm.y.size() + 5; ++i) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    value = 0.8 * value + static_cast<double>(state >> 40) / 8388608.0 - 1;
    noise.push_back(static_cast<float>(value));
  }
  for (std::size_t i = 0; i < first.rhythm.y.size(); ++i) {
    first.rhythm.y[i] = noise[i + 5];
    later.rhythm.y[i] = noise[i];
  }
  EXPECT_GT(explained_by(first.rhythm, later.rhythm), 100);
  EXPECT_EQ(explained_by(later.rhythm, first.rhythm), 0);
}

}  // namespace
}  // namespace workbench
