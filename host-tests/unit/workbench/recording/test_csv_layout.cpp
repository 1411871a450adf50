#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "workbench/recording/column_choice.hpp"
#include "workbench/recording/csv_layout.hpp"
#include "workbench/recording/input_error.hpp"

namespace workbench {
namespace {

const std::vector<Column> kRequired = {Column::t, Column::u, Column::y};

CsvLayout layout(const std::string& text) {
  return layout_of(text, "f.csv", {kRequired, {}});
}

ColumnNames u_named(const std::string& u) {
  ColumnNames names;
  names.u = u;
  return names;
}

ColumnNames at_time(const std::string& name) {
  ColumnNames names;
  names.time = name;
  return names;
}

ColumnChoice choice(const std::string& text, const ColumnNames& names = {}) {
  return choose_columns(layout(text), "f.csv", names, {Column::u, Column::y}, true);
}

std::string names_of(const CsvLayout& l) {
  std::string text;
  for (const LayoutColumn& c : l.columns) {
    text += (text.empty() ? "" : " ") + c.name.text + '[' + c.name.unit + ']';
  }
  return text;
}

std::string rows_of(const std::string& row) {
  std::string text;
  for (int k = 1; k <= 6; ++k) text += std::to_string(k) + row;
  return text;
}

TEST(CsvLayout, UnitsMayLookLikeNames) {
  const std::string file = "a.csv";
  std::string text = "Number,Date&Time,ms,CH1,CH2\nNO.,Time,ms,degC,V\n";
  for (int i = 10; i < 40; ++i) {
    text += std::to_string(i) + ",2026/05/13 06:00:" + std::to_string(i) + ",000,+4" +
            std::to_string(i % 7) + ",+6" + std::to_string(i % 5) + '\n';
  }
  const CsvLayout layout = layout_of(text, file, {{Column::u, Column::y}, {}});
  EXPECT_EQ(layout.header_line, 1U);
  ASSERT_EQ(layout.columns.size(), 5U);
  EXPECT_EQ(layout.columns[3].name.text, "CH1");
  EXPECT_EQ(layout.columns[3].name.unit, "degC");
}

TEST(CsvLayout, RowsMayNameTheirOwnNumbers) {
  EXPECT_EQ(names_of(layout(rows_of(";A.OP;1.5;A.PV;2.5;\n"))),
            "#1[] #2[] A.OP[] #4[] A.PV[]");
  EXPECT_EQ(names_of(layout(rows_of(";A.OP;1.5\n"))), "#1[] #2[] #3[]");
}

TEST(CsvLayout, NamesRepeatedStandUnderTheLineOfTags) {
  std::string text =
      "Point Name,10FIC1.UNIT1@NET0,10FIC1-OUT.UNIT1@NET0\nUnits,T/H,PCT\n"
      "Timestamp,F_CV,F_CV\n";
  for (int k = 10; k < 20; ++k) {
    text += "03/14/2026 08:00:" + std::to_string(k) + ".000,60.1 G,45.2 G\n";
  }
  const CsvLayout l = layout(text);
  EXPECT_EQ(l.columns[2].name.part, Part::kU);
  EXPECT_EQ(l.columns[2].name.tag, "10fic1");
  EXPECT_EQ(l.columns[1].content, Content::kNumber);
}

TEST(CsvLayout, NamesFewerThanCellsStandOverWhatTheyName) {
  EXPECT_EQ(names_of(layout("\"time\" \"OP\" \"PV\"\n" +
                            rows_of(" \"2026-03-14 08:00:00\" 1.5 2.5\n"))),
            "[] time[] OP[] PV[]");
  EXPECT_EQ(
      names_of(layout("  time  OP PV\n" + rows_of(" 2026-03-14 08:00:00 1.5 2.5\n"))),
      "[] time[] [] OP[] PV[]");
  // A column more behind the last name may be it.
  EXPECT_EQ(names_of(layout("time OP PV\n" + rows_of(" 1.5 2.5 3.5\n"))),
            "time[] OP[] PV[] #4[]");
}

TEST(CsvLayout, TellsSeparatorsByTheRows) {
  EXPECT_EQ(layout("Zeit;OP;PV\n01.05.2026 10:00;1,5;2,5\n01.05.2026 10:01;1,5;2,5\n")
                .separator,
            ';');
  EXPECT_EQ(layout("Time|OP|PV\n1|2|3\n2|2|3\n").separator, '|');
  EXPECT_EQ(layout("Time\tOP\tPV\n1\t2,5\t3,5\n2\t2,5\t3,5\n").separator, '\t');
  EXPECT_EQ(layout("sep=;\nTime;OP;PV\n1;2,5;3\n2;2,5;3\n").separator, ';');
}

TEST(CsvLayout, FindsHeaderUnitsAndFirstRowUnderAPreamble) {
  const CsvLayout l = layout(
      "Trend export\nFrom;01.05.2026 10:00\n\nZeit;FIC1.OP;FIC1.PV\n;%;m3/h\n"
      "01.05.2026 10:00;1;2\n01.05.2026 10:01;1;2\n");
  EXPECT_EQ(l.header_line, 4U);
  EXPECT_EQ(l.first_row_line, 6U);
  EXPECT_EQ(names_of(l), "Zeit[] FIC1.OP[%] FIC1.PV[m3/h]");
  EXPECT_EQ(l.columns[0].content, Content::kDateTime);
  EXPECT_EQ(l.columns[1].content, Content::kNumber);
  EXPECT_FALSE(l.contract_names);
}

TEST(CsvLayout, PutsMergedHeadsInFront) {
  EXPECT_EQ(names_of(layout(",A.OP,,A.PV,\nTime,Value,Status,Value,Status\n"
                            "1,2,Good,3,Good\n2,2,Good,3,Good\n")),
            "Time[] A.OP Value[] A.OP Status[] A.PV Value[] A.PV Status[]");
}

TEST(CsvLayout, TheContractsNamesInTheFirstLineAreTheHeader) {
  const CsvLayout l = layout("t,u,y\ns,%,bar\nabc,1,2\n");
  EXPECT_TRUE(l.contract_names);
  EXPECT_EQ(l.first_row_line, 3U);
  EXPECT_EQ(l.columns[2].name.unit, "bar");
  EXPECT_EQ(layout("t,u,y\n\n1,2,3\n").first_row_line, 2U);
}

TEST(CsvLayout, WithoutNamesColumnsHaveNumbers) {
  const CsvLayout l = layout("0,1,2\n1,3,4\n");
  EXPECT_EQ(names_of(l), names_of(layout("#1,#2,#3\n0,1,2\n1,3,4\n")));
  EXPECT_EQ(l.first_row_line, 1U);
  EXPECT_EQ(l.first_row_offset, 0U);
  EXPECT_THROW(static_cast<void>(layout("\n\n")), InputError);
}

TEST(CsvLayout, NamesThatFillTheColumnsAreBelowThoseOfAPreamble) {
  std::string text =
      "Channel\tType\tUnit\tName\nOP\tDBL\t%\tOP\nPV\tDBL\tbar\tPV\n\n"
      "OP\tPV\n";
  for (int i = 10; i < 30; ++i) text += "4.5" + std::to_string(i) + "\t6.1\n";
  EXPECT_EQ(names_of(layout(text)), "OP[] PV[]");
}

TEST(ColumnChoice, TimesThatCannotBeReadAreTold) {
  try {
    choice("Time,A.OP,A.PV\n#####,4.1,6.1\n#####,4.2,6.2\n#####,4.4,6.1\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.expected, "times in column 'Time'");
    EXPECT_EQ(error.found, "'#####'");
  }
}

TEST(ColumnChoice, FindsTimesByContentAndName) {
  EXPECT_EQ(choice("id,Stamp,OP,PV\n1,2026-05-03 10:00,2,3\n2,2026-05-03 10:01,2,3\n")
                .times[0]
                .column,
            1U);
  const ColumnChoice two =
      choice("Date,Time,OP,PV\n2026-05-03,10:00,2,3\n2026-05-03,10:01,2,3\n");
  EXPECT_EQ(two.times[0].column, 0U);
  EXPECT_EQ(two.times[0].clock, 1U);
  EXPECT_EQ(choice("OP,PV,t [min]\n2,3,1\n2,3,2\n").times[0].unit_s, 60);
  EXPECT_EQ(choice("Local,UTC,OP,PV\n2026-05-03 12:00,2026-05-03 10:00,2,3\n"
                   "2026-05-03 12:01,2026-05-03 10:01,2,3\n",
                   at_time("utc"))
                .times[0]
                .column,
            1U);
  EXPECT_THROW(static_cast<void>(choice("OP,PV\n2,3\n2,4\n")), InputError);
}

TEST(ColumnChoice, TellsTheShapes) {
  using Shape = ColumnChoice::Shape;
  EXPECT_EQ(choice("Time,OP,PV\n1,2,3\n2,2,3\n").shape, Shape::kWide);
  EXPECT_EQ(
      choice("tag,time,value\nA.OP,2026-05-03 10:00,2\nA.PV,2026-05-03 10:00,2\n").shape,
      Shape::kLong);
  EXPECT_EQ(choice("Time,A.OP,Time,A.PV\n2026-05-03 10:00,2,2026-05-03 10:00,2\n").shape,
            Shape::kOwnTimes);
  EXPECT_EQ(choice("Local,UTC,OP,PV\n2026-05-03 12:00,2026-05-03 10:00,2,3\n").shape,
            Shape::kWide);
}

TEST(ColumnChoice, OnlyBareNamesAndSecondsArePlain) {
  EXPECT_TRUE(choice("t,op,pv\n1,2,3\n2,2,3\n").plain);
  EXPECT_FALSE(choice("Time,op,pv\n1,2,3\n2,2,3\n").plain);
  EXPECT_FALSE(choice("t,op,pv\n2026-05-03 10:00,2,3\n2026-05-03 10:01,2,3\n").plain);
  EXPECT_FALSE(choice("t,u,y\n1,2,3\n2,2,3\n", u_named("u")).plain);
}

TEST(ColumnChoice, QualitiesBelongToTheirSignal) {
  const auto qualities = [](const std::string& header) {
    const ColumnChoice c = choice(header + "\n1,2,Good,3,Good\n2,2,Good,3,Good\n");
    return std::pair(c.signals[0].quality, c.signals[1].quality);
  };
  using Pair = std::pair<std::optional<std::size_t>, std::optional<std::size_t>>;
  EXPECT_EQ(qualities("Time,A.OP,Quality,A.PV,Quality"), Pair(2, 4));
  EXPECT_EQ(qualities("Time,A.OP,A.PV.Status,A.PV,A.OP.Status"), Pair(4, 2));
  EXPECT_EQ(qualities("Time,A.OP,Note,A.PV,Quality"), Pair(4, 4));
}

TEST(CsvLayout, ALineMayBreakWithinQuotes) {
  const CsvLayout found = layout(
      "Time,\"A.OP\n(%)\",\"A.PV\r\n(m3/h)\"\n2026-05-03 10:00,1,2\n"
      "2026-05-03 10:01,1,2\n");
  ASSERT_EQ(found.columns.size(), 3U);
  EXPECT_EQ(found.columns[1].name.tag, "a");
  EXPECT_EQ(found.columns[1].name.unit, "%");
  EXPECT_EQ(found.columns[2].name.unit, "m3/h");
  EXPECT_EQ(found.first_row_line, 4U);
}

TEST(ColumnChoice, AColumnQOfFlowsIsNoQuality) {
  const auto quality = [](const std::string& a, const std::string& b) {
    return choice("Time,OP,PV,Q\n1,2,3," + a + "\n2,2,3," + b + "\n").signals[0].quality;
  };
  EXPECT_EQ(quality("192", "0"), 3U);
  EXPECT_EQ(quality("G", "B"), 3U);
  EXPECT_FALSE(quality("37.5", "38.1"));
  EXPECT_FALSE(quality("150", "0"));
}

TEST(ColumnChoice, MillisecondsBesideSeconds) {
  const auto millis = [](const std::string& rows) {
    return choice("Seconds,Milliseconds,OP,PV\n" + rows).times.at(0).millis;
  };
  EXPECT_EQ(millis("0,0,1,2\n0,500,1,2\n1,0,1,2\n1,500,1,2\n2,0,1,2\n"), 1U);
  EXPECT_FALSE(millis("0,0,1,2\n1,1000,1,2\n2,2000,1,2\n3,3000,1,2\n4,4000,1,2\n"));
}

TEST(ColumnChoice, UnitsOfTimeThatTheUserSaysOrNobodyKnows) {
  const TimePlace given =
      choice("Count,OP,PV\n1,2,3\n2,2,3\n", at_time("Count [min]")).times.at(0);
  EXPECT_EQ(given.unit_s, 60);
  EXPECT_TRUE(given.unit_given);
  const TimePlace open = choice("Time (10ms),OP,PV\n1,2,3\n2,2,3\n").times.at(0);
  EXPECT_EQ(open.unit_s, 0);
  EXPECT_EQ(open.unknown_unit, "'10ms'");
  EXPECT_EQ(choice("TimeMs,OP,PV\n1,2,3\n2,2,3\n", at_time("TimeMs")).times.at(0).unit_s,
            1e-3);
}

TEST(ColumnChoice, ATagThatChangesBehindTheFirstRowsIsAKey) {
  const auto keys = [](const std::string& second) {
    std::string text = "tag,Time,OP,PV\n";
    for (int i = 0; i < 400; ++i) {
      text += (i < 200 ? "A," : second + ',') + std::to_string(i) + ",1,2\n";
    }
    return choice(text).keys;
  };
  EXPECT_EQ(keys("B"), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(keys("A").empty());
}

TEST(ColumnChoice, ADateAtMidnightHasItsClockBesideIt) {
  const TimePlace time =
      choice(
          "Date,Time,OP,PV\n2026-05-03 00:00:00,10:00:00,2,3\n"
          "2026-05-03 00:00:00,10:00:01,2,3\n2026-05-03 00:00:00,10:00:02,2,3\n")
          .times.at(0);
  EXPECT_EQ(time.column, 0U);
  EXPECT_EQ(time.clock, 1U);
}

TEST(CsvLayout, CommasOfNumbersSeparateNothingBelowALineWithoutNames) {
  for (const char* first : {"", "Interval: 500 ms\n", "Rate 2 Hz\n"}) {
    std::string text = std::string(first) + "Stellgrad;Istwert\n";
    for (int i = 0; i < 30; ++i) text += "52," + std::to_string(i % 10) + ";110,4\n";
    const CsvLayout layout = layout_of(text, "f.csv", {{Column::t, Column::u}, {}});
    EXPECT_EQ(layout.separator, ';') << first;
    ASSERT_EQ(layout.columns.size(), 2U) << first;
    EXPECT_EQ(layout.columns[1].name.text, "Istwert") << first;
  }
}

}  // namespace
}  // namespace workbench
