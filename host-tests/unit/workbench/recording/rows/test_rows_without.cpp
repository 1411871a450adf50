#include <gtest/gtest.h>

#include <cmath>

#include "workbench/recording/rows/rows_without.hpp"

namespace workbench {
namespace {

RowTable table_of(std::size_t rows) {
  RowTable out;
  for (const Column column : {Column::u, Column::y}) {
    out.signals.emplace_back();
    out.signals.back().column = column;
    out.signals.back().name = name_of(column);
  }
  for (std::size_t i = 0; i < rows; ++i) {
    out.t.push_back(5.0 * static_cast<double>(i));
    out.line.push_back(static_cast<std::uint32_t>(i + 2));
    for (SignalRows& signal : out.signals)
      signal.values.push_back(static_cast<double>(i));
  }
  return out;
}

void empty(SignalRows& signal, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) signal.values[i] = std::nan("");
}

TEST(RowsWithout, OfALongStretchAreTakenOut) {
  RowTable table = table_of(100);
  empty(table.signals[1], 40, 60);
  table.signals[1].bad = 20;
  table.signals[1].bad_word = "Bad";
  ResampleReport report;
  take_out_rows_without(table, report);
  ASSERT_EQ(table.t.size(), 80u);
  EXPECT_EQ(table.t[40], 300);
  EXPECT_EQ(table.line[40], 62u);
  EXPECT_EQ(table.signals[0].values[40], 60);
  ASSERT_EQ(report.notes.size(), 1u);
  EXPECT_EQ(report.notes[0],
            "20 rows in 1 long stretch without a value of 'y' ('Bad'): taken as missing");
}

TEST(RowsWithout, AtTheEndAreTakenOutThoseBeforeTheFirstValueStay) {
  RowTable table = table_of(100);
  empty(table.signals[0], 0, 20);
  empty(table.signals[1], 85, 100);
  ResampleReport report;
  take_out_rows_without(table, report);
  EXPECT_EQ(table.t.size(), 85u);
}

TEST(RowsWithout, StayWhereAFewAreMissing) {
  RowTable table = table_of(100);
  empty(table.signals[1], 40, 45);
  ResampleReport report;
  take_out_rows_without(table, report);
  EXPECT_EQ(table.t.size(), 100u);
  EXPECT_TRUE(report.notes.empty());
}

TEST(RowsWithout, StayWhereASignalIsStoredOnlyWhenItChanges) {
  RowTable table = table_of(300);
  for (std::size_t i = 0; i < 300; ++i) {
    if (i % 12 != 0) empty(table.signals[1], i, i + 1);
  }
  ResampleReport report;
  take_out_rows_without(table, report);
  EXPECT_EQ(table.t.size(), 300u);
}

}  // namespace
}  // namespace workbench
