#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/csv.hpp"
#include "workbench/recording/formats/logfmt.hpp"

namespace workbench {
namespace {

TEST(Logfmt, IsATableOfTheNames) {
  EXPECT_EQ(logfmt_text("2026-03-04T06:00:01Z op=4.5 pv=6.1 sp=6\n"
                        "\r\n"
                        "2026-03-04T06:00:02Z op=4.6 sp=6\r\n"),
            "time\top\tpv\tsp\n"
            "2026-03-04T06:00:01Z\t4.5\t6.1\t6\n"
            "2026-03-04T06:00:02Z\t4.6\t\t6\n");
}

TEST(Logfmt, TakesOtherWordsAsTheyCome) {
  EXPECT_EQ(logfmt_text("ts=1 level=info msg=\"op=9 \\\"a\\\" b\" op=4.5\n"),
            "ts\tlevel\tmsg\top\n1\tinfo\top=9 a b\t4.5\n");
  EXPECT_EQ(logfmt_text("[2026-03-04 06:00:01] INFO loop op=4.5\n"),
            "time\top\n2026-03-04 06:00:01\t4.5\n");
  EXPECT_EQ(logfmt_text("12.5 op=1\n13.5 op=2\n14.5 op=3\nstopped\n"),
            "time\top\n12.5\t1\n13.5\t2\n14.5\t3\n");
}

TEST(Logfmt, LeavesOtherTexts) {
  for (const char* text :
       {"", "t,u,y\n0,1,2\n", "t u y\n0 1 2\n", "a b=c\n", "a=1,b=2\n0,1\n",
        "rate=1 unit=s\nt,u,y\n0,1,2\n1,2,3\n", "(1436509052.2) vcan0 044#2A\n",
        "u = 1 y = 2\n", "1=2 3=4\n"}) {
    EXPECT_FALSE(logfmt_text(text)) << text;
  }
}

// Lines of one width are no columns of fixed width where the last one lacks a value.
TEST(Logfmt, OpensAsARecording) {
  std::string text;
  for (int k = 10; k < 60; ++k) {
    text += "2026-03-04T06:00:" + std::to_string(k) +
            "Z level=info op=" + std::to_string(k) + " pv=" + std::to_string(k + 20) +
            (k % 9 == 4 ? "\n" : " sp=6\n");
  }
  const Recording recording = parse_csv(text, "loop.log");
  EXPECT_EQ(recording.size(), 50U);
  EXPECT_EQ(recording.period_s, 1);
  EXPECT_EQ(recording.u.front(), 10);
  EXPECT_EQ(recording.y.back(), 79);
}

}  // namespace
}  // namespace workbench
