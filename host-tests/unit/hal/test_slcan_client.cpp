#include <gtest/gtest.h>

#include <array>
#include <thread>

#include "hal/slcan.hpp"
#include "hal/slcan_client.hpp"

namespace hal {
namespace {

wire::CanFrame frame_of(std::uint32_t id) {
  wire::CanFrame frame;
  frame.id = id;
  frame.extended = id > wire::kMaxStandardId;
  frame.dlc = 3;
  frame.data = {1, 2, 3};
  return frame;
}

// What comes within a second.
CanStatus wait_for(CanBus& bus, std::span<ReceivedFrame> out, std::size_t& count) {
  CanStatus status = CanStatus::kWait;
  for (int k = 0; k < 1000 && status == CanStatus::kWait; ++k) {
    status = bus.read(out, count);
    if (status == CanStatus::kWait) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  return status;
}

TEST(SlcanClient, HasItsPortInTheNameOfTheBus) {
  EXPECT_EQ(slcan_port("slcan:29536"), 29536);
  EXPECT_EQ(slcan_port("can0"), std::nullopt);
  for (const char* const name : {"slcan:", "slcan:x", "slcan:80x", "slcan:65536"}) {
    EXPECT_EQ(slcan_port(name), 0) << name;
  }
}

TEST(SlcanClient, ExchangesFramesWithTheServer) {
  const SystemClock clock;
  SlcanServer server(0, clock);
  ASSERT_TRUE(server.open());
  SlcanClient client(server.port());
  ASSERT_TRUE(client.open());
  std::array<ReceivedFrame, 4> frames;
  std::size_t count = 0;
  for (const std::uint32_t id : {0x123U, 0x18DA10F1U}) {
    ASSERT_EQ(client.write(frame_of(id)), CanStatus::kOk);
    ASSERT_EQ(wait_for(server, frames, count), CanStatus::kOk);
    ASSERT_EQ(count, 1U);
    EXPECT_EQ(frames[0].frame, frame_of(id));
    ASSERT_EQ(server.write(frame_of(id)), CanStatus::kOk);
    ASSERT_EQ(wait_for(client, frames, count), CanStatus::kOk);
    ASSERT_EQ(count, 1U);
    EXPECT_EQ(frames[0].frame, frame_of(id));
  }
}

TEST(SlcanClient, SaysThatNobodyListensOrTheServerLeft) {
  const SystemClock clock;
  std::uint16_t port = 0;
  std::array<ReceivedFrame, 4> frames;
  std::size_t count = 0;
  {
    SlcanServer server(0, clock);
    ASSERT_TRUE(server.open());
    port = server.port();
    SlcanClient client(port);
    ASSERT_TRUE(client.open());
    ASSERT_EQ(wait_for(server, frames, count), CanStatus::kWait);
    ASSERT_TRUE(server.open());  // closes what was open
    EXPECT_EQ(wait_for(client, frames, count), CanStatus::kLost);
    EXPECT_EQ(client.write(frame_of(1)), CanStatus::kLost);
  }
  SlcanClient client(port);
  EXPECT_FALSE(client.open());
  EXPECT_NE(std::string_view(client.error()).find("start the gateway"),
            std::string_view::npos);
}

}  // namespace
}  // namespace hal
