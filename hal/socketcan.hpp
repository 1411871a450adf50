// A CAN interface of the kernel: raw frames, classic and CAN FD, kernel time stamps,
// counted drops.
//
// Only the filtered identifiers and the error frames that tell of bus-off and restart are
// received. The link itself (bit rate, up, down) is the administrator's.
#pragma once

#include <string>
#include <vector>

#include "hal/can_bus.hpp"
#include "hal/descriptor.hpp"
#include "hal/message.hpp"

namespace hal {

class SocketCan final : public CanBus {
 public:
  /// At most kMaxFilters filters. `needs_fd`: open() refuses a link without CAN FD.
  static constexpr std::size_t kMaxFilters = 512;
  SocketCan(std::string interface, std::vector<CanFilter> filters, bool needs_fd = false);

  [[nodiscard]] bool open() override;
  [[nodiscard]] CanStatus read(std::span<ReceivedFrame> out, std::size_t& count) override;
  [[nodiscard]] CanStatus write(const wire::CanFrame& frame) override;
  [[nodiscard]] int descriptor() const override { return socket_.get(); }
  [[nodiscard]] std::uint64_t drops() const override { return drops_; }
  [[nodiscard]] const char* error() const override { return error_.c_str(); }

 private:
  bool fail(const char* what, const char* advice);
  CanStatus status_after(int error);

  std::string interface_;
  std::vector<CanFilter> filters_;
  bool needs_fd_;
  Descriptor socket_;
  std::uint64_t drops_ = 0;
  std::uint32_t socket_drops_ = 0;  // as the open socket counts them
  Message error_;
};

}  // namespace hal
