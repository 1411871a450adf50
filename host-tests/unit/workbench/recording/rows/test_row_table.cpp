#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "workbench/recording/csv.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/rows/cut_times.hpp"
#include "workbench/recording/rows/row_table.hpp"

namespace workbench {
namespace {

using Values = std::vector<double>;
const double kGap = std::nan("");

SignalRows signal(Column column, Values values) {
  SignalRows rows;
  rows.column = column;
  rows.name = column == Column::t ? "TI1" : std::string(name_of(column));
  rows.values = std::move(values);
  return rows;
}

class RowTables : public testing::Test {
 protected:
  void given(Values t, Values u, Values y) {
    table_.t = std::move(t);
    for (std::size_t i = 0; i < table_.t.size(); ++i) {
      table_.line.push_back(static_cast<std::uint32_t>(i + 2));
    }
    table_.signals = {signal(Column::u, std::move(u)), signal(Column::y, std::move(y))};
  }

  const std::string file_ = "f.csv";
  const std::vector<Column> required_ = {Column::u, Column::y};
  TableContext context_{file_, 1, required_};
  RowTable table_;
  ResampleReport report_;
};

TEST_F(RowTables, GapsHoldTheValueBefore) {
  given({0, 1, 2, 3}, {kGap, 1, kGap, 3}, {5, 6, 7, kGap});
  hold_values(table_, context_, report_);
  EXPECT_EQ(table_.t, (Values{1, 2, 3}));
  EXPECT_EQ(table_.signals[0].values, (Values{1, 1, 3}));
  EXPECT_EQ(table_.signals[1].values, (Values{6, 7, 7}));
  EXPECT_EQ(report_.empty_cells, 3U);
  EXPECT_EQ(report_.notes.size(), 2U);
}

TEST_F(RowTables, BadQualityIsAGapAndTooManyAreRefused) {
  given({0, 1, 2, 3}, {1, 2, 3, 4}, {5, 6, 7, 8});
  for (const char* cell : {"192", "0", "192", "192"}) {
    table_.signals[0].quality.push_back(table_.signals[0].scale.add(cell));
  }
  take_out_bad(table_, context_);
  EXPECT_TRUE(std::isnan(table_.signals[0].values[1]));
  EXPECT_EQ(table_.signals[0].bad, 1U);
  table_.signals[1].bad = 3;
  EXPECT_THROW(take_out_bad(table_, context_), InputError);
}

TEST_F(RowTables, ALoadThatBeginsLateIsLeftOut) {
  given({0, 1, 2, 3}, {1, 2, 3, 4}, {5, 6, 7, 8});
  table_.signals.push_back(signal(Column::t, {kGap, kGap, 1, 2}));
  hold_values(table_, context_, report_);
  EXPECT_EQ(table_.signals.size(), 2U);
  EXPECT_EQ(table_.t.size(), 4U);
  EXPECT_NE(report_.notes.at(0).find("'TI1' begins late"), std::string::npos);
}

TEST_F(RowTables, LoadsAndUnitsReachTheRecording) {
  given({0, 1, 2, 4}, {1, 2, 3, 4}, {5, 6, 7, 8});
  table_.signals[0].unit = "%";
  table_.signals.push_back(signal(Column::t, {6, 7, 8, 9}));
  Recording r;
  resample(std::move(table_), file_, r);
  EXPECT_EQ(r.unit(Column::u), "%");
  ASSERT_EQ(r.loads.size(), 1U);
  EXPECT_EQ(r.loads[0].values, (Values{6, 7, 8, 8, 9}));
}

TEST_F(RowTables, StampsCutToMinutesAreSpread) {
  given({0, 60, 60, 60, 60, 120, 120, 120, 120, 180}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9},
        {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  TimesOfRows times;
  times.dated = true;
  EXPECT_NE(spread_cut_times(table_, times), "");
  EXPECT_EQ(table_.t, (Values{45, 60, 75, 90, 105, 120, 135, 150, 165, 180}));
}

TEST_F(RowTables, OtherRepeatsAreNotSpread) {
  TimesOfRows times;
  times.dated = true;
  const auto unchanged = [&](const Values& t, const Values& u) {
    table_ = {};
    given(t, u, u);
    EXPECT_EQ(spread_cut_times(table_, times), "");
    EXPECT_EQ(table_.t, t);
  };
  unchanged({0, 0, 60, 60, 120, 120, 180, 180}, {1, 1, 2, 2, 3, 3, 4, 4});  // copies
  unchanged({0, 3, 3, 6, 9, 12, 12, 15, 18, 21, 24}, {1, 2, 2, 3, 4, 5, 5, 6, 7, 8, 9});
  unchanged({0, 0, 60, 60, 120, 120, 180, 180}, {1, kGap, 2, 3, 4, 5, 6, 7});
  unchanged({0, 0, 30, 30, 60, 60, 90, 90}, {1, 2, 3, 4, 5, 6, 7, 8});
  unchanged({0, 0, 60, 120, 120, 180, 180, 180, 180}, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  times.dated = false;
  unchanged({0, 0, 60, 60, 120, 120, 180, 180}, {1, 2, 3, 4, 5, 6, 7, 8});
}

TEST(RowTable, FractionsOfSecondsThatACommaCutOffAreRefused) {
  std::string text = "Time,OP,PV,\n";
  for (int k = 0; k < 40; ++k) {
    const std::string ms = std::to_string(k * 37 % 1000);
    text += "2026-05-13 14:30:" + std::to_string(10 + k) + ',' +
            std::string(3 - ms.size(), '0') + ms + ",4" + std::to_string(k % 9) + ".5,6" +
            std::to_string(k % 7) + ".5\n";
  }
  EXPECT_THROW((void)parse_csv(text, "a.csv"), InputError);
  CsvOptions options;
  options.decimal = '.';
  EXPECT_EQ(parse_csv(text, "a.csv", options).u[1], 37);
}

TEST(RowTable, DecimalsThatACommaCutOffAreRefused) {
  const auto text = [](const std::string& head) {
    std::string out = head + '\n';
    for (int k = 0; k < 40; ++k) {
      const std::string cents = std::to_string(k * 7 % 100);
      out += std::to_string(k) + ',' + "4" + std::to_string(k % 9) + ',' +
             (cents.size() < 2 ? "0" : "") + cents + ",60," + std::to_string(k % 10) +
             '\n';
    }
    return out;
  };
  for (const char* head : {"t,u,y,sp,x", "Time,OP,PV,SP,X", "Time,OP,PV,,"}) {
    try {
      (void)parse_csv(text(head), "a.csv");
      ADD_FAILURE() << head;
    } catch (const InputError& error) {
      EXPECT_EQ(error.line, 2U);
      EXPECT_EQ(error.found,
                "'00', which may be the decimals of a number before the comma");
    }
  }
  CsvOptions options;
  options.decimal = '.';
  EXPECT_EQ(parse_csv(text("Time,OP,PV,SP,X"), "a.csv", options).y[1], 7);
  EXPECT_EQ(parse_csv(text("Time,OP,PV,,") + "40,41.5,07,60,1\n", "a.csv").y[1], 7);
}

TEST_F(RowTables, KeepsQuestionableValuesAndSaysSo) {
  given({0, 1, 2}, {1, 2, 3}, {4, 5, 6});
  SignalRows& y = table_.signals[1];
  for (const char* cell : {"Good", "Uncertain", "Bad"}) {
    y.quality.push_back(y.scale.add(cell));
  }
  take_out_bad(table_, context_);
  EXPECT_EQ(y.values[1], 5);
  EXPECT_TRUE(std::isnan(y.values[2]));
  note_words(y, report_);
  ASSERT_EQ(report_.notes.size(), 1U);
  EXPECT_EQ(report_.notes[0], "1 value of 'y' marked as questionable: taken as they are");
}

}  // namespace
}  // namespace workbench
