// A bus in memory with the diagnostic server of a support::UdsDaemon on it.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "support/uds/daemon.hpp"
#include "wire/uds_connection.hpp"
#include "workbench/pull/uds_client.hpp"

namespace support {

class UdsBus final : public workbench::FramePort {
 public:
  explicit UdsBus(const wire::IsoTpSettings& link = {},
                  const wire::UdsSettings& settings = {})
      : connection(std::make_unique<wire::UdsConnection>(
            link, settings, daemon.gateway, daemon.loops, *daemon.dtcs, daemon)) {}

  void send(const wire::CanFrame& frame) override {
    ++sent;
    if (connected) connection->on_frame(frame, now);
  }
  std::optional<wire::CanFrame> receive(std::int64_t wait_us) override {
    while (auto frame = connection->poll(now)) {
      if (!change || change(*frame)) waiting.push_back(*frame);
    }
    if (waiting.empty()) {
      now += std::max<std::int64_t>(wait_us, 1);
      return std::nullopt;
    }
    now += 100;
    const wire::CanFrame frame = waiting.front();
    waiting.pop_front();
    return frame;
  }
  [[nodiscard]] std::int64_t now_us() const override { return now; }

  UdsDaemon daemon;
  std::unique_ptr<wire::UdsConnection> connection;
  /// Looks at a frame of the server, may change it; false: it is lost.
  std::function<bool(wire::CanFrame&)> change;
  std::deque<wire::CanFrame> waiting;  ///< what receive() will give
  bool connected = true;
  int sent = 0;
  std::int64_t now = 0;
};

}  // namespace support
