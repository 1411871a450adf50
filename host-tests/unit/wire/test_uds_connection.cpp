#include <gtest/gtest.h>

#include <memory>

#include "support/uds/tester.hpp"
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
    return {frame->data.begin(), frame->data.begin() + frame->dlc};
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
  EXPECT_EQ(size, 3 + 4 * (9 + 22U));
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

TEST(UdsConnection, AnUnlockIsOfTheSourceAddressThatUnlocked) {
  Bus bus(normal_fixed_settings(), support::writing_settings());
  const auto ask = [&](std::uint32_t id, Bytes request) {
    bus.frame(id, [&] {
      Bytes data = {static_cast<std::uint8_t>(request.size())};
      data.insert(data.end(), request.begin(), request.end());
      return data;
    }());
    const Bytes data = bus.next();
    return Bytes(data.begin() + 1, data.begin() + 1 + data[0]);
  };
  UdsServer& server = const_cast<UdsServer&>(bus.connection->server());
  EXPECT_EQ(ask(0x18DA10F1, {0x10, 0x03})[0], 0x50);
  std::array<std::uint8_t, 64> room{};
  const auto handle = [&](std::uint8_t tester, Bytes request) {
    const auto answer = server.handle(request, false, bus.now_us, room, tester);
    return Bytes(answer.begin(), answer.end());
  };
  Bytes seed = handle(0xF1, {0x27, 0x01});
  seed.erase(seed.begin(), seed.begin() + 2);
  const Sha256Digest key = hmac_sha256(support::writing_settings().key, seed);
  Bytes send_key = {0x27, 0x02};
  send_key.insert(send_key.end(), key.begin(), key.begin() + 16);
  EXPECT_EQ(handle(0xF1, send_key), (Bytes{0x67, 0x02}));

  // A stranger has a session of its own: default, locked, with its own tries …
  EXPECT_EQ(ask(0x18DA10F9, {0x22, 0xF1, 0x86})[3], 1);
  EXPECT_EQ(ask(0x18DA10F9, {0x14, 0xFF, 0xFF, 0xFF}), (Bytes{0x7F, 0x14, 0x7F}));
  EXPECT_EQ(ask(0x18DA10F9, {0x10, 0x03})[0], 0x50);
  EXPECT_EQ(ask(0x18DA10F9, {0x14, 0xFF, 0xFF, 0xFF}), (Bytes{0x7F, 0x14, 0x33}));
  for (int k = 0; k < UdsServer::kMostTries; ++k) {
    EXPECT_EQ(handle(0xF9, {0x27, 0x01})[0], 0x67);
    Bytes wrong = {0x27, 0x02};
    wrong.resize(18);
    EXPECT_EQ(handle(0xF9, wrong)[0], 0x7F);
  }
  EXPECT_EQ(handle(0xF9, {0x27, 0x01}), (Bytes{0x7F, 0x27, 0x37}));
  EXPECT_EQ(ask(0x18DA10F9, {0x10, 0x01})[0], 0x50);
  // … and the other's is as it was.
  EXPECT_EQ(ask(0x18DA10F1, {0x22, 0xF1, 0x86})[3], 3);
  EXPECT_EQ(ask(0x18DA10F1, {0x14, 0xFF, 0xFF, 0xFF}), Bytes{0x54});
  // Its silence ends its session, whoever else speaks.
  for (int k = 0; k < 10; ++k) {
    bus.now_us += UdsServer::kS3Us / 10;
    EXPECT_EQ(ask(0x18DA10F9, {0x3E, 0x00})[0], 0x7E);
  }
  EXPECT_EQ(ask(0x18DA10F1, {0x14, 0xFF, 0xFF, 0xFF}), (Bytes{0x7F, 0x14, 0x7F}));
}

TEST(UdsConnection, NobodyElseKeepsOrEndsASessionWhileAResponseIsSent) {
  Bus bus(normal_fixed_settings());
  bus.frame(0x18DA10F1, {0x02, 0x10, 0x03});
  (void)bus.next();
  bus.frame(0x18DA10F1, {0x03, 0x22, 0xFD, 0x01});
  (void)bus.next();
  bus.frame(0x18DA10F1, {0x30, 1, 0x7F});
  for (int k = 0; k < 12; ++k) {
    bus.now_us += 900'000;
    EXPECT_FALSE(bus.next().empty());
    bus.frame(0x18DB33F9, {0x02, 0x3E, 0x80});
    (void)bus.next();
    bus.frame(0x18DA10F1, {0x30, 1, 0x7F});
  }
  EXPECT_EQ(bus.connection->server().session(0xF1), 3);
}

TEST(UdsConnection, ResetDropsWhatWasGoingOn) {
  Bus bus;
  bus.frame(0x7E0, {0x03, 0x22, 0xFD, 0x01});
  bus.connection->reset();
  EXPECT_TRUE(bus.next().empty());
  EXPECT_EQ(bus.connection->next_us(), std::nullopt);
}

TEST(UdsConnection, SessionsEndWhileTheBusTakesNoFrame) {
  Bus bus;
  bus.frame(0x7E0, {0x02, 0x10, 0x03});
  (void)bus.next();
  EXPECT_EQ(bus.connection->server().session(0), 3);
  for (int k = 0; k < 60; ++k) bus.connection->wait(bus.now_us += 100'000);
  EXPECT_EQ(bus.connection->server().session(0), 1);
}

}  // namespace
}  // namespace wire
