#include "hal/socketcan.hpp"

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <ctime>

namespace hal {
namespace {

constexpr std::size_t kBatch = 32;
constexpr int kReceiveBytes = 1 << 20;

// A classic frame lies in the begin of the larger structure, field by field.
static_assert(offsetof(canfd_frame, len) == offsetof(can_frame, len) &&
              offsetof(canfd_frame, data) == offsetof(can_frame, data));

wire::CanFrame from_kernel(const canfd_frame& in, bool fd) {
  wire::CanFrame out;
  out.error = (in.can_id & CAN_ERR_FLAG) != 0;
  out.extended = !out.error && (in.can_id & CAN_EFF_FLAG) != 0;
  out.remote = !out.error && (in.can_id & CAN_RTR_FLAG) != 0;
  out.id = in.can_id & (out.extended || out.error ? CAN_EFF_MASK : CAN_SFF_MASK);
  out.fd = fd;
  out.brs = fd && (in.flags & CANFD_BRS) != 0;
  out.esi = fd && (in.flags & CANFD_ESI) != 0;
  out.dlc = std::min(in.len, fd ? wire::kMaxFdLength : wire::kMaxClassicLength);
  if (!out.remote) std::copy_n(in.data, out.dlc, out.data.begin());
  return out;
}

canfd_frame to_kernel(const wire::CanFrame& in) {
  canfd_frame out{};
  out.can_id =
      in.id | (in.extended ? CAN_EFF_FLAG : 0U) | (in.remote ? CAN_RTR_FLAG : 0U);
  out.len = in.dlc;
  if (in.brs) out.flags |= CANFD_BRS;
  std::copy_n(in.data.begin(), in.dlc, out.data);
  return out;
}

}  // namespace

SocketCan::SocketCan(std::string interface, std::vector<CanFilter> filters, bool needs_fd)
    : interface_(std::move(interface)),
      filters_(std::move(filters)),
      needs_fd_(needs_fd) {
  filters_.resize(std::min(filters_.size(), kMaxFilters));
}

bool SocketCan::fail(const char* what, const char* advice) {
  error_.set("%s: %s: %s; %s", interface_.c_str(), what, std::strerror(errno), advice);
  socket_.reset();
  return false;
}

bool SocketCan::open() {
  socket_ = Descriptor(socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW));
  if (!socket_.valid()) return fail("no CAN socket", "load the kernel module can-raw");
  socket_drops_ = 0;
  ifreq request{};
  interface_.copy(request.ifr_name, sizeof request.ifr_name - 1);
  if (ioctl(socket_.get(), SIOCGIFINDEX, &request) < 0) {
    return fail("no such interface", "`ip link` lists those there are");
  }
  std::array<can_filter, kMaxFilters> filters;
  for (std::size_t k = 0; k < filters_.size(); ++k) {
    const canid_t flag = filters_[k].extended ? CAN_EFF_FLAG : 0;
    const canid_t bits = filters_[k].extended ? CAN_EFF_MASK : CAN_SFF_MASK;
    filters[k] = {filters_[k].id | flag,
                  (filters_[k].mask & bits) | CAN_EFF_FLAG | CAN_RTR_FLAG};
  }
  const can_err_mask_t errors = CAN_ERR_BUSOFF | CAN_ERR_RESTARTED;
  const int on = 1;
  const auto option = [this](int level, int name, const void* value, std::size_t size) {
    return setsockopt(socket_.get(), level, name, value, static_cast<socklen_t>(size)) ==
           0;
  };
  if (!option(SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(),
              filters_.size() * sizeof filters[0]) ||
      !option(SOL_CAN_RAW, CAN_RAW_ERR_FILTER, &errors, sizeof errors) ||
      !option(SOL_CAN_RAW, CAN_RAW_FD_FRAMES, &on, sizeof on) ||
      !option(SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on) ||
      !option(SOL_SOCKET, SO_RXQ_OVFL, &on, sizeof on)) {
    return fail("socket option refused", "the kernel has to be 3.6 or newer");
  }
  // The system's limit may cut it; then a burst is lost sooner, and counted.
  (void)option(SOL_SOCKET, SO_RCVBUF, &kReceiveBytes, sizeof kReceiveBytes);
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = request.ifr_ifindex;
  if (bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) <
      0) {
    return fail("cannot bind", "is it a CAN interface, and up?");
  }
  // Binding to an interface that is down succeeds; only its flags tell.
  if (ioctl(socket_.get(), SIOCGIFFLAGS, &request) < 0 || !(request.ifr_flags & IFF_UP)) {
    errno = ENETDOWN;
    return fail("not up", "`ip link set up` by the administrator");
  }
  if (needs_fd_ && (ioctl(socket_.get(), SIOCGIFMTU, &request) < 0 ||
                    request.ifr_mtu < int{CANFD_MTU})) {
    errno = EPROTONOSUPPORT;
    return fail("a signal lies beyond the eighth byte, but the link has no CAN FD",
                "`ip link set … fd on` by the administrator");
  }
  error_.clear();
  return true;
}

