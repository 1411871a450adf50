#include "workbench/cli/can_port.hpp"

#include <poll.h>

#include <chrono>
#include <thread>

#include "hal/slcan_client.hpp"
#include "hal/socketcan.hpp"
#include "workbench/cli/exit_code.hpp"

namespace workbench::cli {
namespace {

std::unique_ptr<hal::CanBus> bus_of(const std::string& name, std::uint32_t id,
                                    bool extended) {
  const std::optional<std::uint16_t> port = hal::slcan_port(name);
  if (!port) {
    return std::make_unique<hal::SocketCan>(name,
                                            std::vector{hal::CanFilter{id, extended}});
  }
  if (*port == 0) throw UsageError("--can: expected slcan:PORT, found '" + name + "'");
  return std::make_unique<hal::SlcanClient>(*port);
}

}  // namespace

CanPort::CanPort(const std::string& name, std::uint32_t id, bool extended)
    : name_(name), bus_(bus_of(name, id, extended)) {
  if (!bus_->open()) fail();
}

void CanPort::fail() const {
  throw DeviceError(bus_->error());
}

void CanPort::send(const wire::CanFrame& frame) {
  constexpr int kTries = 1000;
  for (int k = 0; k < kTries; ++k) {
    switch (bus_->write(frame)) {
      case hal::CanStatus::kOk:
        return;
      case hal::CanStatus::kWait:
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        break;
      default:
        fail();
    }
  }
  throw DeviceError(name_ +
                    ": expected room to send within 1 s, found none; is anybody "
                    "else on the bus?");
}

std::optional<wire::CanFrame> CanPort::receive(std::int64_t wait_us) {
  if (next_ == count_) {
    next_ = count_ = 0;
    pollfd waiting{bus_->descriptor(), POLLIN, 0};
    (void)::poll(&waiting, 1, static_cast<int>((wait_us + 999) / 1000));
    const hal::CanStatus status = bus_->read(frames_, count_);
    if (status != hal::CanStatus::kOk && status != hal::CanStatus::kWait) fail();
    if (count_ == 0) return std::nullopt;
  }
  return frames_[next_++].frame;
}

}  // namespace workbench::cli
