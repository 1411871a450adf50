#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/base/temporary_folder.hpp"
#include "workbench/screen/found_files.hpp"

namespace workbench {
namespace {

class FoundFilesTest : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text = "u,y\n1,2\n") {
    const std::string path = folder.file(name);
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    std::ofstream(path) << text;
    return path;
  }
  TemporaryFolder folder;
};

TEST_F(FoundFilesTest, AFolderMeansItsRecordings) {
  const std::string a = write("b/a.CSV");
  const std::string b = write("b.txt");
  write("notes.pdf");
  write(".hidden/c.csv");
  const FoundFiles found = find_files({folder.path()});
  EXPECT_EQ(found.files, (std::vector<std::string>{b, a}));
  EXPECT_EQ(found.passed_over, std::vector<std::string>{folder.file("notes.pdf")});
}

TEST_F(FoundFilesTest, PatternsAndListsMeanFilesOnce) {
  const std::string a = write("a1.csv");
  const std::string b = write("a2.csv");
  write("list", "# comment\na1.csv\r\n\n" + b + "\n");
  const FoundFiles found = find_files({folder.file("a?.csv"), "@" + folder.file("list")});
  EXPECT_EQ(found.files, (std::vector<std::string>{a, b}));
  EXPECT_TRUE(found.problems.empty());
}

TEST_F(FoundFilesTest, AFolderWithoutRecordingsNamesWhatIsReadAndWhatIsThere) {
  write("bus.log");
  write("a.pdf");
  const FoundFiles found = find_files({folder.path()});
  ASSERT_EQ(found.problems.size(), 1U);
  const std::string& what = found.problems[0].what;
  EXPECT_NE(what.find("*.xlsx"), std::string::npos) << what;
  EXPECT_NE(what.find("found only a.pdf, bus.log;"), std::string::npos) << what;
  EXPECT_TRUE(found.passed_over.empty()) << "they are named already";
}

TEST_F(FoundFilesTest, WhatIsNamedItselfIsNotPassedOver) {
  write("a.csv");
  const std::string log = write("table.log");
  const FoundFiles found = find_files({folder.path(), log});
  EXPECT_EQ(found.files.size(), 2U);
  EXPECT_TRUE(found.passed_over.empty());
}

TEST(NamesOfSome, AreEightAtMost) {
  EXPECT_EQ(names_of_some({"x/a.log", "b.dbc"}), "a.log, b.dbc");
  EXPECT_EQ(names_of_some({"1", "2", "3", "4", "5", "6", "7", "8", "9", "10"}),
            "1, 2, 3, 4, 5, 6, 7, 8 and 2 more");
}

TEST_F(FoundFilesTest, APathThatLeadsNowhereIsAProblem) {
  const FoundFiles found =
      find_files({folder.file("none.csv"), folder.file("*.csv"), folder.path()});
  EXPECT_TRUE(found.files.empty());
  EXPECT_EQ(found.problems.size(), 3U);
}

TEST(RunningNumber, OnlyWhatIsTakenOffCounts) {
  EXPECT_EQ(running_number("FIC-101-2.csv"), 2);
  EXPECT_EQ(running_number("FIC-101_03.csv"), 3);
  EXPECT_EQ(running_number("FIC-101.csv"), 0);
  EXPECT_EQ(running_number("FIC-101_2024-03.csv"), 0);
}

TEST(IsDateLike, NamesOfMonthsWeeksAndRuns) {
  for (const char* name :
       {"2024", "2024-03", "2024-03-01", "week_12", "Jan-2024", "03"}) {
    EXPECT_TRUE(is_date_like(name)) << name;
  }
  for (const char* name : {"plantA", "unit1-fic", "isdb", "A1"}) {
    EXPECT_FALSE(is_date_like(name)) << name;
  }
}

TEST(FoundFiles, ALinkToNowhereIsNone) {
  TemporaryFolder folder;
  std::filesystem::create_symlink("/nowhere", folder.path() + "/a*");
  const FoundFiles found = find_files({folder.path() + "/a*"});
  EXPECT_TRUE(found.files.empty());
  EXPECT_EQ(found.problems.size(), 1U);
}

}  // namespace
}  // namespace workbench
