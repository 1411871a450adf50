#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/workbench/column_names.hpp"
#include "workbench/recording/csv.hpp"

namespace workbench {
namespace {

using Values = std::vector<double>;

Recording parse_streams(const std::string& text, const CsvOptions& options = {}) {
  return parse_csv(text, "f.csv", options);
}

TEST(TagStreams, WholeNumbersMayStandInAColumnOfTheirOwn) {
  std::string text = "tagpath,intvalue,floatvalue,t_stamp\n";
  std::string nameless;
  for (int i = 0; i < 20; ++i) {
    const std::string t = std::to_string(1773475200000 + 1000 * i);
    text += "a/op,null,4" + std::to_string(i) + ".5," + t + "\na/pv,6" +
            std::to_string(i) + ",null," + t + '\n';
    const std::string stamp = "2026-05-13 06:00:" + std::to_string(10 + i);
    nameless += "A.OP;" + stamp + ";4" + std::to_string(i) + ";0\nA.PV;" + stamp + ";6" +
                std::to_string(i) + ";0\n";
  }
  const Recording r = parse_streams(text);
  EXPECT_EQ(r.u[0], 40.5);
  EXPECT_EQ(r.y[0], 60);
  // Without a header the zeros of all rows are their states.
  const Recording states = parse_streams(nameless);
  EXPECT_EQ(states.u[0], 40);
  EXPECT_EQ(states.y[19], 619);
}

TEST(TagStreams, RowsOfAnyOrderAreSortedByTag) {
  const Recording r = parse_streams(
      "tag,time,value\nA.PV,2026-05-03 10:00:01,6\nA.OP,2026-05-03 10:00:00,1\n"
      "A.PV,2026-05-03 10:00:00,5\nA.OP,2026-05-03 10:00:02,3\n"
      "TI7,2026-05-03 10:00:00,9\nA.PV,2026-05-03 10:00:02,7\nA.OP,2026-05-03 "
      "10:00:01,2\n");
  EXPECT_EQ(r.t, (Values{0, 1, 2}));
  EXPECT_EQ(r.u, (Values{1, 2, 3}));
  EXPECT_EQ(r.y, (Values{5, 6, 7}));
  EXPECT_EQ(r.start, "2026-05-03T10:00:00");
}

TEST(TagStreams, SignalsMayShareTheirTimesWhereOthersHaveTheirOwn) {
  const Recording r = parse_streams(
      "Timestamp;FIC101.OP;FIC101.PV;Timestamp;FIC101.SP\n0;1;5;0;4\n1;2;6;1;4\n"
      "2;3;7;2;5\n");
  EXPECT_EQ(r.u, (Values{1, 2, 3}));
  EXPECT_EQ(r.y, (Values{5, 6, 7}));
  EXPECT_EQ(r.sp, (Values{4, 4, 5}));
}

TEST(TagStreams, OwnTimesMeetOnOneGrid) {
  const Recording r = parse_streams(
      "time,name,value\n0,A.OP,1\n0.3,A.PV,10\n1,A.OP,2\n2,A.OP,3\n2.3,A.PV,20\n3,A.OP,"
      "4\n"
      "4,A.OP,5\n4.3,A.PV,30\n5,A.OP,6\n");
  EXPECT_EQ(r.period_s, 1);
  EXPECT_EQ(r.t.front(), 0.3);
  EXPECT_EQ(r.u, (Values{1, 2, 3, 4, 5}));
  EXPECT_EQ(r.y, (Values{10, 10, 20, 20, 30}));
  EXPECT_TRUE(r.resampling.resampled);
}

TEST(TagStreams, TagsAreNamedAsColumnsAre) {
  const std::string text =
      "tag,time,value\nLV1,0,1\nFT1,0,5\nTI1,0,7\nLV1,1,2\nFT1,1,6\nTI1,1,8\n";
  CsvOptions options;
  options.names = test::named("lv1", "#2", {"all"});
  const Recording r = parse_streams(text, options);
  EXPECT_EQ(r.u, (Values{1, 2}));
  EXPECT_EQ(r.y, (Values{5, 6}));
  ASSERT_EQ(r.loads.size(), 1U);
  EXPECT_EQ(r.loads[0].name, "TI1");
  EXPECT_EQ(r.loads[0].values, (Values{7, 8}));
  options.names.u = "LV9";
  EXPECT_THROW(static_cast<void>(parse_streams(text, options)), std::invalid_argument);
  try {
    static_cast<void>(parse_streams(text));
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(error.found.find("the tags 'LV1' 'FT1' 'TI1'"), std::string::npos);
  }
}

TEST(TagStreams, BadSamplesHoldTheOneBefore) {
  const Recording r = parse_streams(
      "tag,time,value,status\nA.OP,0,1,Good\nA.PV,0,5,Good\nA.OP,1,2,Good\nA.PV,1,0,Bad\n"
      "A.OP,2,3,Good\nA.PV,2,7,Good\n");
  EXPECT_EQ(r.y, (Values{5, 5, 7}));
  EXPECT_EQ(r.resampling.empty_cells, 1U);
}

TEST(TagStreams, ColumnsInPairsHaveTheirOwnTimes) {
  const Recording r = parse_streams(
      "A.OP Time;A.OP;A.PV Time;A.PV\n"
      "03.05.2026 10:00:00;1,5;03.05.2026 10:00:00;5\n"
      "03.05.2026 10:00:01;2,5;03.05.2026 10:00:02;6\n"
      "03.05.2026 10:00:02;3,5;;\n");
  EXPECT_EQ(r.u, (Values{1.5, 2.5, 3.5}));
  EXPECT_EQ(r.y, (Values{5, 5, 6}));
}

TEST(TagStreams, ATagThatIsSilentForLongIsNotHeld) {
  std::string text = "time,name,value\n";
  for (int k = 0; k < 400; ++k) {
    const double wave = std::sin(k / 5.0);
    text += std::to_string(k) + ",A.OP," + std::to_string(wave) + '\n';
    if (k < 150 || k >= 210) {
      text += std::to_string(k) + ",A.PV," + std::to_string(wave) + '\n';
    }
  }
  const Recording r = parse_streams(text);
  ASSERT_EQ(r.resampling.gaps.size(), 1U);
  EXPECT_EQ(r.resampling.gaps[0].first, 150U);
  EXPECT_EQ(r.resampling.gaps[0].last, 210U);
  EXPECT_NE(r.resampling.notes.at(1).find("without a value of 'A.PV'"),
            std::string::npos);
}

TEST(TagStreams, ParametersMayHaveAColumnOfTheirOwn) {
  std::string text = "Point,Parameter,Timestamp,Value\n";
  for (const char* second : {"00", "01"}) {
    for (const char* point : {"FIC1", "FIC2"}) {
      for (const char* parameter : {"OP", "PV"}) {
        text += std::string(point) + ',' + parameter + ",2026-05-03 10:00:" + second +
                ',' + (point[3] == '1' ? "1" : "2") + (parameter[0] == 'O' ? "0" : "5") +
                '\n';
      }
    }
  }
  CsvOptions options;
  options.names.u = "FIC2.OP";
  options.names.y = "FIC2.PV";
  const Recording r = parse_streams(text, options);
  EXPECT_EQ(r.u, (Values{20, 20}));
  EXPECT_EQ(r.y, (Values{25, 25}));
}

TEST(TagStreams, RowsWithoutTimesAreCountedByTag) {
  std::string rows = "loop,out,pv\n";
  for (int k = 0; k < 6; ++k) {
    const std::string at = std::to_string(k);
    rows += "A,1" + at + ",2" + at + "\nB,3" + at + ",4" + at + '\n';
  }
  CsvOptions options;
  options.names.u = "B.out";
  options.names.y = "B.pv";
  EXPECT_THROW((void)parse_streams(rows, options), InputError);
  options.ts = 0.5;
  const Recording r = parse_streams(rows, options);
  EXPECT_EQ(r.t, (Values{0, 0.5, 1, 1.5, 2, 2.5}));
  EXPECT_EQ(r.u, (Values{30, 31, 32, 33, 34, 35}));
  EXPECT_EQ(r.y, (Values{40, 41, 42, 43, 44, 45}));
  options.names.y = "A.pv";
  for (int k = 0; k < 100; ++k) rows += "A,1,2\nB,3,4\n";
  EXPECT_EQ(parse_streams(rows, options).t.size(), 106U);
  EXPECT_THROW((void)parse_streams(rows + "B,3,4\n", options), InputError);
}

TEST(TagStreams, TheOnlyOtherTagIsTheMeasuredOne) {
  const Recording r = parse_streams(
      "entity_id,state,last_changed\ns.out,1,2026-05-03 10:00:00\n"
      "s.room,5,2026-05-03 10:00:00\ns.mode,heat,2026-05-03 10:00:00\n"
      "s.out,2,2026-05-03 10:00:01\ns.room,6,2026-05-03 10:00:01\n");
  EXPECT_EQ(r.y, (Values{5, 6}));
  EXPECT_NE(r.resampling.notes.at(0).find("y 's.room'"), std::string::npos);
}

TEST(TagStreams, TagsWithoutCommonTimeAreRefused) {
  EXPECT_THROW(static_cast<void>(parse_streams("tag,time,value\nA.OP,0,1\nA.OP,1,1\n"
                                               "A.PV,1000000,5\nA.PV,1000001,5\n")),
               InputError);
  EXPECT_THROW(
      static_cast<void>(parse_streams("tag,time,value\nA.OP,0,1\nA.OP,1,1\nA.PV,0,5\n")),
      InputError);
}

TEST(TagStreams, ATagHasOneUnit) {
  const std::string text =
      "tag,time,value,unit\nA.OP,0,1,%\nA.PV,0,5,m3/h\nA.OP,1,2,%\nA.PV,1,6,m3/h\n"
      "A.OP,2,2,\nA.PV,2,Bad,null\n";
  EXPECT_EQ(parse_streams(text).size(), 3U);
  try {
    (void)parse_streams(text + "A.OP,3,1,%\nA.PV,3,1.6,l/s\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.line, 9U);
    EXPECT_EQ(error.expected, "the unit 'm3/h', as before, of 'A.PV'");
    EXPECT_EQ(error.found, "'l/s'");
  }
}

TEST(TagStreams, ZonesOfTheirOwnHaveToBeSure) {
  const auto pairs = [](const std::string& u, const std::string& y) {
    std::string text = "Time,A.OP,Time,A.PV\n";
    for (int k = 10; k < 40; ++k) {
      const std::string time = "2026-05-03 10:00:" + std::to_string(k);
      text += time + u + ',' + std::to_string(k % 3) + ',' + time + y + ',' +
              std::to_string(k % 4) + '\n';
    }
    return text;
  };
  EXPECT_EQ(parse_streams(pairs(" IST", " IST")).size(), 30U);
  EXPECT_EQ(parse_streams(pairs("", "")).size(), 30U);
  for (const auto& [u, y] : {std::pair(" IST", "+05:30"), std::pair("", "Z")}) {
    EXPECT_THROW((void)parse_streams(pairs(u, y)), InputError) << u << y;
  }
}

TEST(TagStreams, BeginWhereTheFirstSampleIs) {
  std::string text = "tag,time,value\n";
  for (int k = 0; k < 60; ++k) {
    const std::string time =
        "2026-05-03 10:00:" + std::string(k < 10 ? "0" : "") + std::to_string(k) + ",";
    text += "A.OP," + time + std::to_string(k % 3) + "\nA.PV," + time +
            (k < 10 ? std::string("Bad") : std::to_string(k % 4)) + "\n";
  }
  const Recording r = parse_streams(text);
  EXPECT_EQ(r.size(), 50U);
  EXPECT_EQ(r.start, "2026-05-03T10:00:10");
  EXPECT_EQ(r.t.front(), 0);
}

TEST(TagStreams, MayEndBeforeOthers) {
  const auto with_end = [](const std::string& end) {
    std::string text = "t [s],A.OP,t [s],A.PV\n";
    for (int k = 0; k < 300; ++k) {
      const std::string time = std::to_string(k);
      text += time + ',' + std::to_string(k % 7) + ',' +
              (k < 200 ? time + ',' + std::to_string(k % 5) : end) + '\n';
    }
    return parse_streams(text);
  };
  const Recording r = with_end("EOF,EOF");
  EXPECT_EQ(r.size(), 200U);
  EXPECT_EQ(r.y, with_end(",").y);
}

}  // namespace
}  // namespace workbench
