#include <gtest/gtest.h>

#include "workbench/screen/screen_advice.hpp"

namespace workbench {
namespace {

TEST(ScreenAdvice, NamesThePairByItsOwnOption) {
  EXPECT_EQ(screen_advice("for example --u LV_106 --y FT_115", "a.csv"),
            "for example --pairs LV_106/FT_115");
  EXPECT_EQ(screen_advice("example --time \"#1\" --u \"#2\" --y \"#3\"", "a.csv"),
            "example --time \"#1\" --pairs \"#2/#3\"");
  EXPECT_EQ(screen_advice("--u 'a \"b' --y c", "a.csv").find("--pairs LIST.csv"), 0U);
  EXPECT_EQ(screen_advice("--u OP --y PV --sp SP;", "a.csv"), "--pairs OP/PV/SP;");
  EXPECT_EQ(screen_advice("--ts SECONDS --u COLUMN --y COLUMN", "a.csv"),
            "--ts SECONDS --pairs U/Y");
}

TEST(ScreenAdvice, OfWhatAScreeningCannotBeToldIsACommandForTheFile) {
  EXPECT_EQ(
      screen_advice("found several: 'My data', 'B'; name the sheet with --sheet, or "
                    "remove the others",
                    "a b.xlsx"),
      "found several: 'My data', 'B'; remove the others, or read one alone: "
      "stickband identify \"a b.xlsx\" --sheet \"My data\"");
  EXPECT_EQ(screen_advice("found a candump log; give --config FILE, or --dbc FILE --u "
                          "MESSAGE.SIGNAL --y MESSAGE.SIGNAL",
                          "bus.log"),
            "found a candump log; identify it alone; this lists its signals: stickband "
            "identify bus.log --dbc FILE");
  EXPECT_EQ(screen_advice("name it, for example --u COLUMN, and that", "a.csv"),
            "name it, for example --u COLUMN, and that; these are options of: stickband "
            "identify a.csv");
}

TEST(ScreenAdvice, LeavesTheRestAsItIs) {
  EXPECT_EQ(screen_advice("found an empty file; export it again", "a.csv"),
            "found an empty file; export it again");
}

}  // namespace
}  // namespace workbench
