// Names of files that follow one another.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "workbench/cli/next_file.hpp"

namespace workbench::cli {
namespace {

namespace fs = std::filesystem;

TEST(NextFile, CountsOnFromTheNameBefore) {
  EXPECT_EQ(next_file("nowhere/m.json"), "nowhere/m2.json");
  EXPECT_EQ(next_file("nowhere/m2.json"), "nowhere/m3.json");
  EXPECT_EQ(next_file("nowhere/m9"), "nowhere/m10");
  EXPECT_EQ(next_file("nowhere/7.json"), "nowhere/7-2.json");
  EXPECT_EQ(next_file("nowhere/loop-2026.json"), "nowhere/loop-2026-2.json");
  EXPECT_EQ(next_file("nowhere/loop-2026-2.json"), "nowhere/loop-2026-3.json");
}

TEST(NextFile, TakesNoNameThatIsInUse) {
  const fs::path folder = fs::path(testing::TempDir()) / "next_file";
  fs::create_directories(folder);
  for (const char* name : {"m.json", "m2.json"}) std::ofstream(folder / name) << "{}";
  EXPECT_EQ(next_file((folder / "m.json").string()), (folder / "m3.json").string());
  fs::remove_all(folder);
}

TEST(NextFile, BeginsWhereThereIsNone) {
  const std::string first = next_file("");
  EXPECT_TRUE(first.starts_with("m") && first.ends_with(".json")) << first;
  EXPECT_EQ(next_file("/dev/null"), first);
}

}  // namespace
}  // namespace workbench::cli
