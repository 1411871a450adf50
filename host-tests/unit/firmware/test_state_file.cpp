#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>

#include "firmware/process.hpp"
#include "firmware/state_file.hpp"
#include "support/base/temporary_folder.hpp"

namespace firmware {
namespace {

class StateFiles : public testing::Test {
 protected:
  TemporaryFolder own;
  std::string folder = own.path();
  std::string path = folder + "/state";
  std::vector<std::uint8_t> image = {1, 2, 3};
  std::vector<std::uint8_t> read;
  bool exists = false;
};

void finish(StateFile& file, std::span<const std::uint8_t> image) {
  file.settle();
  EXPECT_TRUE(file.save(image));
  file.settle();
}

TEST_F(StateFiles, IsEmptyWhereThereIsNone) {
  const StateFile file(path);
  EXPECT_TRUE(file.read(read, exists));
  EXPECT_TRUE(read.empty());
  EXPECT_FALSE(exists);
}

TEST_F(StateFiles, ComesBackAsItWasSaved) {
  StateFile file(path);
  EXPECT_TRUE(file.save(image));
  finish(file, std::vector<std::uint8_t>{4, 5});
  ASSERT_TRUE(file.read(read, exists));
  EXPECT_EQ(read, (std::vector<std::uint8_t>{4, 5}));
  EXPECT_EQ(file.failures(), 0U);
  file.set_aside();
  EXPECT_EQ(text_of(path + ".bad"), "\4\5");
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(StateFiles, RefusesWhatIsNoImage) {
  StateFile file(path);
  EXPECT_FALSE(file.save({}));
  EXPECT_FALSE(file.save(std::vector<std::uint8_t>(wire::kMostStateBytes + 1)));
}

TEST_F(StateFiles, CountsFailuresAndGoesOn) {
  StateFile file(folder + "/none/state");
  finish(file, image);
  EXPECT_EQ(file.failures(), 1U);
  EXPECT_EQ(file.error(), ENOENT);
  std::filesystem::create_directory(folder + "/none");
  finish(file, image);
  EXPECT_EQ(file.failures(), 1U);
  EXPECT_EQ(file.error(), ENOENT) << "of the newest failure, whatever follows";
  EXPECT_TRUE(std::filesystem::exists(file.path()));
}

TEST_F(StateFiles, WindowsLieBesideItWithTheirChecksum) {
  StateFile file(path, 100);
  ASSERT_TRUE(file.read_windows(read, exists));
  EXPECT_FALSE(exists);
  const std::span<std::uint8_t> room = file.room_for_windows();
  ASSERT_EQ(room.size(), 100U);
  const std::string_view text = "123456789";
  std::copy(text.begin(), text.end(), room.begin());
  file.save_windows(text.size());
  EXPECT_TRUE(file.save(image)) << "both at once";
  file.settle();
  EXPECT_EQ(text_of(path + ".windows"), "123456789\xCB\xF4\x39\x26");
  EXPECT_EQ(text_of(path), "\1\2\3");
  ASSERT_TRUE(file.read_windows(read, exists));
  EXPECT_EQ(read.size(), 13U);
  file.set_windows_aside();
  EXPECT_FALSE(std::filesystem::exists(file.windows_path()));
  EXPECT_TRUE(std::filesystem::exists(path + ".windows.bad"));
}

TEST_F(StateFiles, OneThatIsEmptyIsThere) {
  std::ofstream(path).flush();
  const StateFile file(path);
  EXPECT_TRUE(file.read(read, exists));
  EXPECT_TRUE(exists);
}

TEST_F(StateFiles, BelongsToOneAtATime) {
  StateFile second(path);
  {
    StateFile first(path);
    EXPECT_TRUE(first.lock());
    EXPECT_FALSE(second.lock());
  }
  EXPECT_TRUE(second.lock());
}

TEST_F(StateFiles, WhatACrashLeftOfAWriteIsRemovedByItsOwnerAlone) {
  const std::string left[] = {path + ".new", path + ".windows.new"};
  StateFile next(path);
  {
    StateFile owner(path);
    ASSERT_TRUE(owner.lock());
    for (const std::string& name : left) std::ofstream(name) << "half";
    EXPECT_FALSE(next.lock());
    for (const std::string& name : left) EXPECT_EQ(access(name.c_str(), F_OK), 0) << name;
  }
  EXPECT_TRUE(next.lock());
  for (const std::string& name : left) EXPECT_NE(access(name.c_str(), F_OK), 0) << name;
}

TEST_F(StateFiles, AFolderInItsPlaceCannotBeRead) {
  const StateFile file(folder);
  EXPECT_FALSE(file.read(read, exists));
  EXPECT_EQ(errno, EISDIR);
}

}  // namespace
}  // namespace firmware
