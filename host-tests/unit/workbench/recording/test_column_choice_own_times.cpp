#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/recording/column_choice.hpp"

namespace workbench {
namespace {

// Of the columns `signals` of rows a second apart, a time T and a value v in each cell.
std::optional<std::vector<std::size_t>> times_of(
    const std::string& header, const std::string& row,
    const std::vector<std::size_t>& signals) {
  std::string text = header + '\n';
  for (int i = 10; i < 30; ++i) {
    for (const char c : row) {
      if (c == 'T') {
        text += "2026-05-03 10:00:" + std::to_string(i);
      } else if (c == 'v') {
        text += std::to_string(i % 7) + ".5";
      } else {
        text += c;
      }
    }
    text += '\n';
  }
  return own_times(layout_of(text, "f.csv", {{}, {}}), signals);
}

using OwnTimes = std::vector<std::size_t>;

TEST(OwnTimes, StandOnOneSideOfTheirSignals) {
  EXPECT_EQ(times_of("Time,A.OP,Time,A.PV", "T,v,T,v", {1, 3}), (OwnTimes{0, 2}));
  EXPECT_EQ(times_of("A.OP,Time,A.PV,Time", "v,T,v,T", {0, 2}), (OwnTimes{1, 3}));
  EXPECT_EQ(times_of("A.OP,Time,A.PV,Time,A.SP,Time", "v,T,v,T,v,T", {2, 0, 4}),
            (OwnTimes{3, 1, 5}));
  EXPECT_EQ(times_of("Time,A.OP,A.PV,Time,A.SP", "T,v,v,T,v", {1, 2, 4}),
            (OwnTimes{0, 0, 3}));
}

TEST(OwnTimes, HaveTheNamesOfTheirSignals) {
  EXPECT_EQ(times_of("A.OP,A.OP Time,A.PV,A.PV Time", "v,T,v,T", {0, 2}),
            (OwnTimes{1, 3}));
  EXPECT_EQ(times_of("A.PV Time,A.OP Time,A.OP,A.PV", "T,T,v,v", {2, 3}),
            (OwnTimes{1, 0}));
}

TEST(OwnTimes, OfASetpointRecordedOnce) {
  std::string text = "A.OP,A.OP Time,A.PV,A.PV Time,A.SP,A.SP Time\n";
  for (int i = 10; i < 30; ++i) {
    const std::string time = ",2026-05-03 10:00:" + std::to_string(i) + ',';
    text += std::to_string(i) + time + std::to_string(i) + time +
            (i == 10 ? "50,2026-05-03 10:00:00\n" : ",\n");
  }
  EXPECT_EQ(own_times(layout_of(text, "f.csv", {{}, {}}), {0, 2, 4}),
            (OwnTimes{1, 3, 5}));
}

TEST(OwnTimes, AreNoneWhereRowsHaveOneTime) {
  EXPECT_FALSE(times_of("Time,A.OP,A.PV", "T,v,v", {1, 2}));
  EXPECT_FALSE(times_of("Local,UTC,A.OP,A.PV", "T,T,v,v", {2, 3}));
  EXPECT_FALSE(times_of("Time,A.OP,A.PV,Stored", "T,v,v,T", {1, 2}));
  EXPECT_FALSE(times_of("A.OP,A.PV,Time", "v,v,T", {0, 1}));
}

}  // namespace
}  // namespace workbench
