#include <gtest/gtest.h>

#include <memory>

#include "support/uds_daemon.hpp"
#include "wire/uds_connection.hpp"

namespace wire {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Bus {
  explicit Bus(const IsoTpSettings& link = {}, const UdsSettings& settings = {})
      : connection(std::make_unique<UdsConnection>(link, settings, daemon.gateway,
                                                   daemon.loops, *daemon.dtcs, daemon)) {}

  void frame(std::uint32_t id, const Bytes& data) {
    CanFrame frame;
    frame.id = id;
    frame.extended = id > kMaxStandardId;
    frame.dlc = static_cast<std::uint8_t>(data.size());
    std::copy(data.begin(), data.end(), frame.data.begin());
    connection->on_frame(frame, now_us);
  }
  Bytes next() {
    const auto frame = connection->poll(now_us);
    if (!frame) return {};
    return {frame->data.begin(), frame->data.end()};
  }

  support::UdsDaemon daemon;
  std::unique_ptr<UdsConnection> connection;
  std::int64_t now_us = 0;
};

TEST(UdsConnection, AnswersAtOnce) {
  Bus bus;
  bus.frame(0x7E0, {0x02, 0x3E, 0x00});
  EXPECT_EQ(bus.next(), (Bytes{0x02, 0x7E, 0x00, 0xCC, 0xCC, 0xCC, 0xCC, 0xCC}));
  EXPECT_TRUE(bus.next().empty());
  bus.frame(0x7DF, {0x02, 0x3E, 0x80});
  EXPECT_TRUE(bus.next().empty());
  bus.frame(0x7DF, {0x03, 0x22, 0x12, 0x34});
  EXPECT_TRUE(bus.next().empty()) << "functional: silence";
}

TEST(UdsConnection, LongResponseOverManyFrames) {
  Bus bus;
  bus.frame(0x7E0, {0x03, 0x22, 0xFD, 0x01});
  Bytes response;
  Bytes first = bus.next();
  ASSERT_EQ(first[0] >> 4, 1);
  const std::size_t size = static_cast<std::size_t>((first[0] & 15) << 8 | first[1]);
  response.assign(first.begin() + 2, first.end());
  bus.frame(0x7E0, {0x30, 0, 0});
  for (Bytes data = bus.next(); !data.empty(); data = bus.next()) {
    response.insert(response.end(), data.begin() + 1, data.end());
  }
  ASSERT_GE(response.size(), size);
  EXPECT_EQ(response[0], 0x62);
  EXPECT_EQ(size, 3 + 4 * (8 + 20U));
}

TEST(UdsConnection, SessionLivesAsLongAsAResponseIsSent) {
  Bus bus;
  bus.frame(0x7E0, {0x02, 0x10, 0x03});
  (void)bus.next();
  bus.frame(0x7E0, {0x03, 0x22, 0xFD, 0x01});
  (void)bus.next();
  bus.frame(0x7E0, {0x30, 0, 0x7F});
  for (Bytes data = bus.next(); bus.connection->link().sending(); data = bus.next()) {
    bus.now_us += 127'000;
  }
  EXPECT_GT(bus.now_us, 1'500'000);
  EXPECT_EQ(bus.connection->server().session(), 3);
  bus.now_us += UdsServer::kS3Us - 1;
  (void)bus.next();
  EXPECT_EQ(bus.connection->server().session(), 3);
  bus.now_us += 200'000;
  (void)bus.next();
  EXPECT_EQ(bus.connection->server().session(), 1);
}

TEST(UdsConnection, SecondTesterIsToldToRepeat) {
  Bus bus(normal_fixed_settings());
  bus.frame(0x18DA10F1, {0x03, 0x22, 0xFD, 0x01});
  EXPECT_EQ(bus.next()[0] >> 4, 1);
  bus.frame(0x18DA10F9, {0x03, 0x22, 0xF1, 0x86});
  const auto refused = bus.connection->poll(0);
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->id, 0x18DAF910U);
  EXPECT_EQ(refused->data[3], 0x21);
}

TEST(UdsConnection, ResetDropsWhatWasGoingOn) {
  Bus bus;
  bus.frame(0x7E0, {0x03, 0x22, 0xFD, 0x01});
  bus.connection->reset();
  EXPECT_TRUE(bus.next().empty());
  EXPECT_EQ(bus.connection->next_us(), std::nullopt);
}

}  // namespace
}  // namespace wire
