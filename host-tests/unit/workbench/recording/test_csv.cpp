#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

#include "support/base/temporary_folder.hpp"
#include "workbench/recording/csv.hpp"

namespace workbench {
namespace {

using Values = std::vector<double>;

Recording parse(std::string_view text, const CsvOptions& options = {}) {
  return parse_csv(text, "rec.csv", options);
}

// The error a text must raise; an empty one when it reads.
InputError error_of(std::string_view text, const CsvOptions& options = {}) {
  try {
    static_cast<void>(parse(text, options));
  } catch (const InputError& error) {
    return error;
  }
  return {"no error", 0, 0, "", "", ""};
}

TEST(Csv, WithoutAHeaderTheLastColumnMayHoldWordsAndTheFirstASecondOf1970) {
  std::string rows;
  for (int k = 0; k < 12; ++k) {
    rows += std::to_string(1692576000 + 60 * k) + ',' + std::to_string(k % 5) + ',' +
            std::to_string(k % 3) + ",None\n";
  }
  CsvOptions options;
  options.names.u = "#2";
  options.names.y = "#3";
  const Recording r = parse(rows, options);
  EXPECT_EQ(r.size(), 12U);
  EXPECT_EQ(r.period_s, 60);
  EXPECT_EQ(r.start.substr(0, 16), "2023-08-21T00:00");
}

TEST(Csv, DoubtsSecondsThatNoRecorderIsSetTo) {
  const auto doubted = [](int step) {
    std::string text = "Tiempo,u,y\n";
    for (int k = 0; k < 5; ++k) text += std::to_string(50497 + step * k) + ",5,2\n";
    CsvOptions options;
    options.names.u = "u";
    options.names.y = "y";
    for (const std::string& note : parse(text, options).resampling.notes) {
      if (note.find("milliseconds") != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(doubted(12));
  EXPECT_FALSE(doubted(60));
}

TEST(Csv, TakesTheUnitOfANamedTimeColumnFromTheName) {
  CsvOptions options;
  options.required = {Column::u, Column::y};
  for (const auto& [name, last] :
       {std::pair("Ticks", 2000.0), std::pair("Ticks [ms]", 2.0),
        std::pair("#1 [ms]", 2.0), std::pair("#1 [min]", 120000.0)}) {
    options.names.time = name;
    const Recording r = parse("Ticks,u,y\n0,5,2\n1000,6,3\n2000,7,2\n", options);
    EXPECT_DOUBLE_EQ(r.t.back(), last) << name;
  }
}

TEST(Csv, RefusesColumnsWithTimesOfTheirOwnOfWhichNoneHasValues) {
  CsvOptions options;
  options.required.clear();
  options.names.loads = {"all"};
  const std::string row = ",1,2026-05-13 14:30:00,2\n";
  EXPECT_THROW(
      static_cast<void>(parse("Time,,Time,\n2026-05-13 14:30:00" + row +
                                  "2026-05-13 14:30:05,1,2026-05-13 14:30:05,2\n",
                              options)),
      InputError);
}

TEST(Csv, ReadsColumnsWithoutNamesByTheirNumbers) {
  CsvOptions options;
  options.required = {Column::u, Column::y};
  options.names.u = "#3";
  options.names.y = "#2";
  options.names.time = "#1";
  const Recording r = parse("0\t5\t2\n0.5\t6\t3\n1\t7\t2\n", options);
  EXPECT_EQ(r.y, (Values{5, 6, 7}));
  EXPECT_EQ(r.u, (Values{2, 3, 2}));
  EXPECT_EQ(r.t, (Values{0, 0.5, 1}));
  const InputError unnamed = error_of("0,5,2\n0.5,6,3\n1,7,2\n");
  EXPECT_NE(std::string(unnamed.what()).find("'#1' '#2' '#3'"), std::string::npos);
}

TEST(Csv, SaysAllThatAFileWithoutNamesNeeds) {
  std::string text;
  for (int k = 0; k < 12; ++k) {
    text += std::to_string(350 + 2 * k) + '\t' + std::to_string(k / 6) + '\t' +
            std::to_string(k * k) + "\t\n";
  }
  EXPECT_NE(error_of(text).advice.find("--time \"#1\" --u \"#2\" --y \"#3\""),
            std::string::npos);
  EXPECT_EQ(error_of(text).found.find("#4"), std::string::npos);
  // The sample period once, in a column of its own.
  const InputError period =
      error_of("uEst,yEst,Ts\n1,2,4\n2,3,\n1,4,\n3,4,\n3,5,\n1,2,\n1,3,\n2,3,\n");
  EXPECT_NE(period.advice.find("--ts SECONDS --u uEst --y yEst"), std::string::npos);
}

TEST(Csv, ReadsNamedColumnsInAnyOrderAndCase) {
  const Recording r = parse("PV,note,T,Op,SP,Pos\n1,a,0,2,3,4\n5,b,0.5,6,7,8\n");
  EXPECT_EQ(r.y, (Values{1, 5}));
  EXPECT_EQ(r.u, (Values{2, 6}));
  EXPECT_EQ(r.sp, (Values{3, 7}));
  EXPECT_EQ(r.x, (Values{4, 8}));
  EXPECT_EQ(r.t, (Values{0, 0.5}));
  EXPECT_EQ(r.period_s, 0.5);
  EXPECT_TRUE(r.resampling.notes.empty());
  EXPECT_FALSE(r.resampling.resampled);
}

TEST(Csv, MvIsTheValvePosition) {
  EXPECT_EQ(parse("t,u,y,MV\n0,1,2,3\n1,1,2,4\n").x, (Values{3, 4}));
}

TEST(Csv, AcceptsSeparatorsLineEndsMarkQuotesAndSpaces) {
  for (const std::string text : {
           "t,u,y\n0,1.5,2\n1,3,4\n",
           "t;u;y\r\n0;1,5;2\r\n1;3;4\r\n",
           "t\tu\ty\r0\t1,5\t2\r1\t3\t4",
           "\xEF\xBB\xBFt;u;y\n0;1.5;2\n1;3;4",
           "\"t\",\"u\",\"y\"\n\"0\",\"1.5\",\"2\"\n\"1\",\"3\",\"4\"\n",
           "  t , u ,y \n 0 , 1.5 , 2\t\n1 ,+3, 4 \n\n\r\n",
           "t,u,y\n0,15e-1,2\n1,3,4\n,,\n\n",
           "\nt,u,y\n0,1.5,2\n1,3,4\n",
           "t,u,y,\n0,1.5,2,\n1,3,4,\n",
       }) {
    SCOPED_TRACE(text);
    const Recording r = parse(text);
    EXPECT_EQ(r.t, (Values{0, 1}));
    EXPECT_EQ(r.u, (Values{1.5, 3}));
    EXPECT_EQ(r.y, (Values{2, 4}));
  }
}

TEST(Csv, GivenPeriodReplacesTheTimeColumn) {
  CsvOptions options;
  options.ts = 0.1;
  const Recording r = parse("t,u,y\n2020-01-01,1,2\n2020-01-01,3,4\n", options);
  EXPECT_EQ(r.period_s, 0.1);
  EXPECT_EQ(r.t, (Values{0, 0.1}));
  ASSERT_EQ(r.resampling.notes.size(), 1U);
  EXPECT_NE(r.resampling.notes[0].find("ignored"), std::string::npos);
  EXPECT_EQ(parse("u,y\n1,2\n3,4\n", options).u, (Values{1, 3}));
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    options.ts = bad;
    EXPECT_THROW(static_cast<void>(parse("u,y\n1,2\n3,4\n", options)),
                 std::invalid_argument);
  }
}

TEST(Csv, OneColumnIsEnoughWhereOnlyOneIsRequired) {
  CsvOptions options;
  options.ts = 1;
  options.required = {Column::u};
  EXPECT_EQ(parse("u\n1\n2\n3\n", options).u, (Values{1, 2, 3}));
  EXPECT_TRUE(parse("u\n1\n2\n3\n", options).y.empty());
}

TEST(Csv, ErrorsNameLineColumnExpectationFindingAndCure) {
  const InputError e = error_of("t,u,y\n0,1,2\n1,abc,4\n");
  EXPECT_EQ(e.line, 3U);
  EXPECT_EQ(e.column, 3U);
  EXPECT_STREQ(e.what(),
               "rec.csv:3:3: expected a number in column 'u', found 'abc'; repair the "
               "cell, or leave it empty if missing");
}

TEST(Csv, RefusesWhatIsNotANumber) {
  for (const std::string cell :
       {"abc", "1.2.3", "1,2", "nan", "NaN", "inf", "-inf", "+inf", "1e999", "0x10",
        "1 2", "--1", "+-1", "1e", "\"1,5\"", ".", "-", "1\\0"}) {
    SCOPED_TRACE(cell);
    const InputError e = error_of("t,u,y\n0,1,2\n1,3," + cell + "\n2,5,6\n");
    EXPECT_EQ(e.line, 3U) << e.what();
    EXPECT_GE(e.column, 5U) << e.what();
  }
  const std::string nul("t,u,y\n0,1,2\n1,3,4\0\n", 19);
  EXPECT_EQ(error_of(nul).line, 3U);
}

TEST(Csv, ASwitchMayBeTrueAndFalse) {
  EXPECT_EQ(parse("t,u,y\n0,False,1\n1,True,2\n2,true,3\n3,FALSE,4\n").u,
            (Values{0, 1, 1, 0}));
  EXPECT_EQ(parse("t,u,y\n0,0,1\n1,True,2\n2,,3\n3,0,4\n").u, (Values{0, 1, 1, 0}));
  EXPECT_EQ(error_of("t,u,y\n0,False,1\n1,35.5,2\n2,True,3\n").column, 3U);
  EXPECT_EQ(error_of("t,u,y\n0,35.5,1\n1,True,2\n2,30,3\n").column, 3U);
  EXPECT_EQ(error_of("t,u,y\n0,1,1\n1,2,False\n2,3,3\n").column, 5U);
}

TEST(Csv, TheDecimalMarkMayBeGiven) {
  const std::string text =
      "Zeit;OP;PV\n14.03.2026 08:00:00;4.498;60.028\n14.03.2026 08:00:05;4.496;60.037\n";
  CsvOptions options;
  options.decimal = '.';
  EXPECT_EQ(parse_csv(text, "f.csv", options).y, (std::vector<double>{60.028, 60.037}));
  options.decimal = ',';
  EXPECT_EQ(parse_csv(text, "f.csv", options).y, (std::vector<double>{60028, 60037}));
  EXPECT_THROW(parse_csv(text + "14.03.2026 08:00:10;4.5;60.028\n", "f.csv", options),
               InputError);
}

TEST(Csv, RefusesTwoDecimalMarksInOneFile) {
  EXPECT_EQ(error_of("t;u;y\n0;1.5;2\n1;1,234;4\n").line, 3U);
  EXPECT_EQ(error_of("t;u;y\n0;1;2\n1;1.234,5;4\n").line, 3U);
  EXPECT_EQ(error_of("t;u;y\n0;1;2\n1;1,234,5;4\n").line, 3U);
}

TEST(Csv, RefusesBadStructure) {
  EXPECT_EQ(error_of("").line, 1U);
  EXPECT_EQ(error_of("\n\n").line, 1U);
  EXPECT_NE(error_of("0,1,2\n1,3,4\n").found.find("without a header"), std::string::npos);
  EXPECT_NE(error_of("t,u\n0,1\n1,2\n").expected.find("PV"), std::string::npos);
  EXPECT_NE(error_of("u,y\n0,1\n1,2\n").advice.find("--ts"), std::string::npos);
  EXPECT_EQ(error_of("t,u,y,OP\n0,1,2,3\n1,1,2,3\n").column, 7U);
  EXPECT_EQ(error_of("t,u,y\n0,1\n1,2,3\n").line, 2U);
  EXPECT_EQ(error_of("t,u,y\n0,1,2\n1,2,3,4\n").line, 3U);
  EXPECT_EQ(error_of("t,u,y\n0,1,2\n\n1,2,3\n").line, 3U);
  EXPECT_EQ(error_of("t,u,y\n0,1,2\n1,\"2,3\n").line, 3U);
  EXPECT_EQ(error_of("t,u,y\n0,1,2\n1,\"2\"x,3\n").line, 3U);
  EXPECT_EQ(error_of("t,u,y\n0,1,2\n,2,3\n").line, 3U);
  EXPECT_EQ(error_of("t,u,y\n0,,2\n1,,3\n").line, 1U);
  EXPECT_NE(error_of("t,u,y\n").found.find("none"), std::string::npos);
  EXPECT_NE(error_of("t,u,y\n0,1,2\n").expected.find("at least 2"), std::string::npos);
  EXPECT_NE(error_of("t,u,y\n0,1,2\n0,1,2\n").expected.find("at least 2"),
            std::string::npos);
  EXPECT_NE(error_of("\xFF\xFEt\0").found.find("UTF-16"), std::string::npos);
}

TEST(Csv, TimeMustNotStepBack) {
  const InputError e = error_of("u,t,y\n1,0,2\n1,2,2\n1,1,2\n");
  EXPECT_EQ(e.line, 4U);
  EXPECT_EQ(e.column, 3U);
}

TEST(Csv, RepeatedTimeDropsTheLaterRowAndSaysSo) {
  const Recording r = parse("t,u,y\n0,1,2\n1,3,4\n1,30,40\n2,5,6\n");
  EXPECT_EQ(r.u, (Values{1, 3, 5}));
  EXPECT_EQ(r.resampling.repeated, 1U);
  EXPECT_EQ(r.resampling.rows, 4U);
  EXPECT_EQ(r.resampling.notes.size(), 1U);
}

TEST(Csv, RepeatedTimeSuppliesWhatTheFirstRowLacked) {
  const Recording r = parse("t,u,y\n0,1,\n0,,2\n1,3,\n1,,4\n2,5,\n2,,6\n");
  EXPECT_EQ(r.u, (Values{1, 3, 5}));
  EXPECT_EQ(r.y, (Values{2, 4, 6}));
  EXPECT_EQ(r.resampling.empty_cells, 0U);
}

TEST(Csv, MissingSamplesAreHeldAndCounted) {
  const Recording r = parse("t,u,y\n0,1,2\n1,3,4\n2,5,6\n5,7,8\n6,9,10\n");
  EXPECT_EQ(r.t, (Values{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(r.u, (Values{1, 3, 5, 5, 5, 7, 9}));
  EXPECT_EQ(r.resampling.missing, 2U);
  EXPECT_EQ(r.resampling.longest_gap_s, 3);
  EXPECT_TRUE(r.resampling.resampled);
  EXPECT_EQ(r.resampling.notes.size(), 1U);
}

TEST(Csv, IrregularSamplesAreResampledByZeroOrderHold) {
  const Recording r = parse("t,u,y\n0,1,0\n1,2,0\n2.5,3,0\n3,4,0\n4,5,0\n5,6,0\n6,7,0\n");
  EXPECT_EQ(r.period_s, 1);
  EXPECT_EQ(r.u, (Values{1, 2, 2, 4, 5, 6, 7}));
  EXPECT_EQ(r.resampling.irregular, 2U);
  EXPECT_EQ(r.resampling.missing, 1U);
}

TEST(Csv, RoundedTimeStampsDoNotDrift) {
  std::string text = "t,u,y\n";
  char line[64];
  for (int k = 0; k < 3000; ++k) {
    if (k > 500 && k < 640) continue;
    std::snprintf(line, sizeof line, "%.3f,%d,0\n", k / 3.0, k);
    text += line;
  }
  const Recording r = parse(text);
  ASSERT_EQ(r.size(), 3000U);
  EXPECT_NEAR(r.period_s, 1 / 3.0, 1e-6);
  EXPECT_EQ(r.u[500], 500);
  EXPECT_EQ(r.u[639], 500);
  EXPECT_EQ(r.u[640], 640);
  EXPECT_EQ(r.u[2999], 2999);
  EXPECT_EQ(r.resampling.missing, 139U);
  EXPECT_EQ(r.resampling.irregular, 0U);
}

TEST(Csv, EmptyCellsAreHeldAndLeadingIncompleteRowsDropped) {
  const Recording r = parse("t,u,y,sp\n0,,2,\n1,3,,5\n2,,6,\n3,7,8,9\n");
  EXPECT_EQ(r.t, (Values{1, 2, 3}));
  EXPECT_EQ(r.u, (Values{3, 3, 7}));
  EXPECT_EQ(r.y, (Values{2, 6, 8}));
  EXPECT_EQ(r.sp, (Values{5, 5, 9}));
  EXPECT_EQ(r.resampling.empty_cells, 5U);
}

TEST(Csv, AColumnWithoutValuesIsAbsent) {
  const Recording r = parse("t,u,y,sp\n0,1,2,\n1,3,4,\n");
  EXPECT_TRUE(r.sp.empty());
  EXPECT_EQ(r.resampling.empty_cells, 0U);
  EXPECT_EQ(r.resampling.notes.size(), 1U);
}

TEST(Csv, AHoleThatWouldExplodeTheRecordingIsRefused) {
  const InputError e = error_of("t,u,y\n0,1,2\n1,1,2\n2,1,2\n1e9,1,2\n");
  EXPECT_EQ(e.line, 5U);
  EXPECT_NE(e.found.find("gap"), std::string::npos);
}

TEST(Csv, ARecordingOfMostlyHeldSamplesIsRefused) {
  std::string text = "t,u,y\n0,1,2\n1,1,2\n2,1,3\n3,1,2\n4,2,2\n";
  EXPECT_EQ(parse(text + "9,1,2\n").size(), 10U);
  const InputError e = error_of(text + "13,1,2\n22,1,3\n31,1,2\n");
  EXPECT_EQ(e.line, 7U);
  EXPECT_EQ(e.found.rfind("24 of 32 instants without one", 0), 0U) << e.found;
}

TEST(Csv, ALongGapIsNotHeld) {
  const Recording r =
      parse("t,u,y\n0,1,2\n1,1,2\n2,1,3\n3,1,2\n4,2,2\n5,1,2\n40,1,2\n41,1,3\n");
  ASSERT_EQ(r.resampling.gaps.size(), 1U);
  EXPECT_EQ(r.resampling.gaps[0].first, 6U);
  EXPECT_EQ(r.resampling.gaps[0].last, 40U);
  EXPECT_EQ(r.resampling.missing, 34U);
}

TEST(Csv, NumbersWithoutAUnitADayApartAreNoSeconds) {
  const InputError e = error_of("Timestamp,OP,PV\n0,1,2\n5000000,1,3\n10000000,2,2\n");
  EXPECT_EQ(e.line, 2U);
  EXPECT_NE(e.advice.find("t [us]"), std::string::npos) << e.what();
  EXPECT_EQ(parse("t [us],u,y\n0,1,2\n5000000,1,3\n").period_s, 5);
  EXPECT_EQ(parse("t [s],u,y\n0,1,2\n5000000,1,3\n").period_s, 5e6);
  EXPECT_EQ(error_of("t,u,y\n0,1,2\n1e-6,1,3\n2e-6,1,3\n").line, 2U);
}

TEST(Csv, AUnitAloneNamesATime) {
  EXPECT_EQ(parse("millis,OP,PV\n0,1,2\n5000,1,3\n10000,1,3\n").period_s, 5);
  EXPECT_EQ(parse("Microseconds,OP,PV\n0,1,2\n5000,1,3\n10000,1,3\n").period_s, 0.005);
  EXPECT_EQ(parse("time (millisec),OP,PV\n0,1,2\n500,1,3\n").period_s, 0.5);
}

TEST(Csv, ThousandsThatAColumnRunsAcrossAreRefused) {
  for (const char* thousand : {"1.002", "1,002"}) {
    const std::string text = "Time;OP;PV\n2026-05-13 14:30:00;1;996\n";
    const InputError e = error_of(text + "2026-05-13 14:30:05;2;" + thousand + '\n' +
                                  "2026-05-13 14:30:10;2;998\n");
    EXPECT_EQ(e.line, 3U);
    EXPECT_NE(e.expected.find("one meaning"), std::string::npos) << e.what();
  }
  const std::string german =
      "Zeit;OP;PV\n13.05.2026 14:30:00;59;4.508\n13.05.2026 14:30:05;58;4.668\n";
  EXPECT_EQ(error_of(german).line, 2U);
  EXPECT_EQ(parse("Time;OP;PV\n2026-05-13 14:30:00;59;4.508\n"
                  "2026-05-13 14:30:05;58;4.668\n")
                .y,
            (Values{4.508, 4.668}));
}

TEST(Csv, AFewUnknownWordsAreGapsAndListed) {
  std::string text = "Time,OP,PV\n";
  for (int k = 0; k < 20; ++k) {
    text += std::to_string(k) + ",1," + (k == 7 ? "Stale" : std::to_string(k)) + '\n';
  }
  const Recording r = parse(text);
  EXPECT_EQ(r.y[7], 6);
  EXPECT_NE(r.resampling.notes.front().find("'Stale' 1"), std::string::npos);
  EXPECT_EQ(error_of("Time,OP,PV\n0,1,2\n1,1,Stale\n2,1,3\n").line, 3U);
}

TEST(Csv, ANameForNoCellIsLeftOut) {
  std::string text = "t,u,y,P,I\n";
  for (int k = 0; k < 6; ++k)
    text += std::to_string(k) + ",1," + std::to_string(k) + '\n';
  const Recording r = parse(text);
  EXPECT_EQ(r.y[3], 3);
  EXPECT_EQ(r.resampling.notes.size(), 1U);
  EXPECT_EQ(error_of(text + "6,1\n").line, 2U);
}

TEST(Csv, AMessageSaysThatNamesAreLeftOut) {
  std::string text = "time,round,status,kp,ki,warmth\n";
  for (int k = 0; k < 12; ++k) text += std::to_string(k) + ",3,0.5,7,42\n";
  EXPECT_NE(error_of(text).found.find("(the header has 6 names, each row 5 cells"),
            std::string::npos)
      << error_of(text).found;
}

// As a table is written whose index has no name.
TEST(Csv, AColumnWithoutANameIsCalledByItsNumber) {
  std::string text = ",rest,press\n";
  for (int k = 0; k < 12; ++k) text += std::to_string(k) + ",1.5,42\n";
  EXPECT_NE(error_of(text).advice.find("--time \"#1\""), std::string::npos)
      << error_of(text).advice;
  CsvOptions options;
  options.names.u = "rest";
  options.names.y = "press";
  EXPECT_NE(error_of(text, options).advice.find("--time \"#1\""), std::string::npos)
      << error_of(text, options).advice;
}

TEST(Csv, OneColumnIsSaidToBeOne) {
  EXPECT_EQ(error_of("73.1\n73.2\n73.3\n").found, "a single column");
}

TEST(Csv, TimesThatCannotTellSamplesApartAreRefused) {
  EXPECT_FALSE(error_of("t,u,y\n0,1,2\n1e-300,1,2\n2e-300,1,2\n").expected.empty());
  EXPECT_FALSE(
      error_of("t,u,y\n1e17,1,2\n1.00000000000000016e17,1,2\n").expected.empty());
  EXPECT_FALSE(error_of("t,u,y\n-1.7e308,1,2\n1.7e308,1,2\n").expected.empty());
}

TEST(Csv, UnitsBehindNumbersAreTheSameInAColumn) {
  const Recording r = parse("Time,OP,PV\n2 sec,1 %,980 mbar\n4 sec,2 %,981 mbar\n");
  EXPECT_EQ(r.y, (std::vector<double>{980, 981}));
  EXPECT_EQ(r.period_s, 2);
  EXPECT_EQ(r.units[static_cast<std::size_t>(Column::y)], "mbar");
  const InputError mixed =
      error_of("Time,OP,PV\n0 sec,1 %,980 mbar\n1 sec,2 %,1.2 psi\n2 sec,2 %,1 psi\n");
  EXPECT_EQ(mixed.line, 3U);
  EXPECT_NE(mixed.expected.find("'mbar'"), std::string::npos) << mixed.what();
  EXPECT_EQ(mixed.found, "'1.2 psi'");
  EXPECT_EQ(error_of("Time,OP,PV\n0,1,980 mbar\n1,2,981\n2,2,981\n").line, 3U);
}

TEST(Csv, MissingFileAndFolderAreNamed) {
  EXPECT_THROW(static_cast<void>(read_csv("/nonexistent/rec.csv")), InputError);
  EXPECT_THROW(static_cast<void>(read_csv("/")), InputError);
}

TEST(Csv, ReadsAFileAndNamesTheRecordingAfterIt) {
  const TemporaryFolder folder;
  const std::string path = folder.file("rec.csv");
  std::ofstream(path) << "t,u,y\n0,1,2\n1,3,4\n";
  EXPECT_EQ(read_csv(path).name, "rec.csv");
}

TEST(Csv, SomeColumnsBeginLateAndOthersPause) {
  std::string rows = "t,u,y\n";
  for (int k = 0; k < 400; ++k) {
    const std::string u = k >= 50 && k < 300 ? "" : std::to_string(k % 7);
    rows += std::to_string(k) + ',' + u + ',' +
            (k < 320 ? std::string() : std::to_string(k % 5)) + '\n';
  }
  const Recording r = parse(rows);
  ASSERT_EQ(r.size(), 80U);
  EXPECT_EQ(r.u.front(), 320 % 7);
  EXPECT_EQ(r.y.back(), 399 % 5);
}

TEST(Csv, NamesAClockOfTwelveHours) {
  const InputError error = error_of(
      "Time,OP,PV\n2026-03-17 12:59:58,1,2\n2026-03-17 12:59:59,2,3\n"
      "2026-03-17 01:00:00,3,4\n2026-03-17 01:00:01,4,5\n");
  EXPECT_NE(error.advice.find("AM and PM"), std::string::npos) << error.advice;
}

TEST(Csv, TagsOfOneOpenDayAreReadOfTwoAsked) {
  const auto text = [](const char* other) {
    std::string out = "Tag,Time,Value\n";
    for (const char* second : {"10", "11", "12"}) {
      out += std::string("FIC101.OP,03/04/2026 08:00:") + second + ",4.5\nFIC101.PV," +
             other + " 08:00:" + second + ",6.5\n";
    }
    return out;
  };
  const Recording one = parse(text("03/04/2026"));
  EXPECT_EQ(one.size(), 3U);
  EXPECT_EQ(one.start, "");
  EXPECT_NE(error_of(text("04/03/2026")).advice.find("--date-order"), std::string::npos);
}

TEST(Csv, ReadsACellBehindTheLastNameByItsNumber) {
  std::string text = "Time (s),Set,Current\n";
  for (int k = 0; k < 12; ++k)
    text += std::to_string(k) + ",1.5,2.5," + std::to_string(k % 4) + ",4.5\n";
  CsvOptions options;
  options.names.u = "#4";
  options.names.y = "Current";
  EXPECT_EQ(parse(text, options).u[3], 3);
  EXPECT_NE(error_of(text).found.find("'#5'"), std::string::npos) << error_of(text).found;
}

}  // namespace
}  // namespace workbench
