#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "firmware/modbus_server.hpp"
#include "hal/modbus.hpp"

namespace hal {
namespace {

using namespace std::chrono_literals;
using firmware::ModbusServer;

constexpr std::int64_t kPeriod_us = 20'000;

// Reads until the value is `expected`, for up to five seconds.
bool becomes(ModbusInput& input, double expected) {
  for (int k = 0; k < 250; ++k, std::this_thread::sleep_for(20ms)) {
    double value = 0;
    if (input.read(value) && value == expected) return true;
  }
  return false;
}

TEST(Modbus, NumbersOfOneRegisterAndOfTwo) {
  const auto number = [](ModbusType type, bool low_first) {
    return modbus_number({.type = type, .low_word_first = low_first}, 0xC248, 0x0001);
  };
  EXPECT_EQ(number(ModbusType::kU16, false), 0xC248);
  EXPECT_EQ(number(ModbusType::kI16, false), 0xC248 - 0x10000);
  EXPECT_EQ(number(ModbusType::kU32, false), 0xC2480001U);
  EXPECT_EQ(number(ModbusType::kU32, true), 0x0001C248U);
  EXPECT_EQ(number(ModbusType::kI32, false), -1035468799.0);
  EXPECT_EQ(number(ModbusType::kF32, false), -50 - std::ldexp(1.0, -18));
}

TEST(Modbus, ReadsRegistersOfARealServer) {
  ModbusServer server;
  if (!server.ready()) GTEST_SKIP() << "no libmodbus, or no port on 127.0.0.1";
  server.holding(100, 1234);
  server.input(7, 0xFF38);
  const auto link = std::make_shared<ModbusLink>(
      ModbusAddress{.host = "127.0.0.1", .port = server.port(), .device = ""});
  ModbusInput u(link, {.address = 100}, kPeriod_us);
  ModbusInput y(link,
                {.table = ModbusTable::kInput, .address = 7, .type = ModbusType::kI16},
                kPeriod_us);
  ASSERT_TRUE(u.open()) << u.error();
  ASSERT_TRUE(y.open()) << y.error();
  EXPECT_TRUE(becomes(u, 1234));
  EXPECT_TRUE(becomes(y, -200));
  server.holding(100, 1300);
  EXPECT_TRUE(becomes(u, 1300));
}

TEST(Modbus, ARegisterThatIsNotThereIsToldAndTheOthersGoOn) {
  ModbusServer server;
  if (!server.ready()) GTEST_SKIP() << "no libmodbus, or no port on 127.0.0.1";
  server.holding(0, 5);
  const auto link = std::make_shared<ModbusLink>(
      ModbusAddress{.host = "127.0.0.1", .port = server.port(), .device = ""});
  ModbusInput good(link, {.address = 0}, kPeriod_us);
  ModbusInput bad(link, {.address = 60'000}, kPeriod_us);
  EXPECT_TRUE(good.open()) << good.error();
  EXPECT_FALSE(bad.open());
  EXPECT_NE(std::string(bad.error()).find("no answer"), std::string::npos) << bad.error();
  EXPECT_TRUE(becomes(good, 5));
}

TEST(Modbus, AServerThatGoesIsMissedAndFoundAgain) {
  auto server = std::make_unique<ModbusServer>();
  if (!server->ready()) GTEST_SKIP() << "no libmodbus, or no port on 127.0.0.1";
  const std::uint16_t port = server->port();
  server->holding(0, 5);
  const auto link = std::make_shared<ModbusLink>(
      ModbusAddress{.host = "127.0.0.1", .port = port, .device = ""});
  ModbusInput input(link, {.address = 0}, kPeriod_us);
  ASSERT_TRUE(input.open()) << input.error();
  server.reset();
  double value = 0;
  for (int k = 0; k < 200 && input.read(value); ++k) std::this_thread::sleep_for(20ms);
  EXPECT_FALSE(input.read(value)) << "an old value is none";
  server = std::make_unique<ModbusServer>(port);
  ASSERT_TRUE(server->ready());
  server->holding(0, 6);
  EXPECT_TRUE(becomes(input, 6)) << input.error();
}

TEST(Modbus, RtuOverASerialLine) {
  ModbusServer server(ModbusServer::Line::kSerial);
  if (!server.ready()) GTEST_SKIP() << "no libmodbus, or no pseudo terminal";
  server.holding(3, 777);
  const auto link = std::make_shared<ModbusLink>(ModbusAddress{
      .host = "", .device = server.device(), .baud = 115'200, .parity = 'N'});
  ModbusInput input(link, {.address = 3}, kPeriod_us);
  (void)input.open();
  EXPECT_TRUE(becomes(input, 777)) << input.error();
}

TEST(Modbus, NobodyThereIsToldWithinASecond) {
  const auto link = std::make_shared<ModbusLink>(
      ModbusAddress{.host = "127.0.0.1", .port = 1, .device = ""});
  ModbusInput input(link, {}, kPeriod_us);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_FALSE(input.open());
  EXPECT_LT(std::chrono::steady_clock::now() - start, 2s);
  EXPECT_FALSE(std::string(input.error()).empty());
}

}  // namespace
}  // namespace hal
