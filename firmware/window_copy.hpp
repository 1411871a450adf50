// A copy of a loop's recording window that stays as it is while it is uploaded.
//
// Life: new → take → read, any part in any order → clear. No heap; 24 KiB.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/monitored_loop.hpp"
#include "wire/recording_image.hpp"

namespace firmware {

class WindowCopy {
 public:
  /// Copies the newest `most` samples of the window; their size in bytes
  /// (wire/recording_image.hpp), 0: there are none.
  std::uint32_t take(int loop, const Monitor& monitor, const Now& now,
                     std::size_t most = Monitor::kCapacity);
  [[nodiscard]] std::uint32_t size() const {
    return header_.samples > 0 ? wire::recording_bytes(header_.samples) : 0;
  }
  /// Writes bytes `offset` …; what lies beyond the end is zero.
  void read(std::uint32_t offset, std::span<std::uint8_t> out) const;
  void clear() { header_ = {}; }

 private:
  wire::RecordingHeader header_;
  std::array<float, Monitor::kCapacity> u_;
  std::array<float, Monitor::kCapacity> y_;
  std::array<float, Monitor::kCapacity> sp_;
};

}  // namespace firmware
