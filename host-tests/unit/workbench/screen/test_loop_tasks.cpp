#include <gtest/gtest.h>

#include "workbench/screen/loop_tasks.hpp"

namespace workbench {
namespace {

ExportFile single(const std::string& path, const std::string& loop) {
  ExportFile file;
  file.path = path;
  file.loop = loop;
  return file;
}

ExportFile of_tag(const std::string& path, const std::string& tag) {
  ExportFile file = single(path, tag);
  file.tag = tag;
  return file;
}

TEST(LoopTasks, OneNameInFoldersOfDatesIsOneLoop) {
  const std::vector<ExportFile> files = {single("a/2026-03/FIC-7.csv", "FIC-7"),
                                         single("a/2026-04/FIC-7.csv", "FIC-7"),
                                         single("b/FIC-7.csv", "FIC-7")};
  const LoopTasks pooled = make_tasks(files, {}, {}, true);
  ASSERT_EQ(pooled.tasks.size(), 2U);
  EXPECT_EQ(pooled.tasks[0].parts.size(), 2U);
  EXPECT_NE(pooled.tasks[0].name, pooled.tasks[1].name);
  EXPECT_EQ(make_tasks(files, {}, {}, false).tasks.size(), 3U);
  EXPECT_EQ(make_tasks(files, {{2, "unreadable"}}, {}, true).tasks.size(), 1U);
}

TEST(LoopTasks, FilesOfOneSignalArePairedInTheirFolder) {
  const std::vector<ExportFile> files = {
      of_tag("a/1.csv", "FIC7.OP"), of_tag("a/2.csv", "FIC7.PV"),
      of_tag("a/3.csv", "FIC7.SP"), of_tag("b/4.csv", "FIC7.PV")};
  const LoopTasks made = make_tasks(files, {}, {}, true);
  ASSERT_EQ(made.tasks.size(), 1U);
  EXPECT_EQ(made.tasks[0].name, "FIC7");
  EXPECT_EQ(made.tasks[0].u_tag, "FIC7.OP");
  ASSERT_EQ(made.tasks[0].parts.size(), 1U);
  EXPECT_EQ(made.tasks[0].parts[0].beside.size(), 2U);
  ASSERT_EQ(made.errors.size(), 1U);
  EXPECT_EQ(made.errors[0].files, std::vector<std::string>{"b/4.csv"});
}

TEST(LoopTasks, AListedLoopThatNoFileHoldsIsAnError) {
  const std::vector<ExportFile> files = {of_tag("a/1.csv", "FIC7.OP"),
                                         of_tag("a/2.csv", "FIC7.PV")};
  PairRules pairs;
  pairs.list = {{"A", {"FIC7.OP", "FIC7.PV", "", ""}},
                {"B", {"FIC9.OP", "FIC9.PV", "", ""}}};
  const LoopTasks made = make_tasks(files, {}, pairs, true);
  ASSERT_EQ(made.tasks.size(), 1U);
  ASSERT_EQ(made.errors.size(), 1U);
  EXPECT_EQ(made.errors[0].loop, "B");
  EXPECT_NE(made.errors[0].error.find("'FIC9.OP' and 'FIC9.PV'"), std::string::npos);
}

TEST(LoopTasks, TheKeyChangesWithAnyOfItsFiles) {
  std::vector<ExportFile> files = {of_tag("1.csv", "FIC7.OP"),
                                   of_tag("2.csv", "FIC7.PV")};
  const LoopTask task = make_tasks(files, {}, {}, true).tasks.at(0);
  const std::string before = key_of(task, files, {});
  files[1].bytes = 7;
  EXPECT_NE(key_of(task, files, {}), before);
}

TEST(LoopTasks, WhatOnlyDatesAFolderGoes) {
  EXPECT_EQ(folder_of("a/2026-03/b/x.csv", true), "a/b/");
  EXPECT_EQ(folder_of("a/2026-03/b/x.csv", false), "a/2026-03/b/");
}

}  // namespace
}  // namespace workbench
