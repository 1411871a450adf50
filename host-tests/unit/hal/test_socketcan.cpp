// What the backend says where the device is absent; where it is present it is tested in
// an emulator (host-tests/vm).
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "hal/socketcan.hpp"

namespace hal {
namespace {

TEST(SocketCan, AnAbsentInterfaceIsNamedWithWhatToDo) {
  SocketCan bus("nocan7", {{0x18E, false}});
  EXPECT_FALSE(bus.open());
  const std::string error = bus.error();
  EXPECT_NE(error.find("nocan7"), std::string::npos) << error;
  EXPECT_NE(error.find("; "), std::string::npos) << error;
  std::size_t count = 1;
  std::array<ReceivedFrame, 1> frames;
  EXPECT_EQ(bus.read(frames, count), CanStatus::kLost);
  EXPECT_EQ(count, 0U);
  EXPECT_EQ(bus.write({}), CanStatus::kLost);
  EXPECT_EQ(bus.descriptor(), -1);
}

}  // namespace
}  // namespace hal
