#include <gtest/gtest.h>

#include <string>

#include "workbench/recording/rows/row_scanner.hpp"
#include "workbench/recording/rows/value_reader.hpp"

namespace workbench {
namespace {

// The second cells of all rows, or what was refused.
std::string second_cells(const std::string& text, bool plain) {
  const std::string file = "f.csv";
  const CsvLayout layout = layout_of(text, file, {{Column::u, Column::y}, {}});
  RowScanner rows(text, file, layout, {1}, plain);
  std::string cells;
  try {
    while (rows.next()) {
      if (rows.cell(0) == "-") {
        rows.reject(rows.error(0, "a value", "a dash", "write one"));
        continue;
      }
      rows.accept();
      cells += std::string(rows.cell(0)) + ' ';
    }
    std::vector<std::string> notes;
    rows.finish(notes);
    for (const std::string& note : notes) cells += '(' + note + ')';
  } catch (const InputError& error) {
    return error.what();
  }
  return cells;
}

TEST(RowScanner, AHeaderOnceMoreIsNoRow) {
  EXPECT_EQ(second_cells(
                "u,y\n1,2\n\n#group,false\n#datatype,long\n#default,\nu,y\n3,4\n", false),
            "2 4 ");
  EXPECT_EQ(second_cells("u,y\n1,2\n\nu,y\n3,4\n", true), "2 4 ");
  EXPECT_NE(second_cells("u,y\n1,2\nU,Y\n\n3,4\n", true), "2 4 ");
}

TEST(RowScanner, TellsARowBehindAHeader) {
  const std::string text = "u,y\n1,2\n\nu,y\n3,4\n5,6\n";
  const std::string file = "f.csv";
  const CsvLayout layout = layout_of(text, file, {{Column::u, Column::y}, {}});
  RowScanner rows(text, file, layout, {1}, false);
  std::string told;
  while (rows.next()) told += rows.is_behind_head() ? 'h' : '-';
  EXPECT_EQ(told, "-h-");
}

TEST(RowScanner, APlainFileHasAsManyCellsAsItsHeader) {
  EXPECT_EQ(second_cells("u,y\n1,2\n3,4\n\n", true), "2 4 ");
  EXPECT_EQ(second_cells("u,y\n1,2\n3\n", true).rfind("f.csv:3:2: expected 2 cells", 0),
            0U);
  EXPECT_EQ(second_cells("u,y\n1,2\n3,4,5\n", true).rfind("f.csv:3:6", 0), 0U);
  EXPECT_EQ(second_cells("u,y\n1,2\n\n3,4\n", true).rfind("f.csv:3:1", 0), 0U);
}

TEST(RowScanner, ALastLineThatIsCutOffIsLeftOut) {
  EXPECT_EQ(second_cells("u,y\n1,2\n3,4\n5", true),
            "2 4 (the last line is no row ('5'): left out)");
  EXPECT_EQ(second_cells("u,y\n1,2\n3,4\n5,6", true), "2 4 6 ") << "a row";
  for (const char* text : {"u,y\n1,2\n3,4\n5\n", "u,y\n1,2\n3,4\n5,6,7",
                           "u,y\n1,2\n3\n5,6", "u,y\n1,2\n3"}) {
    EXPECT_NE(second_cells(text, true).find("make every row as long as the header"),
              std::string::npos)
        << text;
  }
}

TEST(RowScanner, AnExportMayHaveEmptyLinesAndCells) {
  EXPECT_EQ(second_cells("u,y,z\n1,2,\n\n3,4\n5,6,,,\n", false), "2 4 6 ");
  EXPECT_EQ(second_cells("u,y\n1,2\n3,4,5\n6,7\n", false).rfind("f.csv:3:6", 0), 0U);
}

TEST(RowScanner, OnlyTheEndOfAnExportMayBeNoRows) {
  EXPECT_EQ(second_cells("u,y\n1,2\n3,4\n(2 rows)\n", false),
            "2 4 (the last line is no row ('(2 rows)'): left out)");
  EXPECT_EQ(second_cells("u,y\n1,2\n3,-\n5,6\n", false).rfind("f.csv:3:3", 0), 0U);
}

TEST(ValueReader, ADateIsNoNumberToRepair) {
  const std::string file = "f.csv";
  const std::string text = "u,y\n1,2026-05-03 10:00\n";
  CsvLayout layout = layout_of(text, file, {{Column::u, Column::y}, {}});
  RowScanner rows(text, file, layout, {1}, true);
  ASSERT_TRUE(rows.next());
  ValueReader reader(layout, true);
  SignalRows signal;
  signal.name = "y";
  try {
    reader.append(rows, 0, signal);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(error.advice.find("--time COLUMN"), std::string::npos) << error.what();
  }
}

TEST(RowScanner, WhereBlanksSeparateNoCellIsMissing) {
  EXPECT_EQ(second_cells("Time OP PV TI\n0 1 2 3\n1 1 2 3\n", false), "1 1 ");
  EXPECT_NE(second_cells("Time OP PV TI\n0 1 2 3\n1 2 3\n2 1 2 3\n", false)
                .find("4 cells as in the first row"),
            std::string::npos);
}

TEST(RowScanner, LaterRowsMayFillTheLastNames) {
  std::string text = "X_Value\tOP\tPV\tComment\n";
  for (int i = 0; i < 30; ++i) text += "1\t2\t3\n";
  const CsvLayout layout =
      layout_of(text, "f.csv", {{Column::t, Column::u, Column::y}, {}});
  ASSERT_EQ(layout.columns.size(), 3U);
  text += "1\t2\t3\ttested\n1\t2\t4\n";
  const std::string file = "f.csv";
  RowScanner rows(text, file, layout, {2}, false);
  std::size_t count = 0;
  while (rows.next()) {
    rows.accept();
    ++count;
  }
  EXPECT_EQ(count, 32U);
}

}  // namespace
}  // namespace workbench
