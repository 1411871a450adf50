#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <stdexcept>

#include "support/base/temporary_folder.hpp"
#include "workbench/screen/page.hpp"
#include "workbench/screen/result_files.hpp"

namespace workbench {
namespace {

Screening example() {
  Screening out;
  ScreenedLoop loop;
  loop.loop = "FIC, \"101\"";
  loop.verdict = "stiction";
  loop.stick_band.ascending = {true, 5, 4, 6};
  loop.reason = "</script><b>";
  loop.files = {"a.csv", "b.csv"};
  loop.u_tag = "LV_106";
  loop.y_tag = "FT,115";
  loop.trend = {{"2026-03", "stiction", 40, 5, 1}, {"2026-04", "stiction", 50, 6, 1}};
  out.loops.push_back(loop);
  ScreenedLoop broken;
  broken.loop = "x";
  broken.error = "no table";
  out.loops.push_back(broken);
  out.unpaired = {"a.csv: TI-1"};
  return out;
}

int number_in(const std::string& path, const std::string& sql) {
  sqlite3* database = nullptr;
  sqlite3_stmt* statement = nullptr;
  EXPECT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_prepare_v2(database, sql.c_str(), -1, &statement, nullptr),
            SQLITE_OK);
  EXPECT_EQ(sqlite3_step(statement), SQLITE_ROW);
  const int value = sqlite3_column_int(statement, 0);
  sqlite3_finalize(statement);
  sqlite3_close(database);
  return value;
}

TEST(ResultFiles, TheEndingSaysTheKind) {
  EXPECT_EQ(kind_of_result("a/x.HTML"), ResultKind::kHtml);
  EXPECT_EQ(kind_of_result("x.jsonl"), ResultKind::kJsonLines);
  EXPECT_EQ(kind_of_result("x.csv"), ResultKind::kCsv);
  EXPECT_EQ(kind_of_result("x.db"), ResultKind::kSqlite);
  EXPECT_THROW((void)kind_of_result("x.xlsx"), std::invalid_argument);
}

TEST(ResultFiles, CsvQuotesWhatItMust) {
  const std::string csv = csv_of(example());
  EXPECT_NE(csv.find("\n\"FIC, \"\"101\"\"\",stiction,0,0,5,4,6,,,,"), std::string::npos)
      << csv;
  EXPECT_NE(csv.find(",error,u,y\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",LV_106,\"FT,115\"\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\nx,,,,"), std::string::npos) << csv;
}

TEST(ResultFiles, SqliteHoldsLoopsTrendFilesAndTags) {
  const TemporaryFolder folder;
  const std::string path = folder.file("r.sqlite");
  write_sqlite(example(), path);
  write_sqlite(example(), path);
  EXPECT_EQ(number_in(path, "SELECT count(*) FROM loops"), 2);
  EXPECT_EQ(
      number_in(path, "SELECT stick_band_ascending FROM loops WHERE verdict='stiction'"),
      5);
  EXPECT_EQ(number_in(path, "SELECT count(*) FROM loops WHERE u='LV_106'"), 1);
  EXPECT_EQ(number_in(path, "SELECT count(*) FROM trend"), 2);
  EXPECT_EQ(number_in(path, "SELECT count(*) FROM files"), 2);
  EXPECT_EQ(number_in(path, "SELECT count(*) FROM unpaired"), 1);
  EXPECT_THROW(write_sqlite(example(), "/no/such/folder/r.sqlite"), std::runtime_error);
}

TEST(ResultFiles, SqliteIsWrittenAndReadThroughALink) {
  const TemporaryFolder folder;
  const std::string file = folder.file("r.sqlite");
  const std::string link = folder.file("latest.sqlite");
  std::filesystem::create_symlink("r.sqlite", link);
  write_sqlite(example(), link);
  write_sqlite(example(), link);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_TRUE(std::filesystem::is_regular_file(file));
  for (const std::string& path : {file, link}) {
    EXPECT_EQ(number_in(path, "SELECT count(*) FROM loops"), 2) << path;
  }
}

TEST(ScreenPage, DataCannotEndTheScriptAndNothingComesFromOutside) {
  const std::string data = page_data(example());
  EXPECT_EQ(data.find('<'), std::string::npos);
  const std::string page = screen_page(example());
  EXPECT_NE(page.find("default-src 'none'; style-src 'sha256-"), std::string::npos);
  EXPECT_EQ(page.find("{{"), std::string::npos);
  EXPECT_EQ(page.find("unsafe-inline"), std::string::npos);
}

}  // namespace
}  // namespace workbench
