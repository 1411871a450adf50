#include <gtest/gtest.h>

#include "workbench/recording/formats/ruled_table.hpp"

namespace workbench {
namespace {

TEST(RuledTable, IsCutWhereTheRulerSays) {
  EXPECT_EQ(ruled_text("TS                 NAME  VALUE\r\n"
                       "------------------ ----- -----\r\n"
                       "14-MAR-26 08:00:00 A.OP   44.9\r\n"
                       "\r\n"
                       "(1 row affected)\r\n"),
            "\nTS\tNAME\tVALUE\n14-MAR-26 08:00:00\tA.OP\t44.9\n\n"
            "(1 row affected)\t\t\n");
}

TEST(RuledTable, CountsCharactersNotBytes) {
  EXPECT_EQ(ruled_text("Größe Wert\n----- ----\nm³/h  1\n"), "\nGröße\tWert\nm³/h\t1\n");
}

TEST(RuledTable, LeavesOutNamesRepeatedOnEachPage) {
  EXPECT_EQ(ruled_text("AA BB\n-- --\n1  2\nAA BB\n-- --\n3  4\n"),
            "\nAA\tBB\n1\t2\n\n\n3\t4\n");
}

TEST(RuledTable, NeedsARulerUnderNames) {
  EXPECT_FALSE(ruled_text("t,u,y\n0,1,2\n"));
  EXPECT_FALSE(ruled_text("-- --\n1 2\n"));
  EXPECT_FALSE(ruled_text("t;u;y\n0;-- --;1\n"));
  EXPECT_FALSE(ruled_text(""));
}

TEST(FixedWidthText, IsCutWhereAllLinesHaveABlank) {
  EXPECT_EQ(fixed_width_text("Time     PV    OP\n10:00:00 1.5   2.5\n"
                             "10:00:01       2.6\n10:00:02 1.7      \n"),
            "Time\tPV\tOP\n10:00:00\t1.5\t2.5\n10:00:01\t\t2.6\n10:00:02\t1.7\t\n");
}

TEST(FixedWidthText, NeedsABlankCellAndAStretchForEachName) {
  EXPECT_FALSE(fixed_width_text("Time     PV\n10:00:00 1\n10:00:01 2\n"));
  EXPECT_FALSE(fixed_width_text("Time  PV OP\n1 2 3\n2   4\n13   1 4\n"));
  EXPECT_FALSE(fixed_width_text("t,u  y\n1    2\n1\n"));
  EXPECT_FALSE(fixed_width_text(""));
}

}  // namespace
}  // namespace workbench
