// A CAN bus in memory.
#pragma once

#include <deque>
#include <vector>

#include "hal/can_bus.hpp"

namespace hal {

class FakeCan final : public CanBus {
 public:
  [[nodiscard]] bool open() override {
    ++opened;
    incoming.clear();
    is_open = present;
    return present;
  }
  [[nodiscard]] CanStatus read(std::span<ReceivedFrame> out,
                               std::size_t& count) override {
    count = 0;
    if (!is_open) return CanStatus::kLost;
    if (down) return CanStatus::kDown;
    while (count < out.size() && !incoming.empty()) {
      out[count++] = incoming.front();
      incoming.pop_front();
    }
    return count > 0 ? CanStatus::kOk : CanStatus::kWait;
  }
  [[nodiscard]] CanStatus write(const wire::CanFrame& frame) override {
    if (!is_open) return CanStatus::kLost;
    if (down) return CanStatus::kDown;
    if (sent.size() >= room) return CanStatus::kWait;
    sent.push_back(frame);
    return CanStatus::kOk;
  }
  [[nodiscard]] int descriptor() const override { return -1; }
  [[nodiscard]] std::uint64_t drops() const override { return lost; }
  [[nodiscard]] const char* error() const override {
    return is_open ? "the fake link is down" : "the fake bus is absent";
  }

  std::deque<ReceivedFrame> incoming;               ///< what read() will give
  std::vector<wire::CanFrame> sent;                 ///< what was written
  std::size_t room = static_cast<std::size_t>(-1);  ///< frames that can be written
  std::uint64_t lost = 0;
  int opened = 0;  ///< calls of open()
  bool present = true;
  bool down = false;
  bool is_open = false;
};

}  // namespace hal
