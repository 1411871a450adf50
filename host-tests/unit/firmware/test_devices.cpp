#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "firmware/devices.hpp"
#include "firmware/event_loop.hpp"
#include "support/base/temporary_folder.hpp"

namespace firmware {
namespace {

// A loop whose five sources are the channels of a converter in a folder.
class Converters : public testing::Test {
 protected:
  void put(const std::string& device) const {
    const std::filesystem::path at =
        std::filesystem::path(own.path()) / "class/hwmon/hwmon3";
    std::filesystem::create_directories(at);
    std::ofstream(at / "name") << device << '\n';
    for (int k = 0; k < 6; ++k) {
      std::ofstream(at / ("in" + std::to_string(k) + "_input")) << "12\n";
    }
  }
  [[nodiscard]] Gateway gateway(const std::string& more = "") {
    std::string text =
        "[gateway]\nsysfs_root = \"" + own.path() + "\"\n[[loop]]\nid = 1\ntag = \"A\"\n";
    int channel = 0;
    for (const char* role : {"u", "y", "sp", "mode", "alive"}) {
      text += std::string(role) +
              " = { source = \"hwmon\", name = \"adc\", channel = \"in" +
              std::to_string(channel++) + "\" }\n";
    }
    return {config::parse_gateway(text + more, "g.toml"), *random, clock};
  }

  TemporaryFolder own;
  std::unique_ptr<Random> random = system_random();
  hal::FakeClock clock;
};

TEST_F(Converters, OneThatIsAwayIsNamedAndOneThatIsThereIsNot) {
  put("adc");
  Gateway there = gateway();
  EXPECT_EQ(there.devices.open_all(), "");
  put("another");
  Gateway away = gateway();
  const std::string missing = away.devices.open_all();
  for (const char* role : {"u", "y", "sp", "mode", "alive"}) {
    EXPECT_NE(missing.find(std::string("loop[1].") + role + ": expected a device"),
              std::string::npos)
        << missing;
  }
}

TEST_F(Converters, AnOldOneThatIsAwayIsNoFaultOfANewConfiguration) {
  put("adc");
  Gateway old = gateway();
  ASSERT_EQ(old.devices.open_all(), "");
  put("another");
  Gateway next = gateway("gain_sign = \"positive\"\n");
  EXPECT_EQ(next.devices.open_new(old.devices), "") << "of any role";
}

}  // namespace
}  // namespace firmware
