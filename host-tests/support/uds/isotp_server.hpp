// An ISO-TP link that is fed and asked frame by frame.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "wire/isotp.hpp"

namespace support {

using Bytes = std::vector<std::uint8_t>;

inline wire::CanFrame frame_of(std::uint32_t id, Bytes data) {
  wire::CanFrame frame;
  frame.id = id;
  frame.extended = id > wire::kMaxStandardId;
  frame.dlc = static_cast<std::uint8_t>(data.size());
  std::copy(data.begin(), data.end(), frame.data.begin());
  return frame;
}

inline Bytes counting(std::size_t size) {
  Bytes bytes(size);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{1});
  return bytes;
}

inline Bytes padded(Bytes data) {
  data.resize(8, 0xCC);
  return data;
}

struct IsoTpServer {
  explicit IsoTpServer(const wire::IsoTpSettings& settings = {})
      : link(settings, receive, transmit) {}

  void take(Bytes data, std::int64_t at_us = 0) { take_from(0x7E0, data, at_us); }
  void take_from(std::uint32_t from, Bytes data, std::int64_t at_us = 0) {
    link.on_frame(frame_of(from, std::move(data)), at_us);
  }
  // Data of the next frame, empty when there is none.
  Bytes next(std::int64_t at_us = 0) {
    const std::optional<wire::CanFrame> frame = link.poll(at_us);
    if (!frame) return {};
    id = frame->id;
    return {frame->data.begin(), frame->data.begin() + frame->dlc};
  }
  Bytes request() const {
    const std::optional<wire::IsoTpRequest> waiting = link.request();
    return waiting ? Bytes(waiting->data.begin(), waiting->data.end()) : Bytes{};
  }
  const wire::IsoTpCounters& counters() const { return link.counters(); }

  std::array<std::uint8_t, wire::kLongestIsoTpRequest> receive{};
  std::array<std::uint8_t, wire::kLongestIsoTpResponse> transmit{};
  wire::IsoTpLink link;
  std::uint32_t id = 0;  // of the newest frame sent
};

}  // namespace support
