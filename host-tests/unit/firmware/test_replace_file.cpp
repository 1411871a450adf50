#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "firmware/process.hpp"
#include "firmware/replace_file.hpp"
#include "support/temporary_folder.hpp"

namespace firmware {
namespace {

TEST(ReplaceFile, LeavesTheOldFileWhereTheNewOneCannotBeWritten) {
  const TemporaryFolder own;
  const std::string& folder = own.path();
  const std::string path = folder + "/a.prom";
  ASSERT_TRUE(replace_file(path.c_str(), "one\n"));
  ASSERT_TRUE(replace_file(path.c_str(), "two\n", true));
  EXPECT_EQ(text_of(path), "two\n");
  EXPECT_NE(access((path + ".new").c_str(), F_OK), 0);
  EXPECT_FALSE(replace_file((folder + "/none/a.prom").c_str(), "x"));
  EXPECT_FALSE(replace_file(folder.c_str(), "x")) << "a folder is in the way";
  if (access("/dev/full", W_OK) == 0) {
    // The disk is full: the file beside is a device that takes nothing.
    ASSERT_EQ(symlink("/dev/full", (path + ".new").c_str()), 0);
    EXPECT_FALSE(replace_file(path.c_str(), "three\n"));
    EXPECT_EQ(text_of(path), "two\n");
  }
}

}  // namespace
}  // namespace firmware
