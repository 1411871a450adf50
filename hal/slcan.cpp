#include "hal/slcan.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "wire/text.hpp"

namespace hal {
namespace {

constexpr char kHex[] = "0123456789ABCDEF";

}  // namespace

std::size_t write_slcan(const wire::CanFrame& frame, std::span<char, kMaxSlcanLine> out) {
  if (frame.error || frame.fd || !wire::is_valid(frame)) return 0;
  std::size_t n = 0;
  out[n++] = frame.remote ? (frame.extended ? 'R' : 'r') : (frame.extended ? 'T' : 't');
  for (int digit = frame.extended ? 7 : 2; digit >= 0; --digit) {
    out[n++] = kHex[(frame.id >> (4 * digit)) & 0xF];
  }
  out[n++] = kHex[frame.dlc];
  for (std::size_t k = 0; k < frame.dlc && !frame.remote; ++k) {
    out[n++] = kHex[frame.data[k] >> 4];
    out[n++] = kHex[frame.data[k] & 0xF];
  }
  out[n++] = '\r';
  return n;
}

bool parse_slcan(std::span<const char> line, wire::CanFrame& out) {
  if (line.empty()) return false;
  out = {};
  const char kind = line[0];
  out.extended = kind == 'T' || kind == 'R';
  out.remote = kind == 'r' || kind == 'R';
  if (!out.extended && !out.remote && kind != 't') return false;
  const std::size_t digits = out.extended ? 8 : 3;
  if (line.size() < digits + 2) return false;
  for (std::size_t k = 1; k <= digits; ++k) {
    const int value = wire::hex_value(line[k]);
    if (value < 0) return false;
    out.id = out.id << 4 | static_cast<std::uint32_t>(value);
  }
  const int dlc = wire::hex_value(line[digits + 1]);
  if (dlc < 0 || dlc > wire::kMaxClassicLength) return false;
  out.dlc = static_cast<std::uint8_t>(dlc);
  const std::size_t data = digits + 2;
  const std::size_t bytes = out.remote ? 0 : out.dlc;
  // Four more digits are a time stamp, which is not needed.
  if (line.size() != data + 2 * bytes && line.size() != data + 2 * bytes + 4)
    return false;
  for (std::size_t k = 0; k < bytes; ++k) {
    const int high = wire::hex_value(line[data + 2 * k]);
    const int low = wire::hex_value(line[data + 2 * k + 1]);
    if (high < 0 || low < 0) return false;
    out.data[k] = static_cast<std::uint8_t>(high << 4 | low);
  }
  return wire::is_valid(out);
}

bool SlcanServer::fail(const char* what) {
  error_.set("slcan port %u: %s: %s; free the port or name another", port_, what,
             std::strerror(errno));
  listener_.reset();
  events_.reset();
  return false;
}

bool SlcanServer::open() {
  for (Client& client : clients_) client = Client{};
  events_ = Descriptor(epoll_create1(EPOLL_CLOEXEC));
  listener_ = Descriptor(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!events_.valid() || !listener_.valid()) return fail("no socket");
  const int on = 1;
  setsockopt(listener_.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port_);
  socklen_t size = sizeof address;
  if (bind(listener_.get(), reinterpret_cast<sockaddr*>(&address), size) < 0 ||
      listen(listener_.get(), 4) < 0 ||
      getsockname(listener_.get(), reinterpret_cast<sockaddr*>(&address), &size) < 0) {
    return fail("cannot listen");
  }
  port_ = ntohs(address.sin_port);
  epoll_event event{.events = EPOLLIN, .data = {}};
  if (epoll_ctl(events_.get(), EPOLL_CTL_ADD, listener_.get(), &event) < 0) {
    return fail("cannot wait");
  }
  error_.clear();
  return true;
}

void SlcanServer::accept_client() {
  for (std::size_t tries = 0; tries <= kClients; ++tries) {
    Descriptor socket(
        accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!socket.valid()) return;
    const auto client = std::find_if(clients_.begin(), clients_.end(),
                                     [](const Client& c) { return !c.socket.valid(); });
    // One that waited would wake us for ever: it is closed.
    if (client == clients_.end()) continue;
    const int on = 1;
    setsockopt(socket.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    epoll_event event{.events = EPOLLIN, .data = {}};
    if (epoll_ctl(events_.get(), EPOLL_CTL_ADD, socket.get(), &event) == 0) {
      *client = Client{.socket = std::move(socket), .line = {}};
    }
  }
}

void SlcanServer::send(Client& client, std::span<const char> text) {
  const ssize_t sent =
      ::send(client.socket.get(), text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent == static_cast<ssize_t>(text.size())) return;
  // Half a line would spoil the next one.
  if (sent < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
  client = Client{};
}

void SlcanServer::answer(Client& client, std::span<const char> text) {
  if (client.answered + text.size() > client.answers.size()) send_answers(client);
  if (!client.socket.valid()) return;
  std::copy(text.begin(), text.end(),
            client.answers.begin() + static_cast<std::ptrdiff_t>(client.answered));
  client.answered += text.size();
}

void SlcanServer::send_answers(Client& client) {
  const std::size_t size = std::exchange(client.answered, 0);
  if (size > 0) send(client, std::span(client.answers).first(size));
}

void SlcanServer::take_line(Client& client, Sink& sink) {
  const std::span<const char> line(client.line.data(), client.length);
  if (line.empty()) return answer(client, std::string_view("\r"));
  wire::CanFrame frame;
  if (parse_slcan(line, frame)) {
    if (sink.count < sink.out.size()) {
      sink.out[sink.count++] = {clock_.realtime_us(), frame};
    } else {
      ++drops_;
    }
    answer(client, std::string_view(frame.extended ? "Z\r" : "z\r"));
    std::array<char, kMaxSlcanLine> text;
    const std::size_t length = write_slcan(frame, text);
    for (Client& other : clients_) {
      if (&other != &client && other.socket.valid()) {
        send(other, std::span(text).first(length));
      }
    }
    return;
  }
  constexpr std::string_view kAnswered = "OLCSsZ";
  if (kAnswered.find(line[0]) != std::string_view::npos) {
    answer(client, std::string_view("\r"));
  } else if (line[0] == 'V' || line[0] == 'v') {
    answer(client, std::string_view("V1013\r"));
  } else if (line[0] == 'N') {
    answer(client, std::string_view("N0000\r"));
  } else if (line[0] == 'F') {
    answer(client, std::string_view("F00\r"));
  } else {
    answer(client, std::string_view("\a"));
  }
}

void SlcanServer::receive(Client& client, Sink& sink) {
  std::array<char, 2048> bytes;
  // A frame takes six bytes or more: what is read fits into what is left of the sink.
  const std::size_t room = std::min(bytes.size(), 6 * (sink.out.size() - sink.count));
  if (room == 0) return;
  const ssize_t count = recv(client.socket.get(), bytes.data(), room, MSG_DONTWAIT);
  if (count <= 0) {
    if (count == 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)) {
      client = Client{};
    }
    return;
  }
  for (ssize_t k = 0; k < count && client.socket.valid(); ++k) {
    const char c = bytes[static_cast<std::size_t>(k)];
    if (c == '\n') continue;
    if (c == '\r') {
      if (client.overlong) {
        answer(client, std::string_view("\a"));
      } else {
        take_line(client, sink);
      }
      client.length = 0;
      client.overlong = false;
    } else if (client.length < client.line.size()) {
      client.line[client.length++] = c;
    } else {
      client.overlong = true;
    }
  }
  if (client.socket.valid()) send_answers(client);
}

CanStatus SlcanServer::read(std::span<ReceivedFrame> out, std::size_t& count) {
  count = 0;
  if (!listener_.valid()) return CanStatus::kLost;
  accept_client();
  Sink sink{out};
  for (Client& client : clients_) {
    if (client.socket.valid()) receive(client, sink);
  }
  count = sink.count;
  return count > 0 ? CanStatus::kOk : CanStatus::kWait;
}

CanStatus SlcanServer::write(const wire::CanFrame& frame) {
  if (!listener_.valid()) return CanStatus::kLost;
  std::array<char, kMaxSlcanLine> text;
  const std::size_t length = write_slcan(frame, text);
  for (Client& client : clients_) {
    if (client.socket.valid()) send(client, std::span(text).first(length));
  }
  return CanStatus::kOk;
}

}  // namespace hal
