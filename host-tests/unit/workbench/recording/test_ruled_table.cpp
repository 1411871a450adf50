#include <gtest/gtest.h>

#include "workbench/recording/ruled_table.hpp"

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

}  // namespace
}  // namespace workbench
