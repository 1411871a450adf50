#include "firmware/daemon_load.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <stdexcept>

#include "hal/clock.hpp"
#include "hal/slcan.hpp"
#include "workbench/simulate/scenarios.hpp"

namespace {

constexpr std::int64_t kTurn_us = 2'000;
constexpr std::int64_t kAskEvery_us = 100'000;
constexpr std::size_t kMostPending = 16'384;

std::int64_t now_us() {
  return hal::SystemClock().monotonic_us();
}

std::string write_configuration(const TemporaryFolder& folder, std::uint16_t port,
                                double sample_period_s) {
  std::ofstream(folder.file("load.toml"))
      << load_configuration("backend = \"slcan\"\nport = " + std::to_string(port) + '\n',
                            sample_period_s)
      << "[metrics]\npath = \"load.prom\"\nperiod_s = 1.0\n"
      << "[state]\npath = \"state\"\nperiod_s = 1.0\n[history]\npath = \"history\"\n";
  return folder.file("load.toml");
}

wire::CanFrame float_frame(std::uint32_t id, double value) {
  wire::CanFrame frame{.id = id, .dlc = 4, .data = {}};
  const auto number = static_cast<float>(value);
  std::copy_n(reinterpret_cast<const std::uint8_t*>(&number), 4, frame.data.begin());
  return frame;
}

}  // namespace

std::string load_configuration(const std::string& bus_lines, double sample_period_s) {
  std::string text = "[bus.can0]\n" + bus_lines + "[uds]\n[broadcast]\n";
  for (int id = 1; id <= kLoadLoops; ++id) {
    const auto signal = [id](const char* name, int offset) {
      return std::string(name) + " = { source = \"can\", frame_id = " +
             std::to_string(0x200 + 2 * id + offset) +
             ", start = 0, length = 32, is_float = true }\n";
    };
    text += "[[loop]]\nid = " + std::to_string(id) + "\ntag = \"L" + std::to_string(id) +
            "\"\nsample_period_s = " + std::to_string(sample_period_s) + '\n' +
            signal("u", 0) + signal("y", 1);
  }
  return text;
}

std::vector<workbench::SimulatedLoop> load_loops() {
  std::vector<workbench::SimulatedLoop> loops;
  for (int k = 0; k < kLoadLoops; ++k) {
    loops.push_back(*workbench::simulate(k % 2 ? "stiction" : "external-sinusoid",
                                         static_cast<std::uint64_t>(k + 1)));
  }
  return loops;
}

wire::CanFrame load_frame(const std::vector<workbench::SimulatedLoop>& loops,
                          std::size_t sample, int index) {
  // The loops are spread over the first part of the sample period.
  constexpr int kApart = 16;
  const auto loop = static_cast<std::size_t>(index / kApart);
  if (loop >= loops.size() || index % kApart > 1) {
    return float_frame(static_cast<std::uint32_t>(index % 256), 0);
  }
  const workbench::SimulatedLoop& source = loops[loop];
  const bool is_u = index % kApart == 0;
  const std::vector<double>& values = is_u ? source.u : source.y;
  return float_frame(static_cast<std::uint32_t>(0x202 + 2 * loop + (is_u ? 0 : 1)),
                     values[sample % values.size()]);
}

DaemonLoad::DaemonLoad(const std::string& daemon, double sample_period_s)
    : sample_period_s_(sample_period_s),
      port_(free_port()),
      loops_(load_loops()),
      process_(
          {daemon, "--config", write_configuration(folder_, port_, sample_period_s)}) {
  if (!process_.says("<5>started")) throw std::runtime_error(process_.err());
  connect_to(port_);
}

void DaemonLoad::connect_to(std::uint16_t port) {
  socket_ = hal::Descriptor(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  const int on = 1;
  if (connect(socket_.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) < 0 ||
      setsockopt(socket_.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on) < 0) {
    throw std::runtime_error("the daemon cannot be connected to");
  }
}

void DaemonLoad::put(const wire::CanFrame& frame) {
  std::array<char, hal::kMaxSlcanLine> text;
  pending_.append(text.data(), hal::write_slcan(frame, text));
  ++sent_;
}

void DaemonLoad::ask() {
  const std::int64_t now = now_us();
  if (waiting_ || now - asked_us_ < kAskEvery_us) return;
  put({.id = 0x7E0, .dlc = 8, .data = {3, 0x22, 0xF1, 0x86}});
  ++asked_;
  asked_us_ = now;
  waiting_ = true;
}

void DaemonLoad::take_line() {
  if (waiting_ && line_.starts_with("t7E8")) {
    waiting_ = false;
    ++answered_;
    slowest_s_ = std::max(slowest_s_, static_cast<double>(now_us() - asked_us_) * 1e-6);
  }
  line_.clear();
}

void DaemonLoad::exchange(int wait_ms) {
  pollfd waiting{socket_.get(), POLLIN, 0};
  if (!pending_.empty()) waiting.events |= POLLOUT;
  if (poll(&waiting, 1, wait_ms) <= 0) return;
  if ((waiting.revents & POLLIN) != 0) {
    std::array<char, 4096> bytes;
    const ssize_t count = read(socket_.get(), bytes.data(), bytes.size());
    if (count <= 0) throw std::runtime_error("the daemon hung up: " + process_.err());
    for (ssize_t k = 0; k < count; ++k) {
      const char c = bytes[static_cast<std::size_t>(k)];
      if (c == '\r') {
        take_line();
      } else {
        line_ += c;
      }
    }
  }
  if ((waiting.revents & POLLOUT) != 0) {
    const ssize_t count = send(socket_.get(), pending_.data(), pending_.size(),
                               MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count > 0) pending_.erase(0, static_cast<std::size_t>(count));
  }
}

void DaemonLoad::play(std::uint64_t frames, double per_s) {
  if (start_us_ == 0) start_us_ = now_us();
  const std::int64_t from_us = now_us();
  std::uint64_t given = 0;
  int index = 0;
  while (given < frames) {
    const std::int64_t now = now_us();
    const auto sample = static_cast<std::size_t>(static_cast<double>(now - start_us_) *
                                                 1e-6 / sample_period_s_);
    std::uint64_t due = frames;
    if (per_s > 0) {
      due = std::min(frames, static_cast<std::uint64_t>(
                                 static_cast<double>(now - from_us) * 1e-6 * per_s));
    }
    ask();
    while (given < due && pending_.size() < kMostPending) {
      put(load_frame(loops_, sample, index));
      index = (index + 1) % kLoadFrames;
      ++given;
    }
    exchange(per_s > 0 && pending_.empty() ? kTurn_us / 1000 : 10);
  }
  while (!pending_.empty()) exchange(10);
  for (int k = 0; k < 10 && waiting_; ++k) exchange(10);
}

double DaemonLoad::metric(const std::string& name) const {
  std::ifstream file(folder_.file("load.prom"));
  const std::string head = "stickband_loop_" + name + '{';
  double sum = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(head)) sum += std::stod(line.substr(line.rfind(' ')));
  }
  return sum;
}
