#include "firmware/window_copy.hpp"

#include <algorithm>

namespace firmware {

std::uint32_t WindowCopy::take(int loop, const Monitor& monitor, const Now& now,
                               std::size_t most) {
  const auto& window = monitor.window();
  most = std::min(most, u_.size());
  const std::size_t count = window.copy(std::span(u_).first(most), y_, sp_);
  header_ = {};
  if (count == 0) return 0;
  header_.loop = static_cast<std::uint8_t>(loop);
  header_.has_setpoint = ident::all_finite<float>(std::span(sp_).first(count));
  header_.samples = static_cast<std::uint32_t>(count);
  header_.period_us = static_cast<std::uint32_t>(window.period_us());
  const std::int64_t first_us =
      window.newest_us() - static_cast<std::int64_t>(count - 1) * window.period_us();
  header_.first_ms = static_cast<std::uint64_t>(
      std::max<std::int64_t>(0, (now.epoch_us - (now.us - first_us)) / 1000));
  return wire::recording_bytes(header_.samples);
}

void WindowCopy::read(std::uint32_t offset, std::span<std::uint8_t> out) const {
  constexpr std::size_t kHeader = wire::kRecordingHeaderBytes;
  constexpr std::size_t kSample = wire::kRecordingSampleBytes;
  std::array<std::uint8_t, kHeader> header;
  wire::encode_recording_header(header_, header);
  std::array<std::uint8_t, kSample> sample{};
  std::size_t encoded = header_.samples;  // the sample in `sample`; none yet
  for (std::size_t k = 0; k < out.size(); ++k) {
    const std::size_t at = offset + k;
    if (at < kHeader) {
      out[k] = header[at];
      continue;
    }
    const std::size_t index = (at - kHeader) / kSample;
    if (index >= header_.samples) {
      out[k] = 0;
      continue;
    }
    if (index != encoded) {
      wire::encode_recording_sample({u_[index], y_[index], sp_[index]}, sample);
      encoded = index;
    }
    out[k] = sample[(at - kHeader) % kSample];
  }
}

}  // namespace firmware