CanStatus SocketCan::status_after(int error) {
  if (error == EAGAIN || error == EWOULDBLOCK || error == EINTR || error == ENOBUFS) {
    return CanStatus::kWait;
  }
  error_.set("%s: %s", interface_.c_str(), std::strerror(error));
  if (error == ENETDOWN) return CanStatus::kDown;
  socket_.reset();
  return CanStatus::kLost;
}

CanStatus SocketCan::read(std::span<ReceivedFrame> out, std::size_t& count) {
  count = 0;
  if (!socket_.valid()) return CanStatus::kLost;
  struct Slot {
    canfd_frame frame;
    iovec data;
    alignas(cmsghdr) char control[CMSG_SPACE(sizeof(timespec)) +
                                  CMSG_SPACE(sizeof(std::uint32_t))];
  };
  std::array<Slot, kBatch> slots;
  std::array<mmsghdr, kBatch> headers;
  const std::size_t most = std::min(out.size(), kBatch);
  for (std::size_t k = 0; k < most; ++k) {
    slots[k].data = {&slots[k].frame, sizeof slots[k].frame};
    headers[k] = {};
    headers[k].msg_hdr.msg_iov = &slots[k].data;
    headers[k].msg_hdr.msg_iovlen = 1;
    headers[k].msg_hdr.msg_control = slots[k].control;
    headers[k].msg_hdr.msg_controllen = sizeof slots[k].control;
  }
  const int received =
      recvmmsg(socket_.get(), headers.data(), static_cast<unsigned>(most), 0, nullptr);
  if (received < 0) return status_after(errno);
  for (int k = 0; k < received; ++k) {
    const bool fd = headers[k].msg_len == CANFD_MTU;
    if (!fd && headers[k].msg_len != CAN_MTU) continue;
    ReceivedFrame& frame = out[count++];
    frame.frame = from_kernel(slots[k].frame, fd);
    msghdr& header = headers[k].msg_hdr;
    for (cmsghdr* c = CMSG_FIRSTHDR(&header); c; c = CMSG_NXTHDR(&header, c)) {
      if (c->cmsg_level != SOL_SOCKET) continue;
      if (c->cmsg_type == SO_TIMESTAMPNS) {
        timespec stamp;
        std::memcpy(&stamp, CMSG_DATA(c), sizeof stamp);
        frame.time_us = std::int64_t{stamp.tv_sec} * 1'000'000 + stamp.tv_nsec / 1000;
      } else if (c->cmsg_type == SO_RXQ_OVFL) {
        std::uint32_t total = 0;
        std::memcpy(&total, CMSG_DATA(c), sizeof total);
        drops_ += total - socket_drops_;
        socket_drops_ = total;
      }
    }
  }
  return count > 0 ? CanStatus::kOk : CanStatus::kWait;
}

CanStatus SocketCan::write(const wire::CanFrame& frame) {
  if (!socket_.valid()) return CanStatus::kLost;
  const canfd_frame raw = to_kernel(frame);
  const ssize_t size = frame.fd ? CANFD_MTU : CAN_MTU;
  if (::write(socket_.get(), &raw, static_cast<std::size_t>(size)) == size) {
    return CanStatus::kOk;
  }
  return status_after(errno);
}

}  // namespace hal
