// A tester: asks the diagnostic server of a gateway over ISO-TP, waits for the answer.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "wire/isotp.hpp"

namespace workbench {

/// The bus did not do what was needed, or the gateway refused: one sentence with the
/// cure.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Frames to and from a bus, and the time on it.
class FramePort {
 public:
  virtual ~FramePort() = default;
  /// Sends, waiting for room. Throws DeviceError when the bus is gone.
  virtual void send(const wire::CanFrame& frame) = 0;
  /// The next frame, waiting up to `wait_us` for it. Throws DeviceError.
  virtual std::optional<wire::CanFrame> receive(std::int64_t wait_us) = 0;
  /// µs, never backwards.
  [[nodiscard]] virtual std::int64_t now_us() const = 0;
};

/// The identifiers of a tester: those of the server, the other way round.
[[nodiscard]] wire::IsoTpSettings tester_settings(const wire::IsoTpSettings& server);

class UdsClient {
 public:
  static constexpr std::int64_t kAnswer_us = 1'000'000;   ///< P2 with the bus in between
  static constexpr std::int64_t kPending_us = 5'000'000;  ///< after NRC 78: P2*
  static constexpr std::int64_t kBusy_us = 100'000;       ///< pause after NRC 21
  static constexpr int kBusyTries = 30;
  static constexpr int kMostPending = 60;  ///< of NRC 78 in a row

  /// `port` outlives this object.
  UdsClient(FramePort& port, const wire::IsoTpSettings& server);

  /// The positive response to `request`. `tries`: how often it is sent while no answer
  /// comes; more than once only what may be repeated. Throws DeviceError.
  std::vector<std::uint8_t> ask(std::span<const std::uint8_t> request, int tries = 1);

 private:
  std::optional<std::vector<std::uint8_t>> answer(std::int64_t deadline_us);
  void pause(std::int64_t until_us);

  FramePort& port_;
  std::array<std::uint8_t, wire::kLongestIsoTpResponse> receive_{};
  std::array<std::uint8_t, wire::kLongestIsoTpRequest> transmit_{};
  wire::IsoTpLink link_;
};

}  // namespace workbench
