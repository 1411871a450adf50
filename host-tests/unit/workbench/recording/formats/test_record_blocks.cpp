#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/csv.hpp"
#include "workbench/recording/formats/record_blocks.hpp"

namespace workbench {
namespace {

TEST(RecordBlocks, AreATableOfTheNames) {
  EXPECT_EQ(record_blocks_text("Expanded display is on.\n"
                               "-[ RECORD 1 ]------\n"
                               "ts | 2026-03-04 06:00:01+00\n"
                               "op | 4.5\n"
                               "-[ RECORD 2 ]------\r\n"
                               "ts | 2026-03-04 06:00:02+00\r\n"
                               "op | \r\n"
                               "\n"
                               "Time: 1.2 ms\n"),
            "ts\top\n2026-03-04 06:00:01+00\t4.5\n2026-03-04 06:00:02+00\t\n");
}

TEST(RecordBlocks, MayHaveABorder) {
  EXPECT_EQ(record_blocks_text("+-[ RECORD 1 ]-+\n| t  | 0       |\n| op | 4.5     |\n"
                               "+----+---------+\n"),
            "t\top\n0\t4.5\n");
}

TEST(RecordBlocks, LeavesOtherTexts) {
  for (const char* text :
       {"", "t,u,y\n0,1,2\n", "t | u\n--+--\n0 | 1\n", "-[ RECORD 1 ]---\n",
        "a\n\n\n\n\n\n\n\n\n\n\n-[ RECORD 1 ]---\nu | 1\n"}) {
    EXPECT_FALSE(record_blocks_text(text)) << text;
  }
}

TEST(RecordBlocks, OpenAsARecording) {
  std::string text;
  for (int k = 10; k < 60; ++k) {
    text += "-[ RECORD " + std::to_string(k) + " ]---+-----\ntime      | " +
            std::to_string(k) + "\nfic101_op | " + std::to_string(k) + "\nfic101_pv | " +
            std::to_string(2 * k) + "\nnote      | \n";
  }
  const Recording recording = parse_csv(text, "rows.txt");
  EXPECT_EQ(recording.size(), 50U);
  EXPECT_EQ(recording.u.front(), 10);
  EXPECT_EQ(recording.y.back(), 118);
}

}  // namespace
}  // namespace workbench
