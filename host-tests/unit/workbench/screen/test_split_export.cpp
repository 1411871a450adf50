#include <gtest/gtest.h>

#include <fstream>

#include "support/base/temporary_folder.hpp"
#include "workbench/recording/source.hpp"
#include "workbench/screen/split_export.hpp"

namespace workbench {
namespace {

class SplitExportTest : public ::testing::Test {
 protected:
  // Every loop as `identify` reads it with its columns named.
  void expect_as_identified(const std::string& text, std::size_t loops) {
    std::ofstream(folder.file("e.csv"), std::ios::binary) << text;
    const ExportFile file = look_into(folder.file("e.csv"), options);
    SplitExport split(file, options, folder.path());
    ASSERT_TRUE(split.split({}, {}));
    ASSERT_EQ(split.file().loops.size(), loops);
    unpaired = split.file().unpaired;
    for (std::size_t i = 0; i < loops; ++i) {
      RecordingSource source;
      source.path = folder.file("e.csv");
      source.names.u = split.file().loops[i].u_tag;
      source.names.y = split.file().loops[i].y_tag;
      const Recording wanted = read_recording(source);
      const Recording read = split.recording(i);
      EXPECT_EQ(read.u, wanted.u);
      EXPECT_EQ(read.y, wanted.y);
      EXPECT_EQ(read.sp, wanted.sp);
      EXPECT_EQ(read.t, wanted.t);
      EXPECT_EQ(read.start, wanted.start);
      ASSERT_EQ(read.manual.size(), wanted.manual.size());
      for (std::size_t k = 0; k < read.manual.size(); ++k) {
        EXPECT_EQ(read.manual[k].first, wanted.manual[k].first);
        EXPECT_EQ(read.manual[k].last, wanted.manual[k].last);
      }
      EXPECT_EQ(read.name, wanted.name);
      EXPECT_EQ(read.resampling.notes, wanted.resampling.notes);
    }
  }
  TemporaryFolder folder;
  ReadOptions options;
  std::vector<std::string> unpaired;  // of the last text
};

TEST_F(SplitExportTest, AWideTableWithGapsAFooterAndDates) {
  std::string text = "Area 4\nTimestamp;A.OP;B.PV;A.PV;B.OP;TI.PV;A.SP\n";
  for (int i = 0; i < 40; ++i) {
    const std::string second = (i < 10 ? "0" : "") + std::to_string(i);
    text += "2026-05-03 14:30:" + second + ";" + std::to_string(i % 7) + ",5;" +
            (i == 5 ? "Bad" : std::to_string(i * i % 11)) + ";" + (i == 9 ? "" : "1,25") +
            ";" + std::to_string(i % 5) + ";7;3\r\n";
    if (i == 20) text += "\r\n";
  }
  expect_as_identified(text + "(40 rows)\r\n", 2);
}

TEST_F(SplitExportTest, TheModeOfEachLoopStaysWithIt) {
  std::string text = "Timestamp,B.OP,B.PV,B.SP,A.OP,A.PV,A.MODE\n";
  for (int i = 0; i < 40; ++i) {
    const bool manual = i >= 20 && i < 30;
    text += "2026-05-03 14:30:" + std::to_string(10 + i) + ',' + std::to_string(i % 5) +
            ",7." + std::to_string(i % 3) + ",7," +
            (manual ? "3" : std::to_string(i % 7)) + ',' + std::to_string(i * i % 11) +
            (manual ? ",MAN\n" : ",AUTO\n");
  }
  expect_as_identified(text, 2);
}

TEST_F(SplitExportTest, ALongTableInAnyOrder) {
  std::string text = "Tag,Time,Value\n";
  for (int i = 0; i < 30; ++i) {
    for (const char* tag : {"A.PV", "B.OP", "A.OP", "B.PV", "TI.PV"}) {
      text += std::string(tag) + ",2026-05-03 14:" + std::to_string(10 + i) + ":00," +
              std::to_string((i * 7 + tag[0] + tag[2]) % 13) + '\n';
    }
  }
  expect_as_identified(text, 2);
  options.pairs = PairRules::parse("*.OP/*.PV");
  expect_as_identified(text, 2);
}

TEST_F(SplitExportTest, TagsThatFollowEachOtherForLongerThanTheFirstRows) {
  const auto rows = [](const std::string& tag, int shape) {
    std::string out;
    for (int i = 0; i < 200; ++i) {
      out += tag + ',' + std::to_string(1773475200 + i * 10) + ',' +
             std::to_string(i * shape % 13) + '\n';
    }
    return out;
  };
  const std::string all =
      rows("A.OP", 3) + rows("A.PV", 5) + rows("B.OP", 7) + rows("B.PV", 9);
  expect_as_identified("Tag,Time,Value\n" + all, 2);
  expect_as_identified(all, 2);
}

TEST_F(SplitExportTest, TablesOfFluxWithTheirHeadsBetween) {
  const std::string head =
      "#group,false,false,false,false,true,true\n"
      "#datatype,string,long,dateTime:RFC3339,double,string,string\n"
      "#default,_result,,,,,\n,result,table,_time,_value,_field,loop\n";
  for (const bool once : {true, false}) {
    std::string text = head;
    int table = 0;
    for (const std::string keys : {"OP,A", "PV,A", "OP,B", "PV,B"}) {
      if (table > 0 && !once) text += '\n' + head;
      for (int i = 0; i < 200; ++i) {
        text += ",," + std::to_string(table) +
                ",2026-05-13T14:" + std::to_string(10 + i / 6) + ':' +
                std::to_string(i % 6) + "0Z," + std::to_string(i * (table + 3) % 13) +
                ',' + keys + '\n';
      }
      ++table;
    }
    expect_as_identified(text, 2);
    EXPECT_TRUE(unpaired.empty());
  }
}

TEST_F(SplitExportTest, AWideTableWithItsHeaderOnceMore) {
  const std::string head = "Time,A.OP,A.PV,B.OP,B.PV\n";
  std::string text = head;
  for (int i = 0; i < 40; ++i) {
    if (i == 20) text += head;
    text += std::to_string(i) + ',' + std::to_string(i % 7) + ",1.5," +
            std::to_string(i % 5) + ',' + std::to_string(i % 3) + '\n';
  }
  expect_as_identified(text, 2);
}

TEST_F(SplitExportTest, ColumnsWithTimesOfTheirOwn) {
  std::string text = "Time,A.OP,Time,A.PV,Time,B.OP,Time,B.PV\n";
  for (int i = 0; i < 30; ++i) {
    const auto at = [i](int shift) { return std::to_string(i * 10 + shift) + ','; };
    text += at(0) + std::to_string(i % 4) + ',' + at(1) + std::to_string(i % 5) + ',' +
            at(2) + std::to_string(i % 3) + ',' + at(2) + std::to_string(i % 7) + '\n';
  }
  expect_as_identified(text, 2);
}

TEST_F(SplitExportTest, HourMinuteAndSecondInColumnsAreNoTags) {
  std::string text = "Hour,Minute,Second,A.OP,A.PV,B.OP,B.PV,T1\n";
  for (int i = 0; i < 30; ++i) {
    text += "14,30," + std::to_string(i) + ',' + std::to_string(i % 4) + ",1,2," +
            std::to_string(i % 3) + ",4\n";
  }
  expect_as_identified(text, 2);
  const ExportFile file = look_into(folder.file("e.csv"), options);
  EXPECT_EQ(file.unpaired, (std::vector<std::string>{"T1"}));
}

TEST_F(SplitExportTest, ARowThatIsTooLongIsRefusedWithItsLine) {
  std::ofstream(folder.file("e.csv"))
      << "t,A.OP,A.PV,B.OP,B.PV\n0,1,2,3,4\n1,1,2,3,4,5\n2,1,2,3,4\n3,1,2,3,4\n";
  SplitExport split(look_into(folder.file("e.csv"), options), options, folder.path());
  ASSERT_TRUE(split.split({}, {}));
  try {
    (void)split.recording(1);
    ADD_FAILURE() << "read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.line, 3U);
  }
}

TEST_F(SplitExportTest, OnlyWantedLoopsAreKeptAndThePassMayEnd) {
  std::ofstream(folder.file("e.csv")) << "t,A.OP,A.PV,B.OP,B.PV\n0,1,2,3,4\n1,2,3,4,5\n";
  SplitExport split(look_into(folder.file("e.csv"), options), options, folder.path());
  ASSERT_TRUE(split.split({false, true}, {}));
  EXPECT_EQ(split.recording(1).u, (std::vector<double>{3, 4}));
  SplitExport ended(look_into(folder.file("e.csv"), options), options, folder.path());
  EXPECT_FALSE(ended.split({}, [](std::uint64_t, std::uint64_t) { return false; }));
}

}  // namespace
}  // namespace workbench
