#include <gtest/gtest.h>

#include "workbench/recording/formats/open_document.hpp"

namespace workbench {
namespace {

TEST(SheetText, KeepsEmptyRowsAndCells) {
  SheetText sheet;
  sheet.begin_row(1);
  sheet.put(0, "Trend");
  sheet.end_row();
  sheet.begin_row(3);
  sheet.put(0, "t");
  sheet.put(2, "say \"PV\"\n");
  sheet.end_row();
  sheet.begin_row(4);
  sheet.put(1, "1");
  sheet.end_row();
  EXPECT_EQ(sheet.text(), "Trend\n\nt\t\tsay 'PV' \n\t1\t\n");
  EXPECT_EQ(sheet.rows(), 1U);
  EXPECT_EQ(sheet.lines(), 4U);
}

TEST(SheetText, LeavesOutWhatNoSheetHas) {
  SheetText sheet;
  sheet.begin_row(1);
  sheet.put(3, "a");
  sheet.put(3, "again");
  sheet.put(1'000'000, "far");
  sheet.end_row();
  EXPECT_EQ(sheet.text(), "\t\t\ta\n");
}

}  // namespace
}  // namespace workbench
