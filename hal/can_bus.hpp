// A CAN bus: frames in with the time they arrived, frames out.
//
// Life: new → open → read and write, open again after kLost. Nothing blocks. One thread.
// After open() no call allocates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "wire/can_frame.hpp"

namespace hal {

struct ReceivedFrame {
  std::int64_t time_us = 0;  ///< arrival, µs since the Unix epoch
  wire::CanFrame frame;
};

enum class CanStatus : std::uint8_t {
  kOk,     ///< done
  kWait,   ///< nothing to read, or no room to send: try again later
  kDown,   ///< the link is down; what was queued is void
  kLost,   ///< the bus is gone or was never there: open() again
  kEnded,  ///< there is nothing more to come: a recording is over
};

/// Identifiers to receive: those that agree with `id` in the bits of `mask`.
struct CanFilter {
  std::uint32_t id = 0;
  bool extended = false;
  std::uint32_t mask = wire::kMaxExtendedId;
};

class CanBus {
 public:
  virtual ~CanBus() = default;

  /// Opens the bus, or closes it and opens it again: frames still queued are discarded.
  /// False when that is not possible now; error() says why.
  [[nodiscard]] virtual bool open() = 0;
  /// Fills `out` from its start, oldest frame first; `count` says how many came, with
  /// every status.
  [[nodiscard]] virtual CanStatus read(std::span<ReceivedFrame> out,
                                       std::size_t& count) = 0;
  /// Sends a frame, or leaves it to the caller with another status than kOk.
  [[nodiscard]] virtual CanStatus write(const wire::CanFrame& frame) = 0;
  /// To wait on for reading; −1 where there is none and read() has to be tried.
  [[nodiscard]] virtual int descriptor() const = 0;
  /// Frames that arrived and were lost before they could be read, since construction.
  [[nodiscard]] virtual std::uint64_t drops() const = 0;
  /// What went wrong last, one printable line.
  [[nodiscard]] virtual const char* error() const = 0;
};

}  // namespace hal
