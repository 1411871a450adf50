// The diagnostic server on a bus: ISO-TP link and UDS server with their storage.
//
// Life: new → on_frame() with each frame off the diagnostic bus → poll() until nullopt,
// after frames, and at the latest at next_us(), or after 100 ms → the frames go to the
// bus. One thread; no heap, clock, exceptions. Memory: about 20 KiB.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "wire/isotp.hpp"
#include "wire/uds_server.hpp"

namespace wire {

class UdsConnection {
 public:
  /// References as for UdsServer.
  UdsConnection(const IsoTpSettings& link, const UdsSettings& settings,
                const GatewayStatus& gateway, std::span<const LoopStatus> loops,
                DtcStore& dtcs, UdsActions& actions)
      : link_(link, receive_, transmit_),
        server_(settings, gateway, loops, dtcs, actions) {}

  void on_frame(const CanFrame& frame, std::int64_t now_us);
  /// The next frame to send; also lets sessions end.
  [[nodiscard]] std::optional<CanFrame> poll(std::int64_t now_us);
  /// In place of poll() while the bus takes no frame: sessions end, and a response that
  /// stands still for too long.
  void wait(std::int64_t now_us);
  /// When the link has something to send although no frame came; nullopt: never.
  /// Sessions end within a poll() every 100 ms.
  [[nodiscard]] std::optional<std::int64_t> next_us() const { return link_.next_us(); }
  /// The bus was gone: drops what was going on.
  void reset() { link_.reset(); }

  [[nodiscard]] const IsoTpLink& link() const { return link_; }
  [[nodiscard]] const UdsServer& server() const { return server_; }

 private:
  void answer(std::int64_t now_us);

  std::array<std::uint8_t, kLongestIsoTpRequest> receive_{};
  std::array<std::uint8_t, kLongestIsoTpResponse> transmit_{};
  std::array<std::uint8_t, kLongestIsoTpResponse> response_{};
  IsoTpLink link_;
  UdsServer server_;
  std::uint8_t answered_ = 0;  // who the newest response is for
};

}  // namespace wire
