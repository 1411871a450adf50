#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <sstream>

#include "firmware/metrics.hpp"

namespace firmware {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Metrics, ShowEveryNumberOfTheTableAsTheWireDoes) {
  std::array<wire::LoopStatus, 2> loops;
  loops[0].id = 1;
  loops[0].tag.assign("A");
  loops[0].flag = true;
  loops[0].stick_band_pct.ascending = 5.0049;
  loops[1].id = 7;
  loops[1].tag.assign("B\\\"");
  wire::GatewayStatus gateway;
  gateway.name.assign("gw");
  std::string text;
  write_metrics({gateway, loops}, "plant", text);
  for (const char* line :
       {"stickband_gateway_info{group=\"plant\",name=\"gw\"} 1\n",
        "# TYPE stickband_loop_verdict gauge\n",
        "stickband_loop_flag{loop=\"1\",tag=\"A\"} 1\n",
        "stickband_loop_stick_band_ascending_pct{loop=\"1\",tag=\"A\"} 5\n",
        "stickband_loop_stick_band_ascending_pct{loop=\"7\",tag=\"B\\\\\\\"\"} NaN\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << "not in\n" << text;
  }
  for (const wire::LoopField& field : wire::loop_fields()) {
    const std::string head =
        "\nstickband_loop_" + std::string(field.name) + "{loop=\"7\"";
    EXPECT_EQ(text.find(head) != std::string::npos, field.number != nullptr) << head;
  }
  const std::size_t room = text.capacity();
  write_metrics({gateway, loops}, "plant", text);
  EXPECT_EQ(text.capacity(), room);
  EXPECT_LT(text.size(), room);
}

TEST(ReplaceFile, LeavesTheOldFileWhereTheNewOneCannotBeWritten) {
  const std::string folder = testing::TempDir() + "replace_file";
  mkdir(folder.c_str(), 0755);
  const std::string path = folder + "/a.prom";
  ASSERT_TRUE(replace_file(path.c_str(), "one\n"));
  ASSERT_TRUE(replace_file(path.c_str(), "two\n"));
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
  unlink((path + ".new").c_str());
}

}  // namespace
}  // namespace firmware
