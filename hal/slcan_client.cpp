#include "hal/slcan_client.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "hal/slcan.hpp"
#include "wire/text.hpp"

namespace hal {

std::optional<std::uint16_t> slcan_port(std::string_view name) {
  constexpr std::string_view kKind = "slcan:";
  if (!name.starts_with(kKind)) return std::nullopt;
  return wire::number_of<std::uint16_t>(name.substr(kKind.size())).value_or(0);
}

bool SlcanClient::fail(const char* what) {
  error_.set("slcan port %u: %s: %s; start the gateway, or name its port", port_, what,
             std::strerror(errno));
  socket_.reset();
  return false;
}

bool SlcanClient::open() {
  length_ = 0;
  socket_ = Descriptor(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (!socket_.valid()) return fail("no socket");
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port_);
  if (connect(socket_.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) < 0) {
    return fail("cannot connect");
  }
  const int on = 1;
  setsockopt(socket_.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  error_.clear();
  return true;
}

CanStatus SlcanClient::read(std::span<ReceivedFrame> out, std::size_t& count) {
  count = 0;
  if (!socket_.valid()) return CanStatus::kLost;
  std::array<char, 256> bytes;
  // A frame takes six bytes or more: what is read fits into `out`.
  const std::size_t room = std::min(bytes.size(), 6 * out.size());
  const ssize_t received = recv(socket_.get(), bytes.data(), room, MSG_DONTWAIT);
  if (received < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) {
    return CanStatus::kWait;
  }
  if (received <= 0) {
    (void)fail("connection lost");
    return CanStatus::kLost;
  }
  for (const char c : std::span(bytes).first(static_cast<std::size_t>(received))) {
    if (c != '\r' && c != '\a') {
      if (length_ < line_.size()) line_[length_++] = c;
      continue;
    }
    // "z" before a frame acknowledges one of ours.
    std::span<const char> line(line_.data(), length_);
    wire::CanFrame frame;
    if (parse_slcan(line, frame)) out[count++] = {0, frame};
    length_ = 0;
  }
  return count > 0 ? CanStatus::kOk : CanStatus::kWait;
}

CanStatus SlcanClient::write(const wire::CanFrame& frame) {
  if (!socket_.valid()) return CanStatus::kLost;
  std::array<char, kMaxSlcanLine> line;
  const std::size_t length = write_slcan(frame, line);
  if (length == 0) return CanStatus::kOk;
  const ssize_t sent = send(socket_.get(), line.data(), length, MSG_NOSIGNAL);
  if (sent == static_cast<ssize_t>(length)) return CanStatus::kOk;
  (void)fail("cannot send");
  return CanStatus::kLost;
}

}  // namespace hal
