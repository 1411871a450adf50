#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "support/base/temporary_folder.hpp"
#include "workbench/screen/journal.hpp"

namespace workbench {
namespace {

ScreenedLoop loop_named(const std::string& name) {
  ScreenedLoop loop;
  loop.loop = name;
  loop.verdict = "undecided";
  return loop;
}

TEST(Journal, RemembersUnderItsKey) {
  const TemporaryFolder folder;
  {
    Journal journal(folder.file("j"));
    journal.add("key 1", loop_named("a"));
    journal.add("key 2", loop_named("b"));
  }
  const Journal again(folder.file("j"));
  ASSERT_TRUE(again.find("key 2"));
  EXPECT_EQ(again.find("key 2")->loop, "b");
  EXPECT_FALSE(again.find("key 3"));
}

TEST(Journal, ALineThatWasCutOffHurtsNoOther) {
  const TemporaryFolder folder;
  { Journal(folder.file("j")).add("key 1", loop_named("a")); }
  std::ofstream(folder.file("j"), std::ios::app) << R"({"version":"0.1.0","key":"k)";
  { Journal(folder.file("j")).add("key 2", loop_named("b")); }
  const Journal again(folder.file("j"));
  EXPECT_TRUE(again.find("key 1"));
  EXPECT_TRUE(again.find("key 2"));
}

TEST(Journal, WithoutANameItRemembersNothing) {
  Journal journal("");
  journal.add("key", loop_named("a"));
  EXPECT_FALSE(journal.find("key"));
}

TEST(Journal, AFolderThatIsNoneIsSaid) {
  EXPECT_THROW(Journal("/no/such/folder/j"), std::runtime_error);
}

TEST(Journal, PassesOverForeignLines) {
  TemporaryFolder folder;
  const std::string path = folder.file("j");
  std::ofstream(path) << "{\"key\":1,\"version\":2}\n[1]\nno JSON\n";
  Journal journal(path);
  EXPECT_FALSE(journal.find("1"));
}

TEST(Journal, FindsKeysThatAreNoText) {
  TemporaryFolder folder;
  const std::string path = folder.file("j");
  ScreenedLoop loop;
  loop.loop = "A";
  loop.verdict = "stiction";
  const std::string key = "A\xFC.csv|100%|ü";
  {
    Journal journal(path);
    journal.add(key, loop);
  }
  const Journal journal(path);
  ASSERT_TRUE(journal.find(key));
  EXPECT_EQ(journal.find(key)->verdict, "stiction");
  EXPECT_FALSE(journal.find("A\xFD.csv|100%|ü"));
}

}  // namespace
}  // namespace workbench
