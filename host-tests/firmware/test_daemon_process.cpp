// The program as a whole: started, queried over slcan on TCP, reloaded, ended.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include "firmware/daemon_load.hpp"
#include "firmware/gateway_loop.hpp"
#include "firmware/process.hpp"
#include "hal/descriptor.hpp"

namespace {

using namespace std::chrono_literals;

using Result = Process::Result;

Result run(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), STICKBAND_DAEMON);
  return Process(arguments).wait();
}

// A tester on the slcan port: one request in a single frame, the lines that come back.
std::string exchange(std::uint16_t port, const std::string& line) {
  const hal::Descriptor socket(::socket(AF_INET, SOCK_STREAM, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  if (connect(socket.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
    return "no connection";
  }
  (void)!write(socket.get(), line.data(), line.size());
  std::string text;
  pollfd waiting{socket.get(), POLLIN, 0};
  while (text.find("t7E8") == std::string::npos && poll(&waiting, 1, 2000) > 0) {
    char bytes[256];
    const ssize_t count = read(socket.get(), bytes, sizeof bytes);
    if (count <= 0) break;
    text.append(bytes, static_cast<std::size_t>(count));
  }
  return text;
}

class Running : public testing::Test {
 protected:
  [[nodiscard]] std::string text(const std::string& more = "") const {
    return "[bus.log]\nbackend = \"file\"\npath = \"loop.log\"\n"
           "[bus.lab]\nbackend = \"slcan\"\nport = " +
           std::to_string(port) +
           "\n[uds]\nbus = \"lab\"\n[metrics]\npath = \"a.prom\"\nperiod_s = 1.0\n"
           "[[loop]]\nid = 1\ntag = \"FIC-211\"\nsample_period_s = 0.5\n"
           "u = { source = \"can\", bus = \"log\", dbc = \"loop.dbc\", message = "
           "\"LoopOP\", "
           "signal = \"OP\" }\n"
           "y = { source = \"can\", bus = \"log\", dbc = \"loop.dbc\", message = "
           "\"LoopPV\", "
           "signal = \"PV\" }\n" +
           more;
  }
  void write(const std::string& content) const { std::ofstream(path) << content; }

  GatewayLoop files{"paper-example-1", 1};
  std::uint16_t port = free_port();
  std::string path = files.folder() + "/lab.toml";
};

TEST_F(Running, IsQueriedReloadedAndEnded) {
  write(text());
  Process daemon({STICKBAND_DAEMON, "--config", path});
  ASSERT_TRUE(daemon.says("<5>started")) << daemon.err();
  EXPECT_NE(exchange(port, "t7E080322F18600000000\r").find("t7E8"), std::string::npos);
  EXPECT_NE(exchange(port, "t7E08023E000000000000\r").find("027E00"), std::string::npos);

  write(text("nonsense = 1\n"));
  daemon.signal(SIGHUP);
  EXPECT_TRUE(daemon.says("stays as it was")) << daemon.err();
  EXPECT_NE(daemon.err().find("lab.toml:"), std::string::npos);
  EXPECT_NE(exchange(port, "t7E08023E000000000000\r").find("027E00"), std::string::npos);

  write(text("gain_sign = \"positive\"\n"));
  daemon.signal(SIGHUP);
  EXPECT_TRUE(daemon.says("configuration loaded anew")) << daemon.err();
  EXPECT_NE(exchange(port, "t7E08023E000000000000\r").find("027E00"), std::string::npos);
  for (int k = 0; k < 100 && !std::filesystem::exists(files.folder() + "/a.prom"); ++k) {
    std::this_thread::sleep_for(50ms);
  }
  EXPECT_NE(text_of(files.folder() + "/a.prom").find("stickband_loop_frames"),
            std::string::npos);
  daemon.signal(SIGTERM);
  const Result result = daemon.wait();
  EXPECT_EQ(result.code, 0) << result.err;
}

TEST_F(Running, NeedsLittleMemory) {
#ifndef STICKBAND_COUNTER
  GTEST_SKIP() << "a sanitizer has an allocator of its own";
#endif
  std::string many = text();
  for (int id = 2; id <= 31; ++id) {
    std::string loop = text().substr(text().find("[[loop]]"));
    const std::string period = "sample_period_s = 0.5";
    loop.insert(loop.find(period) + period.size(), std::to_string(10 + id));
    many += "[[loop]]\nid = " + std::to_string(id) + "\ntag = \"L" + std::to_string(id) +
            '"' + loop.substr(loop.find("\nsample_period_s"));
  }
  write(many);
  Process daemon({STICKBAND_DAEMON, "--config", path});
  ASSERT_TRUE(daemon.says("<5>started")) << daemon.err();
  std::this_thread::sleep_for(300ms);
  const long kilobytes = daemon.memory_kib("VmRSS");
  ASSERT_GT(kilobytes, 0);
  RecordProperty("rss_kib", std::to_string(kilobytes));
  EXPECT_LE(kilobytes, 16 * 1024);
}

// The program under the counter of count_allocations.cpp.
class Counted {
 public:
  explicit Counted([[maybe_unused]] const std::string& file) : file_(file) {
#ifdef STICKBAND_COUNTER
    setenv("LD_PRELOAD", STICKBAND_COUNTER, 1);
    setenv("STICKBAND_ALLOCATIONS", file.c_str(), 1);
#endif
  }
  ~Counted() {
    unsetenv("LD_PRELOAD");
    unsetenv("STICKBAND_ALLOCATIONS");
  }
  [[nodiscard]] std::uint64_t allocations() const {
    const std::string bytes = text_of(file_);
    std::uint64_t count = 0;
    if (bytes.size() == sizeof count) std::memcpy(&count, bytes.data(), sizeof count);
    return count;
  }

 private:
  std::string file_;
};

TEST_F(Running, AllocatesNothingAfterItsStart) {
#ifndef STICKBAND_COUNTER
  GTEST_SKIP() << "a sanitizer has an allocator of its own";
#endif
  const Counted counted(files.folder() + "/allocations");
  DaemonLoad load(STICKBAND_DAEMON, 0.01);
  const std::uint64_t at_start = counted.allocations();
  ASSERT_GT(at_start, 100U) << "the counter counts";
  // Windows are filled and identified, queries answered, textfiles written …
  load.play(60'000, 8'000);
  EXPECT_GT(load.metric("verdict"), 0);
  EXPECT_GT(load.metric("frames"), 0);
  EXPECT_GT(load.answered(), 10U);
  // … testers come, ask for more than a frame holds, and go; rubbish comes.
  load.disconnect();
  for (int k = 0; k < 3; ++k) {
    EXPECT_NE(exchange(load.port(), "t7E080322FD1000000000\r").find("t7E881017"),
              std::string::npos);
    EXPECT_NE(exchange(load.port(), "rubbish\rt7E080322F18600000000\r").find("t7E8"),
              std::string::npos);
  }
  // … and the textfile cannot be written.
  std::filesystem::remove(load.folder() + "/load.prom");
  std::filesystem::create_directory(load.folder() + "/load.prom");
  EXPECT_TRUE(load.process().says("cannot be written"));
  EXPECT_EQ(counted.allocations(), at_start);
}

TEST(Loaded, DoesNotGrowUnderAFullBusAndAnswers) {
#ifdef STICKBAND_COUNTER
  constexpr long kMostGrowth_kib = 32;  // stacks of the threads that write files
  constexpr long kMost_kib = 16 * 1024;
#else
  constexpr long kMostGrowth_kib = 1024;  // the sanitizer's own
  constexpr long kMost_kib = 1024 * 1024;
#endif
  DaemonLoad load(STICKBAND_DAEMON, 0.01);
  // Of its own: code is read in when it is first used.
  const long before_kib = load.process().memory_kib("RssAnon");
  ASSERT_GT(before_kib, 1000);
  load.play(600'000, 0);
  EXPECT_LE(load.process().memory_kib("RssAnon"), before_kib + kMostGrowth_kib)
      << "what was reserved at the start is there at the start";
  EXPECT_LE(load.process().memory_kib("VmHWM"), kMost_kib);
  load.play(8'000, 8'000);
  EXPECT_GE(load.answered(), 1U);
  EXPECT_EQ(load.metric("dropped"), 0);
}

class Remembering : public Running {
 protected:
  void SetUp() override {
    const std::string signal =
        " = { source = \"can\", start = 0, length = 16, frame_id = ";
    write("[bus.lab]\nbackend = \"slcan\"\nport = " + std::to_string(port) +
          "\n[uds]\n[metrics]\npath = \"a.prom\"\nperiod_s = 1.0\n[state]\npath = "
          "\"state\"\nperiod_s = 1.0\n[[loop]]\nid = 1\ntag = \"A\"\nsample_period_s = "
          "0.1\nstale_after_s = 1.0\nu" +
          signal + "0x100 }\ny" + signal + "0x101 }\n");
  }
  // The input comes and goes: its DTC "message missing" is confirmed.
  void lose_input(Process& daemon) const {
    for (int k = 0; k < 10; ++k, std::this_thread::sleep_for(100ms)) {
      (void)exchange(port, "t10020A00\rt10120A00\rt7E08023E00CCCCCCCCCC\r");
    }
    ASSERT_TRUE(daemon.says("input fault")) << daemon.err();
  }
  [[nodiscard]] std::string confirmed() const {
    return exchange(port, "t7E0803190208CCCCCCCC\r");
  }
  // DTC "message missing" with these bits.
  [[nodiscard]] bool within(double seconds, const std::string& answer) const {
    for (int k = 0; k < seconds * 10; ++k, std::this_thread::sleep_for(100ms)) {
      if (confirmed().find(answer) != std::string::npos) return true;
    }
    return false;
  }
  std::string state = files.folder() + "/state";
};

TEST_F(Remembering, ConfirmedDtcsSurviveARestartAndAReload) {
  const std::string failing = "59027D5101872D";
  const std::string remembered = "59027D51018728";  // no failure any more
  {
    Process daemon({STICKBAND_DAEMON, "--config", path});
    ASSERT_TRUE(daemon.says("no saved state")) << daemon.err();
    ASSERT_TRUE(daemon.says("<5>started")) << daemon.err();
    lose_input(daemon);
    EXPECT_TRUE(within(3, failing)) << confirmed();
    daemon.signal(SIGTERM);
    EXPECT_EQ(daemon.wait().code, 0);
  }
  Process daemon({STICKBAND_DAEMON, "--config", path});
  ASSERT_TRUE(daemon.says("<5>started")) << daemon.err();
  EXPECT_TRUE(within(0.1, remembered)) << confirmed();
  lose_input(daemon);
  daemon.signal(SIGHUP);
  ASSERT_TRUE(daemon.says("configuration loaded anew"));
  EXPECT_TRUE(within(0.1, remembered)) << confirmed();
}

TEST_F(Remembering, ADamagedFileIsToldAndSetAside) {
  std::ofstream(state) << "SBST rubbish";
  Process daemon({STICKBAND_DAEMON, "--config", path});
  ASSERT_TRUE(daemon.says("<5>started")) << daemon.err();
  EXPECT_TRUE(daemon.says("<3>" + state + ": expected a saved state, found "))
      << daemon.err();
  EXPECT_EQ(text_of(state + ".bad"), "SBST rubbish");
  daemon.signal(SIGTERM);
  EXPECT_EQ(daemon.wait().code, 0);
  EXPECT_TRUE(text_of(state).starts_with("SBST"));
}

TEST_F(Remembering, WindowsOfSamplesComeBackOrAreSetAside) {
  const auto once = [&](const std::string& said) {
    Process daemon({STICKBAND_DAEMON, "--config", path});
    EXPECT_TRUE(daemon.says("<5>started")) << daemon.err();
    EXPECT_TRUE(said.empty() || daemon.says(said)) << daemon.err();
    lose_input(daemon);
    daemon.signal(SIGTERM);
    EXPECT_EQ(daemon.wait().code, 0);
    EXPECT_TRUE(text_of(state + ".windows").starts_with("SBWI"));
  };
  once("");
  once("windows of samples that are back: 1");
  std::ofstream(state + ".windows") << "SBWI rubbish";
  once("<3>" + state + ".windows: expected windows, found ");
  EXPECT_EQ(text_of(state + ".windows.bad"), "SBWI rubbish");
}

TEST_F(Remembering, TwoBusesFeedOneLoop) {
  const std::uint16_t second = free_port();
  const std::string signal = " start = 0, length = 16, frame_id = 0x100 }\n";
  write(
      "[bus.can0]\nbackend = \"slcan\"\nport = " + std::to_string(port) +
      "\n[bus.can1]\nbackend = \"slcan\"\nport = " + std::to_string(second) +
      "\n[uds]\nbus = \"can1\"\n[metrics]\npath = \"a.prom\"\nperiod_s = 1.0\n[[loop]]\n"
      "id = 1\ntag = \"A\"\nsample_period_s = 0.1\n"
      "u = { source = \"can\", bus = \"can0\"," +
      signal + "y = { source = \"can\", bus = \"can1\"," + signal);
  const Process daemon({STICKBAND_DAEMON, "--config", path});
  ASSERT_TRUE(daemon.says("<5>started")) << daemon.err();
  const std::string query = "t7E08023E00CCCCCCCCCC\r";
  std::string metrics;
  const auto shows = [&](const std::string& line) {
    return metrics.find(line) != std::string::npos;
  };
  for (int k = 0; k < 40 && !shows("_pct{loop=\"1\",tag=\"A\"} 60\n"); ++k) {
    // The same identifier on both: 40 is u, 60 is y. The tester is on the second one.
    EXPECT_EQ(exchange(port, "t10022800\r"), "z\r") << "no diagnostics here";
    EXPECT_NE(::exchange(second, "t10023C00\r" + query).find("027E00"),
              std::string::npos);
    metrics = text_of(files.folder() + "/a.prom");
  }
  EXPECT_TRUE(shows("stickband_loop_u_pct{loop=\"1\",tag=\"A\"} 40\n")) << metrics;
  EXPECT_TRUE(shows("stickband_loop_y_pct{loop=\"1\",tag=\"A\"} 60\n")) << metrics;
}

TEST_F(Remembering, AnEmptyFileIsADamagedOne) {
  std::ofstream(state).flush();
  Process daemon({STICKBAND_DAEMON, "--config", path});
  ASSERT_TRUE(daemon.says("<5>started")) << daemon.err();
  EXPECT_TRUE(daemon.says("<3>" + state + ": expected a saved state, found "))
      << daemon.err();
  EXPECT_TRUE(std::filesystem::exists(state + ".bad"));
}

TEST_F(Remembering, TheStateFileBelongsToOneDaemon) {
  Process first({STICKBAND_DAEMON, "--config", path});
  ASSERT_TRUE(first.says("<5>started")) << first.err();
  const Result second = run({"--config", path});
  EXPECT_EQ(second.code, 1);
  EXPECT_NE(second.err.find("state: expected a state file of its own"), std::string::npos)
      << second.err;
  EXPECT_EQ(run({"--config", path, "--check", "--offline"}).code, 0);
}

TEST_F(Remembering, AFileThatCannotBeWrittenIsToldCountedAndOvercome) {
  std::filesystem::create_directories(state + ".new/inside");
  Process daemon({STICKBAND_DAEMON, "--config", path});
  ASSERT_TRUE(daemon.says(state + ": cannot be written: ")) << daemon.err();
  const std::string told = "stickband_gateway_state_failures 1\n";
  for (int k = 0;
       k < 50 && text_of(files.folder() + "/a.prom").find(told) == std::string::npos;
       ++k) {
    std::this_thread::sleep_for(100ms);
  }
  EXPECT_NE(text_of(files.folder() + "/a.prom").find(told), std::string::npos);
  std::filesystem::remove_all(state + ".new");
  for (int k = 0; k < 50 && !std::filesystem::exists(state); ++k) {
    std::this_thread::sleep_for(100ms);
  }
  EXPECT_TRUE(text_of(state).starts_with("SBST"));
}

TEST_F(Running, MissingDevicesAreRefusedAtTheStartAndByCheck) {
  for (const std::string& option : {std::string("--check"), std::string()}) {
    std::vector<std::string> arguments = {"--config", files.toml()};
    if (!option.empty()) arguments.push_back(option);
    const Result result = run(arguments);
    EXPECT_EQ(result.code, option.empty() ? 1 : 3) << "it may come later";
    for (const char* part : {"gateway.toml:3: bus.can0: expected a device", "can0",
                             "loop[1].flag", "gpiochip0 line 3"}) {
      EXPECT_NE(result.err.find(part), std::string::npos) << part << '\n' << result.err;
    }
  }
  const Result desk = run({"--config", files.toml(), "--check", "--offline"});
  EXPECT_EQ(desk.code, 0) << desk.err;
  write(text());
  const Result good = run({"--config", path, "--check"});
  EXPECT_EQ(good.code, 0) << good.err;
  EXPECT_EQ(run({"--config", path, "--offline"}).code, 2);
}

TEST_F(Running, ALateDeviceIsNotTriedAllTheTimeByAServiceManager) {
  setenv("NOTIFY_SOCKET", "/nobody/listens", 1);
  const auto began = std::chrono::steady_clock::now();
  const Result result = run({"--config", files.toml()});
  unsetenv("NOTIFY_SOCKET");
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_GE(std::chrono::steady_clock::now() - began, std::chrono::seconds(1));
}

TEST_F(Running, CheckFindsWhatWouldFailAtRunTime) {
  write(text("[state]\npath = \"none/state\"\n"));
  const Result missing = run({"--config", path, "--check"});
  EXPECT_EQ(missing.code, 3);
  EXPECT_NE(missing.err.find("state.path: expected a folder"), std::string::npos)
      << missing.err;
  const Result desk = run({"--config", path, "--check", "--offline"});
  EXPECT_EQ(desk.code, 0);
  EXPECT_NE(desk.err.find("state.path: expected a folder"), std::string::npos);
  write(text("[state]\npath = \".\"\n"));
  EXPECT_EQ(run({"--config", path, "--check", "--offline"}).code, 3);
  write(text("[state]\npath = \"lab.toml\"\n"));
  EXPECT_EQ(run({"--config", path, "--check", "--offline"}).code, 3);
}

TEST_F(Running, AReloadWhoseBusCannotBeOpenedKeepsWhatWorks) {
  write(text());
  Process daemon({STICKBAND_DAEMON, "--config", path});
  ASSERT_TRUE(daemon.says("<5>started")) << daemon.err();
  write(text("[bus.other]\nbackend = \"socketcan\"\ninterface = \"none0\"\n"));
  daemon.signal(SIGHUP);
  EXPECT_TRUE(daemon.says("stays as it was")) << daemon.err();
  EXPECT_NE(daemon.err().find("none0"), std::string::npos);
  EXPECT_NE(exchange(port, "t7E08023E000000000000\r").find("027E00"), std::string::npos);
  EXPECT_EQ(daemon.err().find("is down"), std::string::npos) << daemon.err();
}

TEST_F(Running, ARecordedBusIsPlayedOnceAndAnewAfterAReload) {
  std::ofstream(files.log()) << "(1.0) can0 18E#00000000\n";
  write(text());
  Process daemon({STICKBAND_DAEMON, "--config", path});
  ASSERT_TRUE(daemon.says("the log has ended")) << daemon.err();
  std::this_thread::sleep_for(500ms);  // five times the first wait for a bus that is away
  const auto ends = [&daemon] {
    const std::string said = daemon.err();
    std::size_t count = 0;
    for (std::size_t at = said.find("log has ended"); at != std::string::npos;
         at = said.find("log has ended", at + 1)) {
      ++count;
    }
    return count;
  };
  EXPECT_EQ(ends(), 1U) << daemon.err();
  EXPECT_EQ(daemon.err().find("real_time"), std::string::npos) << daemon.err();
  std::string fast = text();
  fast.insert(fast.find("[bus.lab]"), "real_time = false\n");
  write(fast);
  daemon.signal(SIGHUP);
  ASSERT_TRUE(daemon.says("configuration loaded anew")) << daemon.err();
  EXPECT_NE(daemon.err().find("bus.log: expected a log in real time"), std::string::npos)
      << daemon.err();
  for (int k = 0; k < 100 && ends() < 2; ++k) std::this_thread::sleep_for(20ms);
  EXPECT_EQ(ends(), 2U) << daemon.err();
}

TEST_F(Running, ReplaysAndAnswersWithTheContractsExitCodes) {
  const Result json = run(
      {"--config", files.toml(), "--replay", files.log(), "--json", "--ask", "22FD10"});
  EXPECT_EQ(json.code, 0) << json.err;
  EXPECT_NE(json.out.find("\"event\":\"stiction_raised\""), std::string::npos);
  EXPECT_NE(json.out.find("\"event\":\"flag_raised\""), std::string::npos);
  EXPECT_NE(json.out.find("\"gpio\":1"), std::string::npos);
  EXPECT_NE(json.out.find("\"answer\":\"62FD1004"), std::string::npos) << json.out;
  EXPECT_EQ(run({}).code, 2);
  EXPECT_EQ(run({"--config", files.toml(), "--replay", files.log(), "--ask", "2"}).code,
            2);
  EXPECT_EQ(run({"--config", "none.toml"}).code, 3);
  const Result missing = run({"--config", files.toml(), "--replay", "none.log"});
  EXPECT_EQ(missing.code, 3);
  EXPECT_NE(missing.err.find("none.log"), std::string::npos);
  std::ofstream(files.log()) << "(1.0) can0 18E#00000000\nrubbish\n";
  const Result broken = run({"--config", files.toml(), "--replay", files.log()});
  EXPECT_EQ(broken.code, 3);
  EXPECT_NE(broken.err.find("loop.log:2:"), std::string::npos) << broken.err;
  EXPECT_EQ(run({"--version"}).code, 0);
}

TEST_F(Running, TheHostProgramReadsALogWithTheSameConfiguration) {
  const auto stickband = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {STICKBAND_BIN, "monitor", files.log(), "--json",
                                      "--config"};
    words.insert(words.end(), more.begin(), more.end());
    return Process(words).wait();
  };
  const Result result = stickband({files.toml()});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("\"event\":\"stiction_raised\""), std::string::npos);
  EXPECT_NE(result.out.find("\"verdict\":\"stiction\""), std::string::npos);
  EXPECT_EQ(stickband({files.toml(), "--loop", "1"}).code, 0);
  EXPECT_EQ(stickband({files.toml(), "--loop", "2"}).code, 2);
  EXPECT_EQ(stickband({files.toml(), "--u", "A.B"}).code, 2);
  const Result missing = stickband({"none.toml"});
  EXPECT_EQ(missing.code, 3);
  EXPECT_NE(missing.err.find("none.toml"), std::string::npos);
}

}  // namespace
