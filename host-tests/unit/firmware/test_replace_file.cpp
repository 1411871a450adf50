#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "firmware/process.hpp"
#include "firmware/replace_file.hpp"
#include "support/base/temporary_folder.hpp"

namespace firmware {
namespace {

TEST(ReplaceFile, LeavesTheOldFileWhereTheNewOneCannotBeWritten) {
  const TemporaryFolder own;
  const std::string& folder = own.path();
  const std::string path = folder + "/a.prom";
  ASSERT_TRUE(replace_file(path.c_str(), "one\n", Readers::kOwner));
  ASSERT_TRUE(replace_file(path.c_str(), "two\n", Readers::kOwner, true));
  EXPECT_EQ(text_of(path), "two\n");
  EXPECT_NE(access((path + ".new").c_str(), F_OK), 0);
  EXPECT_FALSE(replace_file((folder + "/none/a.prom").c_str(), "x", Readers::kOwner));
  EXPECT_FALSE(replace_file(folder.c_str(), "x", Readers::kOwner))
      << "a folder is in the way";
  // What is in the way beside it cannot be removed.
  std::filesystem::create_directories(path + ".new/inside");
  EXPECT_FALSE(replace_file(path.c_str(), "three\n", Readers::kOwner));
  EXPECT_EQ(text_of(path), "two\n");
}

TEST(ReplaceFile, FollowsNoLinkBesideIt) {
  const TemporaryFolder own;
  const std::string path = own.file("state");
  const std::string victim = own.file("victim");
  std::ofstream(victim) << "precious";
  ASSERT_EQ(symlink(victim.c_str(), (path + ".new").c_str()), 0);
  EXPECT_TRUE(replace_file(path.c_str(), "mine", Readers::kOwner));
  EXPECT_EQ(text_of(victim), "precious");
  EXPECT_EQ(text_of(path), "mine");
  EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(path)));
}

TEST(ReplaceFile, IsReadByWhomItIsForWhateverTheUmask) {
  const TemporaryFolder own;
  const std::string path = own.file("a");
  const mode_t before = umask(0027);
  const auto mode = [&path] {
    struct stat about {};
    EXPECT_EQ(stat(path.c_str(), &about), 0);
    return about.st_mode & 0777;
  };
  ASSERT_TRUE(replace_file(path.c_str(), "x", Readers::kEverybody));
  EXPECT_EQ(mode(), 0644U);
  ASSERT_TRUE(replace_file(path.c_str(), "x", Readers::kOwner));
  EXPECT_EQ(mode(), 0600U);
  umask(before);
}

}  // namespace
}  // namespace firmware
