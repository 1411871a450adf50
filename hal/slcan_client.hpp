// The other end of hal::SlcanServer: a client of the lab bus on 127.0.0.1.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "hal/can_bus.hpp"
#include "hal/descriptor.hpp"
#include "hal/message.hpp"

namespace hal {

/// The port of "slcan:PORT", by which command lines name a lab bus: 0 where none follows,
/// nothing for any other name.
[[nodiscard]] std::optional<std::uint16_t> slcan_port(std::string_view name);

class SlcanClient final : public CanBus {
 public:
  explicit SlcanClient(std::uint16_t port) : port_(port) {}

  [[nodiscard]] bool open() override;
  /// Every frame on the bus; times are not those of the bus: zero.
  [[nodiscard]] CanStatus read(std::span<ReceivedFrame> out, std::size_t& count) override;
  [[nodiscard]] CanStatus write(const wire::CanFrame& frame) override;
  [[nodiscard]] int descriptor() const override { return socket_.get(); }
  [[nodiscard]] std::uint64_t drops() const override { return 0; }
  [[nodiscard]] const char* error() const override { return error_.c_str(); }

 private:
  bool fail(const char* what);

  std::uint16_t port_;
  Descriptor socket_;
  std::array<char, 64> line_{};
  std::size_t length_ = 0;
  Message error_;
};

}  // namespace hal
