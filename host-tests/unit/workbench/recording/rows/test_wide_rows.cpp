#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/csv.hpp"
#include "workbench/recording/rows/wide_rows.hpp"

namespace workbench {
namespace {

struct Joined {
  std::string wide = "Time [s],FIC101.OP,FIC101.PV\n";
  std::string rows = "Time [s],Tag,Value\n";
};

// Two tags that record events, joined by their times.
Joined joined(const std::string& blank) {
  Joined out;
  for (int k = 0; k < 100; ++k) {
    for (int i = 0; i < 2; ++i) {
      const double at = k + 0.37 * i + 0.005 * (k * (3 + i) % 7);
      const std::string t = std::to_string(at);
      const std::string value = std::to_string(40 + 20 * i + k * (3 + i) % 11);
      out.wide += t + ',' + (i == 0 ? value + ',' + blank : blank + ',' + value) + '\n';
      out.rows += t + ",FIC101." + (i == 0 ? "OP," : "PV,") + value + '\n';
    }
  }
  return out;
}

TEST(WideRows, OfEventsJoinedAreReadWithTheTimesOfEach) {
  for (const char* blank : {"", "NaN", "null"}) {
    const Joined text = joined(blank);
    const Recording wide = parse_csv(text.wide, "a.csv");
    const Recording rows = parse_csv(text.rows, "a.csv");
    EXPECT_NEAR(wide.period_s, 1, 0.06) << blank;
    EXPECT_EQ(wide.period_s, rows.period_s);
    EXPECT_EQ(wide.t, rows.t);
    EXPECT_EQ(wide.u, rows.u);
    EXPECT_EQ(wide.y, rows.y);
    EXPECT_EQ(wide.resampling.notes, rows.resampling.notes);
  }
}

TEST(WideRows, OfOneClockHoldWhatIsMissing) {
  std::string text = "t,u,y\n";
  for (int k = 0; k < 40; ++k) {
    text += std::to_string(k) + ',' + std::to_string(40 + k % 7) + ',' +
            (k % 4 == 0 ? std::to_string(60 + k % 5) : "") + '\n';
  }
  const Recording r = parse_csv(text, "a.csv");
  EXPECT_EQ(r.period_s, 1);
  EXPECT_EQ(r.y[7], r.y[4]);
  EXPECT_EQ(r.resampling.empty_cells, 30U);
}

}  // namespace
}  // namespace workbench
