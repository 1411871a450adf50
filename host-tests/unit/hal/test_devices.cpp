// What the backends of the kernel say where the device is absent; what they do where it
// is present is tested in an emulator (host-tests/vm).
#include <gtest/gtest.h>

#include <string>

#include "hal/fake_can.hpp"
#include "hal/fake_io.hpp"
#include "hal/gpio_line.hpp"
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

TEST(GpioLine, AnAbsentChipIsNamedWithWhatToDo) {
  GpioLine line("gpiochip-absent", 3, false);
  EXPECT_FALSE(line.open(true));
  EXPECT_FALSE(line.set(true));
  const std::string error = line.error();
  EXPECT_NE(error.find("gpiochip-absent line 3"), std::string::npos) << error;
}

TEST(FakeCan, IsABusThatCanGo) {
  FakeCan bus;
  std::size_t count = 0;
  std::array<ReceivedFrame, 2> frames;
  EXPECT_EQ(bus.read(frames, count), CanStatus::kLost);
  ASSERT_TRUE(bus.open());
  bus.incoming.push_back({5, {.id = 1}});
  EXPECT_EQ(bus.read(frames, count), CanStatus::kOk);
  EXPECT_EQ(count, 1U);
  EXPECT_EQ(bus.read(frames, count), CanStatus::kWait);
  bus.down = true;
  EXPECT_EQ(bus.write({}), CanStatus::kDown);
}

TEST(FakeOutput, CountsTheChangesOfItsLevel) {
  FakeOutput line;
  EXPECT_FALSE(line.set(true));
  ASSERT_TRUE(line.open(false));
  EXPECT_TRUE(line.set(true));
  EXPECT_TRUE(line.set(true));
  EXPECT_EQ(line.changes, 1);
  line.present = false;
  EXPECT_FALSE(line.set(false));
}

}  // namespace
}  // namespace hal
