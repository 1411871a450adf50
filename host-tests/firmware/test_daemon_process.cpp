// The program as a whole: started, queried over slcan on TCP, reloaded, ended.
#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "firmware/gateway_loop.hpp"
#include "hal/descriptor.hpp"

namespace {

using namespace std::chrono_literals;

struct Result {
  int code = -1;
  std::string out;
  std::string err;
};

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// A child process with its output in files.
class Process {
 public:
  explicit Process(const std::vector<std::string>& arguments) {
    std::string folder =
        (std::filesystem::temp_directory_path() / "process-XXXXXX").string();
    folder_ = mkdtemp(folder.data());
    std::vector<char*> words;
    for (const std::string& argument : arguments) {
      words.push_back(const_cast<char*>(argument.c_str()));
    }
    words.push_back(nullptr);
    id_ = fork();
    if (id_ == 0) {
      dup2(open((folder_ + "/out").c_str(), O_CREAT | O_WRONLY, 0600), 1);
      dup2(open((folder_ + "/err").c_str(), O_CREAT | O_WRONLY, 0600), 2);
      execv(words[0], words.data());
      _exit(127);
    }
  }
  ~Process() {
    if (id_ > 0) {
      kill(id_, SIGKILL);
      waitpid(id_, nullptr, 0);
    }
    std::filesystem::remove_all(folder_);
  }
  void signal(int number) const { kill(id_, number); }
  [[nodiscard]] std::string err() const { return text_of(folder_ + "/err"); }
  // Waits until `text` stands in stderr.
  [[nodiscard]] bool says(const std::string& text) const {
    for (int k = 0; k < 200; ++k, std::this_thread::sleep_for(50ms)) {
      if (err().find(text) != std::string::npos) return true;
    }
    return false;
  }
  Result wait() {
    int status = 0;
    waitpid(id_, &status, 0);
    id_ = -1;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(folder_ + "/out"),
            err()};
  }
  [[nodiscard]] pid_t id() const { return id_; }

 private:
  std::string folder_;
  pid_t id_ = -1;
};

Result run(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), STICKBAND_DAEMON);
  return Process(arguments).wait();
}

std::uint16_t free_port() {
  const hal::Descriptor socket(::socket(AF_INET, SOCK_STREAM, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  (void)bind(socket.get(), reinterpret_cast<sockaddr*>(&address), size);
  (void)getsockname(socket.get(), reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.sin_port);
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
  std::string many = text();
  for (int id = 2; id <= 31; ++id) {
    const std::string loop = text().substr(text().find("[[loop]]"));
    many += "[[loop]]\nid = " + std::to_string(id) + "\ntag = \"L" + std::to_string(id) +
            '"' + loop.substr(loop.find("\nsample_period_s"));
  }
  write(many);
  Process daemon({STICKBAND_DAEMON, "--config", path});
  ASSERT_TRUE(daemon.says("<5>started")) << daemon.err();
  std::this_thread::sleep_for(300ms);
  const std::string status = text_of("/proc/" + std::to_string(daemon.id()) + "/status");
  const std::size_t at = status.find("VmRSS:");
  ASSERT_NE(at, std::string::npos);
  const int kilobytes = std::stoi(status.substr(at + 6));
  RecordProperty("rss_kib", kilobytes);
  EXPECT_LE(kilobytes, 16 * 1024);
}

TEST_F(Running, MissingDevicesAreRefusedAtTheStartAndByCheck) {
  for (const std::string& option : {std::string("--check"), std::string()}) {
    std::vector<std::string> arguments = {"--config", files.toml()};
    if (!option.empty()) arguments.push_back(option);
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 3);
    for (const char* part : {"gateway.toml:3: bus.can0: expected a device", "can0",
                             "loop[1].flag", "gpiochip0 line 3"}) {
      EXPECT_NE(result.err.find(part), std::string::npos) << part << '\n' << result.err;
    }
  }
  write(text());
  const Result good = run({"--config", path, "--check"});
  EXPECT_EQ(good.code, 0) << good.err;
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
