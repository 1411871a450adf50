// The program with a loop whose u and y are registers of a Modbus server.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>
#include <thread>

#include "firmware/modbus_server.hpp"
#include "firmware/process.hpp"

namespace {

using namespace std::chrono_literals;

// u and y of one loop; its metrics go to a.prom beside the file.
void write_configuration(const std::string& path, int port) {
  const std::string place =
      "source = \"modbus\", host = \"127.0.0.1\", port = " + std::to_string(port);
  std::ofstream(path)
      << "[metrics]\npath = \"a.prom\"\nperiod_s = 1.0\n[[loop]]\nid = 1\ntag = \"A\"\n"
         "sample_period_s = 0.1\nstale_after_s = 5.0\nu = { "
      << place << ", address = 100, scale = 0.01 }\ny = { " << place
      << ", table = \"input\", address = 7, scale = 0.1 }\n"
      << std::flush;
}

bool shows(const std::string& metrics, const std::string& line, int tries = 50) {
  for (int k = 0; k < tries; ++k, std::this_thread::sleep_for(100ms)) {
    if (text_of(metrics).find(line) != std::string::npos) return true;
  }
  return false;
}

TEST(ModbusGateway, SamplesTheRegistersOfARealServer) {
  firmware::ModbusServer server;
  if (!server.ready()) GTEST_SKIP() << "no libmodbus, or no port on 127.0.0.1";
  server.holding(100, 4250);
  server.input(7, 615);
  const TemporaryFolder files;
  write_configuration(files.file("g.toml"), server.port());
  const std::string metrics = files.file("a.prom");
  const Process daemon({STICKBAND_DAEMON, "--config", files.file("g.toml")});
  ASSERT_TRUE(daemon.says("started")) << daemon.err();
  EXPECT_TRUE(shows(metrics, "stickband_loop_u_pct{loop=\"1\",tag=\"A\"} 42.5\n"));
  EXPECT_TRUE(shows(metrics, "stickband_loop_y_pct{loop=\"1\",tag=\"A\"} 61.5\n"));
  server.holding(100, 5000);
  EXPECT_TRUE(shows(metrics, "stickband_loop_u_pct{loop=\"1\",tag=\"A\"} 50\n"));
}

TEST(ModbusGateway, StartsWithoutAServerThatDoesNotAnswerAndTakesItWhenItComes) {
  const std::uint16_t port = free_port();
  if (port == 0) GTEST_SKIP() << "no port on 127.0.0.1";
  const TemporaryFolder files;
  write_configuration(files.file("g.toml"), port);
  const std::string metrics = files.file("a.prom");
  const std::string server_name = "127.0.0.1:" + std::to_string(port);
  Process checked({STICKBAND_DAEMON, "--config", files.file("g.toml"), "--check"});
  const Process::Result check = checked.wait();
  EXPECT_EQ(check.code, 3);
  EXPECT_NE(check.err.find(server_name), std::string::npos) << check.err;
  const Process daemon({STICKBAND_DAEMON, "--config", files.file("g.toml")});
  ASSERT_TRUE(daemon.says("started")) << daemon.err();
  EXPECT_TRUE(daemon.says("loop[1].u: expected a device, found that " + server_name))
      << daemon.err();
  firmware::ModbusServer server(port);
  if (!server.ready()) GTEST_SKIP() << "no libmodbus, or the port was taken";
  server.holding(100, 4250);
  server.input(7, 615);
  EXPECT_TRUE(shows(metrics, "stickband_loop_u_pct{loop=\"1\",tag=\"A\"} 42.5\n", 150))
      << daemon.err();
}

}  // namespace
