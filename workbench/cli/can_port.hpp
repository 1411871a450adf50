// A CAN bus by its name on the command line.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "hal/can_bus.hpp"
#include "hal/clock.hpp"
#include "workbench/pull/uds_client.hpp"

namespace workbench::cli {

/// "can0", an interface of the kernel, or "slcan:PORT", the lab bus of a gateway on this
/// machine.
class CanPort final : public FramePort {
 public:
  /// Opens the bus for one identifier. Throws DeviceError.
  CanPort(const std::string& name, std::uint32_t id, bool extended);

  void send(const wire::CanFrame& frame) override;
  std::optional<wire::CanFrame> receive(std::int64_t wait_us) override;
  [[nodiscard]] std::int64_t now_us() const override { return clock_.monotonic_us(); }

 private:
  [[noreturn]] void fail() const;

  std::string name_;
  hal::SystemClock clock_;
  std::unique_ptr<hal::CanBus> bus_;
  std::array<hal::ReceivedFrame, 64> frames_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace workbench::cli
