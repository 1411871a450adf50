#include <gtest/gtest.h>

#include <array>

#include "hal/fake_can.hpp"

namespace hal {
namespace {

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

}  // namespace
}  // namespace hal
